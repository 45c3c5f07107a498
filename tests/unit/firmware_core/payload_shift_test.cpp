#include "firmware/core/decision/payload_shift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace surefoot::decision {
namespace {

constexpr double kPeriod_s = 1.0e-3;
constexpr double kWeight_n = 549.36;  // 56 kg
constexpr double kGravity_m_s2 = 9.81;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const PayloadShiftConfig kConfig{};
const PayloadDetectorConfig kDetector{
    .warm_up_s = 0.0, .learning_s = 0.2, .margin_n = 25.0, .relearning_s = 0.2, .resume_margin_n = 25.0};

struct Walk {
  PayloadShiftConfig config = kConfig;
  PayloadShiftState state{};
  std::vector<double> offset_m{};
  std::vector<ReflexEvent> events{};

  void go(double time_s, double force_n, double zmp_m, bool answers = true) {
    const auto ticks = static_cast<int>(std::lround(time_s / kPeriod_s));
    for (int i = 0; i < ticks; ++i) {
      offset_m.push_back(
          step(config, kDetector, state,
               {.vertical_force_n = force_n, .filtered_force_n = force_n, .zmp_x_foot_m = zmp_m, .answers = answers},
               kPeriod_s));
      if (state.event) events.push_back(*state.event);
    }
  }
};

Walk learned() {
  Walk walk;
  walk.go(0.3, kWeight_n, 0.02);
  return walk;
}

// Static balance about the foot: m (l + offset) + M offset = 0.
TEST(PayloadShift, BalancesTheMomentOfTheLoad) {
  const double offset_m = balancing_offset_m(10.0, 0.2, 56.0);
  EXPECT_DOUBLE_EQ(offset_m, -2.0 / 66.0);
  EXPECT_NEAR(10.0 * (0.2 + offset_m) + 56.0 * offset_m, 0.0, 1e-12);
  EXPECT_EQ(balancing_offset_m(-1.0, 0.2, 56.0), 0.0);
  EXPECT_EQ(balancing_offset_m(10.0, 0.2, 0.0), 0.0);
  EXPECT_EQ(balancing_offset_m(kNaN, 0.2, 56.0), 0.0);
}

TEST(PayloadShift, IsExactlyZeroAsLongAsNothingIsDetected) {
  Walk walk = learned();
  walk.go(5.0, kWeight_n + 24.9, 0.07);
  EXPECT_TRUE(walk.events.empty());
  EXPECT_TRUE(std::all_of(walk.offset_m.begin(), walk.offset_m.end(), [](double x) { return x == 0.0; }));
  EXPECT_EQ(walk.state.added_mass_kg, 0.0);
  EXPECT_DOUBLE_EQ(walk.state.detector.threshold_n, kWeight_n + 25.0);
}

TEST(PayloadShift, GoesThroughItsPhasesAndEndsWhereTheZmpSays) {
  Walk walk = learned();
  const double loaded_n = kWeight_n + 10.0 * kGravity_m_s2;
  walk.go(6.0, loaded_n, 0.04);
  EXPECT_EQ(walk.events, (std::vector{ReflexEvent::kPayloadDetected, ReflexEvent::kReflexDone, ReflexEvent::kSettled,
                                      ReflexEvent::kShifted}));
  EXPECT_EQ(walk.state.phase, ReflexPhase::kWalking);
  // The weighed load's balance first, then what the ZMP is still ahead: 40 against 20 mm.
  EXPECT_NEAR(walk.state.adaptation_m, -0.02, 1e-9);
  EXPECT_NEAR(walk.offset_m.back(), -2.0 / 66.0 - 0.02, 1e-9);
  EXPECT_NEAR(walk.state.added_mass_kg, 10.0, 1e-9);
}

TEST(PayloadShift, MovesWithoutAJumpInPlaceOrSpeed) {
  Walk walk = learned();
  walk.go(6.0, kWeight_n + 150.0, 0.06);
  double before_m_s = 0.0;
  for (std::size_t i = 1; i < walk.offset_m.size(); ++i) {
    const double speed_m_s = (walk.offset_m[i] - walk.offset_m[i - 1]) / kPeriod_s;
    EXPECT_LT(std::abs(speed_m_s), 0.2) << i;
    EXPECT_LT(std::abs(speed_m_s - before_m_s), 0.003) << i;  // 3 m/s2
    before_m_s = speed_m_s;
  }
}

TEST(PayloadShift, StaysWithinItsBoundWhateverIsHung) {
  for (const double force_n : {600.0, 5e3, 1e9}) {
    for (const double zmp_m : {-10.0, 0.02, 10.0}) {
      Walk walk = learned();
      walk.go(6.0, force_n, zmp_m);
      EXPECT_TRUE(std::all_of(walk.offset_m.begin(), walk.offset_m.end(),
                              [](double x) { return std::abs(x) <= kConfig.max_offset_m; }));
    }
  }
}

// What the bound cut off the first move must not push the pelvis forward under the load.
TEST(PayloadShift, WeighsFromWhereItStoodWhenItsFirstMoveMeetsTheBound) {
  Walk walk = learned();
  walk.config.first_offset_m = 0.09;
  walk.go(2.0, kWeight_n + 49.05, 0.02);
  EXPECT_TRUE(std::all_of(walk.offset_m.begin(), walk.offset_m.end(), [](double x) { return x <= 0.0; }));
  EXPECT_NEAR(walk.offset_m.back(), -1.0 / 61.0, 1e-9);
}

TEST(PayloadShift, AnswersASecondLoadOnTopOfTheFirst) {
  Walk walk = learned();
  walk.go(6.0, kWeight_n + 49.05, 0.02);
  const double first_m = walk.offset_m.back();
  EXPECT_NEAR(first_m, -1.0 / 61.0, 1e-9);
  walk.events.clear();
  walk.go(6.0, kWeight_n + 98.1, 0.02);
  EXPECT_EQ(walk.events.size(), 4U);
  EXPECT_NEAR(walk.offset_m.back(), first_m - 1.0 / 66.0, 1e-9);
  EXPECT_NEAR(walk.state.added_mass_kg, 10.0, 1e-9);
}

TEST(PayloadShift, ReportsButStaysWhenItMustNotAnswer) {
  Walk walk = learned();
  int seen = 0;
  for (int i = 0; i < 3000; ++i) {
    walk.go(kPeriod_s, kWeight_n + 100.0, 0.06, false);
    seen += walk.state.is_payload_seen ? 1 : 0;
  }
  EXPECT_EQ(seen, 1);
  EXPECT_TRUE(walk.events.empty());
  EXPECT_EQ(walk.offset_m.back(), 0.0);
}

TEST(PayloadShift, LeavesOutWhatIsNoNumber) {
  Walk walk = learned();
  walk.go(0.1, kNaN, 0.02);
  walk.go(0.1, kWeight_n, kNaN);
  EXPECT_TRUE(walk.events.empty());
  walk.go(0.5, kWeight_n + 100.0, 0.03);
  walk.go(0.5, kNaN, kNaN);
  walk.go(5.0, kWeight_n + 100.0, 0.03);
  EXPECT_TRUE(std::isfinite(walk.offset_m.back()));
  EXPECT_NEAR(walk.state.added_mass_kg, 100.0 / kGravity_m_s2, 1e-9);
  const double before_m = walk.offset_m.back();
  EXPECT_EQ(step(kConfig, kDetector, walk.state, {}, kNaN), before_m);
  EXPECT_EQ(step(kConfig, kDetector, walk.state, {}, 0.0), before_m);
}

}  // namespace
}  // namespace surefoot::decision
