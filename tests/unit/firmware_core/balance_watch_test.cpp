#include "firmware/core/decision/balance_watch.hpp"

#include <gtest/gtest.h>

namespace surefoot::decision {
namespace {

constexpr double kMargin_rad_s = 0.1;

BalanceWatchState taught(double roll_rad_s, double pitch_rad_s) {
  BalanceWatchState state;
  EXPECT_FALSE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kLearning, roll_rad_s, pitch_rad_s));
  return state;
}

TEST(BalanceWatch, FiresAboveTheLargestLearnedRateOfEitherAxisAndSignPlusMargin) {
  for (const double learned : {-0.2, 0.2}) {
    BalanceWatchState state = taught(0.05, learned);
    const auto fires = [&state](double roll, double pitch) {
      return is_balance_lost(kMargin_rad_s, state, DetectorStage::kArmed, roll, pitch);
    };
    EXPECT_FALSE(fires(0.29, -0.29));
    EXPECT_TRUE(fires(0.31, 0.0));
    EXPECT_TRUE(fires(-0.31, 0.0));
    EXPECT_TRUE(fires(0.0, 0.31));
    EXPECT_TRUE(fires(0.0, -0.31));
  }
}

TEST(BalanceWatch, IsSilentUntilItHasLearnedAndWhileALoadedWalkIsLearned) {
  for (const DetectorStage stage : {DetectorStage::kWarmUp, DetectorStage::kLearning, DetectorStage::kResuming}) {
    BalanceWatchState state;
    EXPECT_FALSE(is_balance_lost(kMargin_rad_s, state, stage, 5.0, 5.0));
  }
}

TEST(BalanceWatch, LearnsTheLoadedWalkOnTopOfTheUnloadedOne) {
  BalanceWatchState state = taught(0.0, 0.2);
  EXPECT_FALSE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kResuming, 0.5, 0.0));
  EXPECT_FALSE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kResuming, 0.1, 0.0));
  EXPECT_FALSE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kArmed, 0.0, 0.59));
  EXPECT_TRUE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kArmed, 0.0, 0.61));
}

TEST(BalanceWatch, LearnsNothingOnceItIsArmed) {
  BalanceWatchState state = taught(0.0, 0.0);
  EXPECT_TRUE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kArmed, 3.0, 0.0));
  EXPECT_TRUE(is_balance_lost(kMargin_rad_s, state, DetectorStage::kArmed, 0.2, 0.0));
}

}  // namespace
}  // namespace surefoot::decision
