#include "firmware/core/decision/payload_detector.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/decision/tick_time.hpp"

namespace surefoot::decision {
namespace {

constexpr double kPeriod_s = 1.0e-3;
const PayloadDetectorConfig kConfig{
    .warm_up_s = 0.1, .learning_s = 0.2, .margin_n = 3.0, .relearning_s = 0.1, .resume_margin_n = 60.0};

/// Walks `ticks` ticks from `first` on with a constant force; returns how often the detector fired.
int walk(PayloadDetectorState& state, std::int64_t first, std::int64_t ticks, double force_n) {
  int fired = 0;
  for (std::int64_t k = first; k < first + ticks; ++k) fired += step(kConfig, state, force_n, k, kPeriod_s) ? 1 : 0;
  return fired;
}

PayloadDetectorState armed_at(double force_n) {
  PayloadDetectorState state;
  walk(state, 0, 301, force_n);
  return state;
}

TEST(PayloadDetector, PassesThroughItsStagesToTheTick) {
  PayloadDetectorState state;
  walk(state, 0, 100, 784.0);
  EXPECT_EQ(state.stage, DetectorStage::kWarmUp);
  walk(state, 100, 1, 784.0);
  EXPECT_EQ(state.stage, DetectorStage::kLearning);
  walk(state, 101, 199, 784.0);
  EXPECT_EQ(state.stage, DetectorStage::kLearning);
  EXPECT_EQ(state.threshold_n, 0.0);
  walk(state, 300, 1, 784.0);
  EXPECT_EQ(state.stage, DetectorStage::kArmed);
  EXPECT_DOUBLE_EQ(state.threshold_n, 787.0);
}

TEST(PayloadDetector, LearnsTheMaximumOfTheLearningTimeAndOfNothingElse) {
  PayloadDetectorState state;
  walk(state, 0, 99, 900.0);  // the start-up transient is not learnt
  walk(state, 99, 100, 780.0);
  walk(state, 199, 1, 803.0);
  walk(state, 200, 100, 780.0);
  walk(state, 300, 1, 780.0);
  EXPECT_DOUBLE_EQ(state.threshold_n, 806.0);
}

TEST(PayloadDetector, NeverFiresBeforeItIsArmedWhateverComes) {
  PayloadDetectorState state;
  EXPECT_EQ(walk(state, 0, 300, 1.0e6), 0);
}

TEST(PayloadDetector, FiresOncePerCrossing) {
  PayloadDetectorState state = armed_at(784.0);
  EXPECT_EQ(walk(state, 301, 50, 787.0), 0);  // at the threshold is not above it
  EXPECT_EQ(walk(state, 351, 50, 787.1), 1);
  EXPECT_EQ(walk(state, 401, 50, 786.0), 0);
  EXPECT_EQ(walk(state, 451, 50, 800.0), 1);
}

// After a recovery from 5 kg: 49 N heavier, threshold 787 N carried to 836 N and raised to 896 N.
PayloadDetectorState resumed_from(double force_n) {
  PayloadDetectorState state = armed_at(force_n);
  EXPECT_EQ(walk(state, 301, 1, force_n + 50.0), 1);
  rearm(kConfig, state, 49.0);
  return state;
}

TEST(PayloadDetector, IsArmedFromTheFirstStepAfterARecoveryWithARaisedThreshold) {
  PayloadDetectorState state = resumed_from(784.0);
  EXPECT_EQ(state.stage, DetectorStage::kResuming);
  EXPECT_DOUBLE_EQ(state.threshold_n, 896.0);
  EXPECT_EQ(walk(state, 0, 50, 895.9), 0) << "a hard landing of the first step is no payload";
  EXPECT_EQ(walk(state, 50, 1, 896.1), 1);
}

TEST(PayloadDetector, LearnsTheLoadedWalkAfterARecovery) {
  PayloadDetectorState state = resumed_from(784.0);
  walk(state, 0, 100, 890.0);  // the first step is not learnt
  walk(state, 100, 100, 850.0);
  EXPECT_EQ(state.stage, DetectorStage::kResuming);
  walk(state, 200, 1, 840.0);
  EXPECT_EQ(state.stage, DetectorStage::kArmed);
  EXPECT_DOUBLE_EQ(state.threshold_n, 853.0);
}

TEST(PayloadDetector, KeepsTheRelearnedThresholdBetweenTheCarriedAndTheRaisedOne) {
  PayloadDetectorState quiet = resumed_from(784.0);
  walk(quiet, 0, 201, 800.0);
  EXPECT_DOUBLE_EQ(quiet.threshold_n, 836.0);
  PayloadDetectorState rough = resumed_from(784.0);
  walk(rough, 0, 201, 895.0);
  EXPECT_DOUBLE_EQ(rough.threshold_n, 896.0);
}

TEST(PayloadDetector, CarriesFromWhatItLearnedWhenTheNextPayloadComesBeforeItHasLearnedAnew) {
  PayloadDetectorState state = resumed_from(784.0);
  EXPECT_EQ(walk(state, 0, 50, 900.0), 1);
  rearm(kConfig, state, 98.0);
  EXPECT_DOUBLE_EQ(state.carried_n, 934.0);
  EXPECT_DOUBLE_EQ(state.threshold_n, 994.0);
}

TEST(PayloadDetector, FollowsALoadThatIsTakenAway) {
  PayloadDetectorState state = resumed_from(784.0);
  rearm(kConfig, state, -49.0);
  EXPECT_DOUBLE_EQ(state.carried_n, 787.0);
}

TEST(TickTime, CountsWholeTicksHoweverTheyWereRounded) {
  EXPECT_EQ(first_tick_at(0.1, 1.0e-3), 100);
  EXPECT_EQ(first_tick_at(0.1 + 1.0e-13, 1.0e-3), 100);
  EXPECT_EQ(first_tick_at(0.1 - 1.0e-13, 1.0e-3), 100);
  EXPECT_EQ(first_tick_at(0.1 + 2.0e-9, 1.0e-3), 101);
  EXPECT_EQ(first_tick_at(0.1 + 2.0 + 0.5, 0.5e-3), 5200);
  EXPECT_EQ(first_tick_at(2.4 + 4.8, 1.0e-3), 7200);
  EXPECT_EQ(first_tick_at(0.0, 1.0e-3), 0);
}

}  // namespace
}  // namespace surefoot::decision
