#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/field_table.hpp"

namespace surefoot::scenario {
namespace {

// In the order of the enumerators.
constexpr std::array kKinds{"drop",  "duplicate", "delay",     "corrupt", "swap",   "stuck",   "drift",
                            "noise", "saturate",  "dead_node", "restart", "babble", "bus_off", "link_down"};
constexpr std::array kTargets{"leg_right", "leg_left", "foot_right", "foot_left", "torso", "controller", "bus"};
constexpr std::array kSignals{"all",  "angle",         "rate",     "torque",       "force",
                              "gyro", "accelerometer", "hip_gyro", "inclinometer", "foot_accelerometer"};
constexpr std::array kElements{"all",        "hip_yaw",    "hip_roll",    "hip_pitch", "knee_pitch", "ankle_pitch",
                               "ankle_roll", "front_left", "front_right", "rear_left", "rear_right", "x",
                               "y",          "z"};
static_assert(kKinds.size() == sim_hw::kFaultKinds);

}  // namespace

std::vector<Field> fields(sim_hw::FaultConfig& fault) {
  return {choice_field("kind", fault.kind, kKinds, "what goes wrong; sim_hw/faults/fault_config.hpp says how"),
          choice_field("target", fault.target, kTargets, "node or bus at which it goes wrong"),
          choice_field("signal", fault.signal, kSignals, "measurement of a sensor fault"),
          choice_field("element", fault.element, kElements, "joint, corner or axis of a sensor fault"),
          Field{"at_s", &fault.at_s, {-3600.0, 3600.0}, "s", "begin of the fault on the scenario's clock"},
          Field{"for_s", &fault.for_s, {0.0, 3600.0, true}, "s", "length of the fault; a dead_node stays dead"},
          Field{"probability", &fault.probability, {0.0, 1.0}, "1", "probability for each frame"},
          Field{"value",
                &fault.value,
                {-1.0e6, 1.0e6},
                "1",
                "size of the fault: copies, ticks, bits, frames a tick, drift a second, deviation, limit"}};
}

}  // namespace surefoot::scenario
