#include <gtest/gtest.h>

#include <set>
#include <string>

#include "firmware/core/stabilizer/activation.hpp"
#include "tests/unit/firmware_core/stabilizer_moments.hpp"

namespace surefoot::stabilizer {
namespace {

/// The marks of one row: standing, shifting, lift, lower_swing, lower_double, landing.
std::string marks(Controller controller) {
  std::string row;
  StabilizerInput shifting = testing::standing();
  shifting.walk.stage = decision::WalkStage::kShifting;
  StabilizerInput landing = testing::standing();
  landing.walk.stage = decision::WalkStage::kLanding;
  for (const Side foot : kSides) {
    std::string one;
    for (const StabilizerInput& input : {testing::standing(), shifting, testing::lifting(foot, 0.2),
                                         testing::lowering(foot, 0.7), testing::landed(foot, 300.0), landing}) {
      one += is_active(controller, input.walk) ? 'x' : '.';
    }
    if (!row.empty()) {
      EXPECT_EQ(one, row) << "left and right differ";
    }
    row = one;
  }
  return row;
}

// Kim, Park, Oh 2007, Fig. 21: lift is stages 1 and 3; lower_swing and lower_double are stages 2 and 4.
TEST(Schedule, IsThePapersRowByRow) {
  EXPECT_EQ(marks(Controller::kUprightPose), "xxxxxx");
  EXPECT_EQ(marks(Controller::kLandingMomentum), "....x.");
  EXPECT_EQ(marks(Controller::kShockAbsorber), "....x.");
  EXPECT_EQ(marks(Controller::kLandingTiming), "...xx.");
  EXPECT_EQ(marks(Controller::kLandingPosition), "...xx.");
  EXPECT_EQ(marks(Controller::kVibrationReduction), "..x...");
  EXPECT_EQ(marks(Controller::kDamping), "..xx..");
  EXPECT_EQ(marks(Controller::kZmpCompensator), "..xx..");
  EXPECT_EQ(marks(Controller::kSoftLanding), "....x.");
  EXPECT_EQ(marks(Controller::kSwayAmplitude), "....x.");
  EXPECT_EQ(marks(Controller::kTorsoTilt), "....x.");
  EXPECT_EQ(marks(Controller::kTiltOver), "..x...");
  EXPECT_EQ(marks(Controller::kTiltLandingPosition), "...xx.");
}

TEST(Schedule, HasEveryControllerInItsOwnRowAndEveryNameOnce) {
  std::set<std::string> names;
  for (std::size_t row = 0; row < kControllers; ++row) {
    EXPECT_EQ(static_cast<std::size_t>(kActivation[row].controller), row);
    names.insert(name(kActivation[row].controller));
  }
  EXPECT_EQ(names.size(), kControllers);
  EXPECT_STREQ(name(Controller::kUprightPose), "upright_pose");
  EXPECT_STREQ(name(Controller::kVibrationReduction), "vibration_reduction");
  EXPECT_STREQ(name(Controller::kTiltLandingPosition), "tilt_landing_position");
  EXPECT_STREQ(name(Controller::kStepAdjustment), "step_adjustment");
  EXPECT_STREQ(name(SchedulePhase::kLowerDouble), "lower_double");
  EXPECT_STREQ(name(static_cast<Controller>(99)), "unknown");
}

TEST(Schedule, LetsContactDecideWhereTheDoubleSupportBegins) {
  StabilizerInput early = testing::lowering(Side::kLeft, 0.8);
  early.walk.has_landed = true;
  EXPECT_EQ(schedule_phase(early.walk), SchedulePhase::kLowerDouble);
  StabilizerInput late = testing::lowering(Side::kLeft, 1.0);
  late.walk.is_double_support = true;
  late.walk.is_waiting = true;
  EXPECT_EQ(schedule_phase(late.walk), SchedulePhase::kLowerSwing);
}

}  // namespace
}  // namespace surefoot::stabilizer
