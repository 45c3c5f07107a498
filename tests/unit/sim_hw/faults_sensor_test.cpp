#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim_hw/faults/sensor_faults.hpp"

namespace surefoot::sim_hw {
namespace {

using enum FaultKind;

constexpr double kPeriod_s = 1.0e-3;
constexpr LegVector kTrue{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};

/// What a leg's angles read in some tick; the fault lasts from tick 10 to 19.
class FaultyLeg {
 public:
  explicit FaultyLeg(std::vector<FaultConfig> faults, std::uint64_t seed = 1) {
    for (FaultConfig& fault : faults) {
      fault.at_s = 10 * kPeriod_s;
      fault.for_s = 10 * kPeriod_s;
    }
    sensors_ = SensorFaults(faults, FaultTarget::kLegLeft, seed, kPeriod_s);
  }

  LegVector read(int tick, LegVector values = kTrue, FaultSignal signal = FaultSignal::kAngle) {
    sensors_.begin_tick(tick * kPeriod_s, tick);
    sensors_.apply(signal, values);
    return values;
  }

 private:
  SensorFaults sensors_;
};

FaultConfig of_leg(FaultKind kind, double value, FaultSignal signal = FaultSignal::kAll,
                   FaultElement element = FaultElement::kAll) {
  return {.kind = kind, .target = FaultTarget::kLegLeft, .signal = signal, .element = element, .value = value};
}

TEST(SensorFaults, LeaveOtherTicksOtherSignalsAndOtherNodesAlone) {
  FaultyLeg leg({of_leg(kDrift, 100.0, FaultSignal::kRate),
                 {.kind = kDrift, .target = FaultTarget::kLegRight, .value = 100.0},
                 {.kind = kDrop, .target = FaultTarget::kLegLeft}});
  for (const int tick : {0, 9, 10, 15, 19, 20}) EXPECT_EQ(leg.read(tick), kTrue) << tick;
  EXPECT_EQ(leg.read(9, kTrue, FaultSignal::kRate), kTrue);
  EXPECT_NE(leg.read(19, kTrue, FaultSignal::kRate), kTrue);
  EXPECT_EQ(leg.read(20, kTrue, FaultSignal::kRate), kTrue);
}

TEST(SensorFaults, StuckRepeatsTheFirstValueOfItsTimeAndLetsGoAfterIt) {
  FaultyLeg leg({of_leg(kStuck, 1.0)});
  LegVector moving = kTrue;
  EXPECT_EQ(leg.read(10, moving), kTrue);
  moving.fill(9.0);
  EXPECT_EQ(leg.read(11, moving), kTrue);
  EXPECT_EQ(leg.read(19, moving), kTrue);
  EXPECT_EQ(leg.read(20, moving), moving);
}

// One memory for all signals would repeat the angles as rates.
TEST(SensorFaults, StuckHoldsEachSignalForItself) {
  FaultyLeg leg({of_leg(kStuck, 1.0)});
  const LegVector rates{6.0, 5.0, 4.0, 3.0, 2.0, 1.0};
  (void)leg.read(10);
  EXPECT_EQ(leg.read(10, rates, FaultSignal::kRate), rates);
  EXPECT_EQ(leg.read(11, {}, FaultSignal::kRate), rates);
  EXPECT_EQ(leg.read(11, {}), kTrue);
}

TEST(SensorFaults, BefallOnlyTheElementThatTheyName) {
  FaultyLeg leg({of_leg(kStuck, 1.0, FaultSignal::kAngle, FaultElement::kKneePitch)});
  (void)leg.read(10);
  EXPECT_EQ(leg.read(12, {}), (LegVector{0.0, 0.0, 0.0, 0.4, 0.0, 0.0}));
}

TEST(SensorFaults, ElementsOfFootAndTorsoStandInTheOrderOfTheirFrames) {
  const std::array<std::pair<FaultElement, std::size_t>, 4> corners{{{FaultElement::kFrontLeft, 0},
                                                                     {FaultElement::kFrontRight, 1},
                                                                     {FaultElement::kRearLeft, 2},
                                                                     {FaultElement::kRearRight, 3}}};
  for (const auto& [element, place] : corners) {
    const std::vector<FaultConfig> faults{
        {.kind = kSaturate, .target = FaultTarget::kFootRight, .element = element, .value = 0.0}};
    SensorFaults foot(faults, FaultTarget::kFootRight, 1, kPeriod_s);
    foot.begin_tick(1.0, 1000);
    std::array<double, 4> force{1.0, 1.0, 1.0, 1.0};
    foot.apply(FaultSignal::kForce, force);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(force[i], i == place ? 0.0 : 1.0);
  }
  const std::vector<FaultConfig> faults{{.kind = kSaturate,
                                         .target = FaultTarget::kTorso,
                                         .signal = FaultSignal::kAccelerometer,
                                         .element = FaultElement::kY,
                                         .value = 0.5}};
  SensorFaults torso(faults, FaultTarget::kTorso, 1, kPeriod_s);
  torso.begin_tick(1.0, 1000);
  std::array<double, 3> force{-9.0, -9.0, -9.0};
  torso.apply(FaultSignal::kGyro, force);
  EXPECT_EQ(force[1], -9.0);
  torso.apply(FaultSignal::kAccelerometer, force);
  EXPECT_EQ(force, (std::array<double, 3>{-9.0, -0.5, -9.0}));
}

TEST(SensorFaults, DriftGrowsWithTheTimeSinceItBegan) {
  FaultyLeg leg({of_leg(kDrift, 2.0)});
  EXPECT_EQ(leg.read(10), kTrue);
  EXPECT_NEAR(leg.read(15)[3], 0.4 + 2.0 * 5 * kPeriod_s, 1e-12);
  EXPECT_NEAR(leg.read(12)[3], 0.4 + 2.0 * 2 * kPeriod_s, 1e-12) << "a function of time, not a sum";
}

TEST(SensorFaults, SaturateClampsBothWays) {
  FaultyLeg leg({of_leg(kSaturate, 0.25)});
  EXPECT_EQ(leg.read(10, {-1.0, -0.25, -0.1, 0.1, 0.25, 1.0}), (LegVector{-0.25, -0.25, -0.1, 0.1, 0.25, 0.25}));
}

TEST(SensorFaults, NoiseHasTheDeviationItWasAskedFor) {
  std::vector<FaultConfig> faults{of_leg(kNoise, 2.0)};
  faults[0].at_s = 0.0;
  faults[0].for_s = 3600.0;
  SensorFaults sensors(faults, FaultTarget::kLegLeft, 1, kPeriod_s);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kTicks = 20000;
  for (int tick = 0; tick < kTicks; ++tick) {
    LegVector values{};
    sensors.begin_tick(tick * kPeriod_s, tick);
    sensors.apply(FaultSignal::kAngle, values);
    for (const double value : values) {
      sum += value;
      squares += value * value;
    }
  }
  EXPECT_NEAR(sum / (6 * kTicks), 0.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / (6 * kTicks)), 2.0, 0.02);
}

TEST(SensorFaults, NoiseDiffersBySeedTickSignalAndJointAndNotByWhatElseIsWrong) {
  FaultyLeg leg({of_leg(kNoise, 1.0)});
  FaultyLeg again({of_leg(kStuck, 1.0, FaultSignal::kTorque), of_leg(kNoise, 1.0)});
  FaultyLeg other_seed({of_leg(kNoise, 1.0)}, 2);
  const LegVector read = leg.read(12);
  EXPECT_EQ(read, again.read(12));
  EXPECT_NE(read, other_seed.read(12));
  EXPECT_NE(read, leg.read(13));
  EXPECT_NE(read, leg.read(12, kTrue, FaultSignal::kRate));
  LegVector off{};
  std::transform(read.begin(), read.end(), kTrue.begin(), off.begin(), std::minus<>());
  for (std::size_t i = 1; i < off.size(); ++i) EXPECT_NE(off[i], off[0]);
}

TEST(SensorFaults, TwoOfAKindAreIndependent) {
  FaultyLeg one({of_leg(kNoise, 1.0)});
  FaultyLeg two({of_leg(kNoise, 1.0), of_leg(kNoise, 1.0)});
  EXPECT_GT(std::abs((two.read(12)[0] - kTrue[0]) - 2.0 * (one.read(12)[0] - kTrue[0])), 1e-6);
}

TEST(SensorFaults, WorkOneAfterTheOther) {
  FaultyLeg leg({of_leg(kDrift, 1000.0), of_leg(kSaturate, 0.3)});
  EXPECT_EQ(leg.read(19)[0], 0.3) << "first off, then clamped";
}

}  // namespace
}  // namespace surefoot::sim_hw
