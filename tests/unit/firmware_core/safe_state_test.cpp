#include "firmware/core/safety/safe_state.hpp"

#include <gtest/gtest.h>

#include <array>

namespace surefoot::safety {
namespace {

constexpr std::array kStates{SafeState::kNone, SafeState::kStanceHold, SafeState::kDamp};

TEST(SafeState, KeepsTheFirstFaultsNumberAndTheWorstStateInAnyOrder) {
  for (const SafeState first : kStates) {
    for (const SafeState next : kStates) {
      const Finding both = followed_by({Fault::kLoopOverrun, first}, {Fault::kSensorSilent, next});
      EXPECT_EQ(both.fault, Fault::kLoopOverrun);
      EXPECT_EQ(both.needs, first > next ? first : next);
    }
  }
}

TEST(SafeState, IsNotChangedByATickWithoutAFinding) {
  const Finding found{Fault::kSensorImplausible, SafeState::kStanceHold};
  for (const Finding both : {followed_by(found, {}), followed_by({}, found)}) {
    EXPECT_EQ(both.fault, found.fault);
    EXPECT_EQ(both.needs, found.needs);
  }
  EXPECT_EQ(followed_by({}, {}).fault, Fault::kNone);
}

TEST(SafeState, OfAFaultHoldsTheStanceOnlyWhileTheLegsObey) {
  EXPECT_EQ(finding_of(Fault::kNone).needs, SafeState::kNone);
  for (const Fault fault : {Fault::kSecondMaster, Fault::kLoopOverrun}) {
    EXPECT_EQ(finding_of(fault).fault, fault);
    EXPECT_EQ(finding_of(fault).needs, SafeState::kStanceHold) << name(fault);
  }
  for (const Fault fault : {Fault::kTorqueNotFinite, Fault::kJointOutOfRange, Fault::kJointOverspeed,
                            Fault::kBoardDamping, Fault::kSensorSilent, Fault::kSensorImplausible}) {
    EXPECT_EQ(finding_of(fault).fault, fault);
    EXPECT_EQ(finding_of(fault).needs, SafeState::kDamp) << name(fault);
  }
}

TEST(SafeState, OfANodesFaultDampsForALegBoardOnly) {
  for (const Fault fault : {Fault::kSensorSilent, Fault::kSensorImplausible, Fault::kForeignVersion}) {
    EXPECT_EQ(finding_of_node(fault, true).needs, SafeState::kDamp);
    EXPECT_EQ(finding_of_node(fault, false).needs, SafeState::kStanceHold);
    EXPECT_EQ(finding_of_node(fault, false).fault, fault);
  }
}

TEST(SafeState, HasItsOwnName) {
  EXPECT_STREQ(name(SafeState::kNone), "none");
  EXPECT_STREQ(name(SafeState::kStanceHold), "stance_hold");
  EXPECT_STREQ(name(SafeState::kDamp), "damp");
  EXPECT_STREQ(name(static_cast<SafeState>(99)), "unknown");
}

TEST(Fault, HasANameOfItsOwnForEachNumber) {
  const std::array expected{
      "none",          "sensor_silent", "torque_not_finite", "joint_out_of_range", "joint_overspeed",
      "board_damping", "second_master", "loop_overrun",      "sensor_implausible", "foreign_version"};
  for (std::size_t number = 0; number < expected.size(); ++number) {
    EXPECT_STREQ(name(static_cast<Fault>(number)), expected[number]);
  }
  EXPECT_STREQ(name(static_cast<Fault>(expected.size())), "unknown");
}

}  // namespace
}  // namespace surefoot::safety
