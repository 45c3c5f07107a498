#include "firmware/core/safety/fault.hpp"

namespace surefoot::safety {

const char* name(Fault fault) noexcept {
  switch (fault) {
    case Fault::kNone:
      return "none";
    case Fault::kSensorSilent:
      return "sensor_silent";
    case Fault::kTorqueNotFinite:
      return "torque_not_finite";
    case Fault::kJointOutOfRange:
      return "joint_out_of_range";
    case Fault::kJointOverspeed:
      return "joint_overspeed";
    case Fault::kBoardDamping:
      return "board_damping";
    case Fault::kSecondMaster:
      return "second_master";
    case Fault::kLoopOverrun:
      return "loop_overrun";
    case Fault::kSensorImplausible:
      return "sensor_implausible";
    case Fault::kForeignVersion:
      return "foreign_version";
  }
  return "unknown";
}

}  // namespace surefoot::safety
