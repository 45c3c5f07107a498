#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "sim_hw/config_check.hpp"
#include "sim_hw/faults/fault_check.hpp"

namespace surefoot::sim_hw {
namespace {

using enum FaultKind;

struct Impossible {
  const char* name;
  FaultConfig fault;
  const char* field;
};

void PrintTo(const Impossible& impossible, std::ostream* stream) { *stream << impossible.name; }

class ImpossibleFault : public ::testing::TestWithParam<Impossible> {};

TEST_P(ImpossibleFault, IsRefusedAtItsFieldWithARemedy) {
  const auto problem = find_problem(GetParam().fault);
  ASSERT_TRUE(problem);
  EXPECT_STREQ(problem->field, GetParam().field);
  EXPECT_FALSE(problem->statement.empty());
  EXPECT_FALSE(problem->remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Table, ImpossibleFault,
    ::testing::Values(
        Impossible{"drift_of_the_bus", {.kind = kDrift}, "target"},
        Impossible{"noise_of_the_controller", {.kind = kNoise, .target = FaultTarget::kController}, "target"},
        Impossible{"torso_without_a_twin", {.kind = kSwap, .target = FaultTarget::kTorso}, "target"},
        Impossible{"bus_without_a_twin", {.kind = kSwap}, "target"},
        Impossible{"babbling_bus", {.kind = kBabble}, "target"},
        Impossible{"link_of_one_node", {.kind = kLinkDown, .target = FaultTarget::kLegLeft}, "target"},
        Impossible{"dead_bus", {.kind = kDeadNode}, "target"},
        Impossible{"controller_off_the_bus", {.kind = kBusOff, .target = FaultTarget::kController}, "target"},
        Impossible{"babbling_angle",
                   {.kind = kBabble, .target = FaultTarget::kLegLeft, .signal = FaultSignal::kAngle},
                   "signal"},
        Impossible{"dropped_knee",
                   {.kind = kDrop, .target = FaultTarget::kLegLeft, .element = FaultElement::kKneePitch},
                   "element"},
        Impossible{"foot_with_a_gyro",
                   {.kind = kStuck, .target = FaultTarget::kFootLeft, .signal = FaultSignal::kGyro},
                   "signal"},
        Impossible{"torso_with_a_hip_gyro",
                   {.kind = kStuck, .target = FaultTarget::kTorso, .signal = FaultSignal::kHipGyro},
                   "signal"},
        Impossible{"leg_with_an_inclinometer",
                   {.kind = kStuck, .target = FaultTarget::kLegLeft, .signal = FaultSignal::kInclinometer},
                   "signal"},
        Impossible{"torso_with_a_foots_accelerometer",
                   {.kind = kStuck, .target = FaultTarget::kTorso, .signal = FaultSignal::kFootAccelerometer},
                   "signal"},
        Impossible{"joint_of_a_hip_gyro",
                   {.kind = kStuck,
                    .target = FaultTarget::kLegLeft,
                    .signal = FaultSignal::kHipGyro,
                    .element = FaultElement::kHipRoll},
                   "element"},
        Impossible{"leg_with_a_corner",
                   {.kind = kStuck, .target = FaultTarget::kLegLeft, .element = FaultElement::kRearLeft},
                   "element"},
        Impossible{"torso_with_a_knee",
                   {.kind = kStuck, .target = FaultTarget::kTorso, .element = FaultElement::kKneePitch},
                   "element"},
        Impossible{"half_a_tick_late", {.kind = kDelay, .value = 0.5}, "value"},
        Impossible{"delay_beyond_the_queue", {.kind = kDelay, .value = 101.0}, "value"},
        Impossible{"no_copies", {.kind = kDuplicate, .value = 0.0}, "value"},
        Impossible{"no_bits", {.kind = kCorrupt, .value = 0.0}, "value"},
        Impossible{"half_swapped", {.kind = kSwap, .target = FaultTarget::kLegLeft, .value = 2.0}, "value"},
        Impossible{"endless_babble", {.kind = kBabble, .target = FaultTarget::kLegLeft, .value = 201.0}, "value"},
        Impossible{"negative_noise", {.kind = kNoise, .target = FaultTarget::kTorso, .value = -1.0}, "value"},
        Impossible{"drift_of_nan", {.kind = kDrift, .target = FaultTarget::kTorso, .value = NAN}, "value"},
        Impossible{"time_of_nan", {.at_s = NAN}, "at_s"}, Impossible{"no_length", {.for_s = 0.0}, "for_s"},
        Impossible{"probability_above_one", {.probability = 1.5}, "probability"},
        Impossible{
            "stuck_now_and_then", {.kind = kStuck, .target = FaultTarget::kTorso, .probability = 0.5}, "probability"}),
    [](const auto& impossible) { return std::string(impossible.param.name); });

TEST(FaultCheck, EveryKindIsPossibleOnSomeTarget) {
  for (std::size_t kind = 0; kind < kFaultKinds; ++kind) {
    int possible = 0;
    for (int target = 0; target <= static_cast<int>(FaultTarget::kBus); ++target) {
      const FaultConfig fault{.kind = static_cast<FaultKind>(kind), .target = static_cast<FaultTarget>(target)};
      possible += find_problem(fault) ? 0 : 1;
    }
    EXPECT_GT(possible, 0) << kind;
  }
}

TEST(FaultCheck, SimulatorRefusesAnImpossibleFaultByItsPlace) {
  SimConfig config;
  config.faults = {{.kind = kDrop}, {.kind = kDrift}};
  try {
    check(config);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("fault[1].target has no sensors"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\n  remedy: "));
  }
  config.faults.assign(kMaxFaults + 1, {});
  EXPECT_THROW(check(config), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::sim_hw
