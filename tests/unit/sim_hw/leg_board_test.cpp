#include "sim_hw/nodes/leg_board.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr LegVector kTorque{1.0, -2.0, 3.0, -4.0, 5.0, -6.0};
constexpr LegVector kRates{0.1, 0.2, -0.3, 0.4, -0.5, 0.6};

class LegBoardTest : public ::testing::Test {
 protected:
  LegBoardTest() { config.command_latency_s = 0.0; }

  LegBoard& board() {
    if (!board_) board_.emplace(Side::kLeft, config);
    return *board_;
  }

  void sync() { board().on_sync(++tick, {}, {}, {}, outbox); }

  can::CanFrame frame(const LegVector& torque_nm, LegMode mode = LegMode::kTorque) {
    return can::encode_leg_command(Side::kLeft, {.tick = tick, .counter = counter++}, {mode, torque_nm});
  }

  LegVector step() { return board().begin_step({}, kRates, outbox); }

  /// Frames sent since the last call.
  std::vector<can::CanFrame> sent() {
    outbox.flush(wire);
    return std::exchange(wire.from_robot, {});
  }

  static LegVector damped() {
    LegVector torque;
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) torque[i] = -kDampingNmSPerRad * kRates[i];
    return torque;
  }

  SimConfig config;
  FrameOutbox outbox;
  testing::Wire wire;
  std::uint32_t tick = 1000;
  std::uint8_t counter = 0;

 private:
  std::optional<LegBoard> board_;
};

TEST_F(LegBoardTest, DampsItsJointsUntilTheFirstCommand) {
  EXPECT_EQ(step(), damped());
  sync();
  EXPECT_EQ(step(), damped());
}

TEST_F(LegBoardTest, HoldsATorqueUntilTheNextOne) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(step(), kTorque);
}

TEST_F(LegBoardTest, DampsWhenToldTo) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque, LegMode::kDamp), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), damped());
}

// 1 ms of latency at 0.5 ms steps: a command of the tick that begins at step 0 works from step 2 on.
TEST_F(LegBoardTest, AppliesACommandAfterTheLatencyCountedInSteps) {
  config.command_latency_s = 1.0e-3;
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), damped());
  EXPECT_EQ(step(), damped());
  sync();
  ASSERT_EQ(board().on_command(frame({}), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), kTorque);
  EXPECT_EQ(step(), kTorque);
  EXPECT_EQ(step(), LegVector{});
}

TEST_F(LegBoardTest, CarriesSeveralCommandsOnTheirWayAtLongLatency) {
  config.command_latency_s = 5.0e-3;
  LegVector torque{};
  for (int period = 0; period < 20; ++period) {
    sync();
    torque[0] = period;
    ASSERT_EQ(board().on_command(frame(torque), outbox), can::Rejection::kNone);
    const double felt = step()[0];
    (void)step();
    if (period >= 5) {
      EXPECT_EQ(felt, period - 5);
    }
  }
}

TEST_F(LegBoardTest, KeepsItsMotorsWithinTheirLimitAndSaysSo) {
  config.drive.torque_limit_nm = 50.0;
  sync();
  ASSERT_EQ(board().on_command(frame({60.0, -60.0, 50.0, -50.0, 1.0, 0.0}), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), (LegVector{50.0, -50.0, 50.0, -50.0, 1.0, 0.0}));
  (void)sent();
  sync();
  LegSensors sensors;
  can::LegStatus status;
  can::FrameStamp stamp;
  ASSERT_EQ(can::decode_leg_state(sent().front(), stamp, sensors, status), can::Rejection::kNone);
  EXPECT_TRUE(status.torque_limited);
  EXPECT_FALSE(status.is_damping);
  EXPECT_NEAR(sensors.torque_nm[1], -50.0, 0.006);
}

// 20 ms of silence at 0.5 ms: 40 steps work, the 41st damps.
TEST_F(LegBoardTest, DampsAfterTheWatchdogTimeAndSendsOneEmergency) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  (void)sent();
  for (int i = 0; i < 40; ++i) ASSERT_EQ(step(), kTorque) << i;
  EXPECT_TRUE(sent().empty());
  for (int i = 0; i < 100; ++i) ASSERT_EQ(step(), damped());
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].identifier, can::emergency_identifier(can::Node::kLegLeft));
  can::FrameStamp stamp;
  can::Emergency emergency;
  ASSERT_EQ(can::decode_emergency(frames[0], stamp, emergency), can::Rejection::kNone);
  EXPECT_EQ(emergency.code, 0x8130);
}

TEST_F(LegBoardTest, ComesBackFromTheWatchdogWithTheNextCommand) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  for (int i = 0; i < 50; ++i) (void)step();
  (void)sent();
  sync();
  can::LegStatus status;
  LegSensors sensors;
  can::FrameStamp stamp;
  ASSERT_EQ(can::decode_leg_state(sent().front(), stamp, sensors, status), can::Rejection::kNone);
  EXPECT_TRUE(status.watchdog_expired);
  EXPECT_TRUE(status.is_damping);
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), kTorque);
  can::Emergency emergency{.code = 1};
  ASSERT_EQ(can::decode_emergency(sent().front(), stamp, emergency), can::Rejection::kNone);
  EXPECT_EQ(emergency.code, 0x0000);
}

TEST_F(LegBoardTest, ForgetsCommandsStillOnTheirWayWhenTheWatchdogExpires) {
  config.command_latency_s = 0.03;
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(step(), damped());
}

TEST_F(LegBoardTest, NeverRaisesTheWatchdogBeforeTheFirstCommand) {
  for (int i = 0; i < 200; ++i) (void)step();
  EXPECT_TRUE(sent().empty());
}

TEST_F(LegBoardTest, KeepsItsTorqueUnderEveryFrameItMustRefuse) {
  EXPECT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kLate) << "no SYNC yet";
  sync();
  const can::CanFrame good = frame(kTorque);
  ASSERT_EQ(board().on_command(good, outbox), can::Rejection::kNone);
  (void)step();
  EXPECT_EQ(board().on_command(good, outbox), can::Rejection::kRepeated);

  sync();
  EXPECT_EQ(board().on_command(good, outbox), can::Rejection::kLate) << "a replay";
  can::CanFrame corrupt = frame({});
  for (std::size_t byte = 0; byte < corrupt.length; ++byte) {
    for (int bit = 0; bit < 8; ++bit) {
      can::CanFrame flipped = corrupt;
      flipped.payload[byte] = static_cast<std::uint8_t>(flipped.payload[byte] ^ (1 << bit));
      EXPECT_EQ(board().on_command(flipped, outbox), can::Rejection::kWrongCrc);
    }
  }
  corrupt.length = 16;
  EXPECT_EQ(board().on_command(corrupt, outbox), can::Rejection::kWrongLength);
  EXPECT_EQ(board().on_command(can::encode_leg_command(Side::kRight, {.tick = tick, .counter = 9}, {}), outbox),
            can::Rejection::kUnknownIdentifier);
  EXPECT_EQ(step(), kTorque);
  EXPECT_FALSE(board().has_command());
}

TEST_F(LegBoardTest, TakesTheSameCommandOnceMoreForARepeat) {
  sync();
  const can::CanFrame good = frame(kTorque);
  ASSERT_EQ(board().on_command(good, outbox), can::Rejection::kNone);
  (void)sent();
  EXPECT_EQ(board().on_command(good, outbox), can::Rejection::kRepeated);
  EXPECT_EQ(step(), kTorque);
  EXPECT_TRUE(sent().empty());
}

// Neither the first nor the second, nor what one of them sends later: whom to obey?
TEST_F(LegBoardTest, ObeysNobodyOnceItHasHeardTwoMastersInOneTick) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  (void)step();
  (void)sent();
  EXPECT_EQ(board().on_command(frame({}), outbox), can::Rejection::kRepeated);
  EXPECT_EQ(step(), damped());
  const auto frames = sent();
  ASSERT_EQ(frames.size(), 1U);
  can::FrameStamp stamp;
  can::Emergency emergency;
  ASSERT_EQ(can::decode_emergency(frames[0], stamp, emergency), can::Rejection::kNone);
  EXPECT_EQ(emergency.code, 0x8150);

  for (int tick_after = 0; tick_after < 30; ++tick_after) {
    sync();
    EXPECT_NE(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
    EXPECT_TRUE(board().has_command()) << "in lockstep the world goes on";
    EXPECT_EQ(step(), damped());
    EXPECT_EQ(step(), damped());
  }
  for (const can::CanFrame& out : sent()) {
    EXPECT_NE(out.identifier, can::emergency_identifier(can::Node::kLegLeft)) << "said once; and nobody is silent";
  }
}

TEST_F(LegBoardTest, DropsWhatIsOnItsWayWhenItHearsTwoMasters) {
  config.command_latency_s = 5.0e-3;
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  (void)board().on_command(frame({}), outbox);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(step(), damped());
}

TEST_F(LegBoardTest, ObeysANewMasterAfterTheTwoAreGone) {
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  (void)board().on_command(frame({}), outbox);
  board().release_master();
  EXPECT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kLate) << "it has not sent SYNC yet";
  EXPECT_EQ(step(), damped());
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  EXPECT_EQ(step(), kTorque);
}

TEST_F(LegBoardTest, BeginsAnewWhenItsPowerComesBack) {
  config.command_latency_s = 5.0e-3;
  sync();
  ASSERT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kNone);
  (void)sent();
  board().restart(outbox);
  const auto boot_up = sent();
  ASSERT_EQ(boot_up.size(), 1U);
  can::FrameStamp stamp;
  can::Heartbeat heartbeat;
  ASSERT_EQ(can::decode_heartbeat(boot_up[0], stamp, heartbeat), can::Rejection::kNone);
  EXPECT_EQ(heartbeat.state, can::NodeState::kBootUp);
  EXPECT_EQ(board().on_command(frame(kTorque), outbox), can::Rejection::kLate) << "no SYNC since";
  for (int i = 0; i < 100; ++i) ASSERT_EQ(step(), damped()) << "what was on its way is forgotten";
  EXPECT_TRUE(sent().empty()) << "no watchdog before the first command";
  sync();
  LegSensors sensors;
  can::LegStatus status;
  ASSERT_EQ(can::decode_leg_state(sent().front(), stamp, sensors, status), can::Rejection::kNone);
  EXPECT_EQ(stamp.counter, 0);
}

TEST_F(LegBoardTest, QuantisesItsEncodersToTheirResolution) {
  config.sensor.encoder_resolution_rad = 1.0e-3;
  board().on_sync(1, {0.0104, 0.0106, -0.0104, -0.0106, 0.0, 1.0}, {}, {}, outbox);
  LegSensors sensors;
  can::LegStatus status;
  can::FrameStamp stamp;
  ASSERT_EQ(can::decode_leg_state(sent().front(), stamp, sensors, status), can::Rejection::kNone);
  constexpr LegVector kExpected{0.010, 0.011, -0.010, -0.011, 0.0, 1.0};
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) EXPECT_NEAR(sensors.angle_rad[i], kExpected[i], 1e-6);
}

TEST_F(LegBoardTest, SendsItsHeartbeatOnceInAHundredTicks) {
  int heartbeats = 0;
  for (int i = 0; i < 300; ++i) {
    sync();
    for (const can::CanFrame& out : sent()) {
      if (out.identifier == can::heartbeat_identifier(can::Node::kLegLeft)) ++heartbeats;
    }
  }
  EXPECT_EQ(heartbeats, 3);
}

TEST(NoiseSource, HasTheMeanAndDeviationItWasAskedFor) {
  NoiseSource noise(7, 1);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kSamples = 100000;
  for (int i = 0; i < kSamples; ++i) {
    const double value = noise.sample(2.0);
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kSamples, 0.0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / kSamples), 2.0, 0.02);
}

TEST(NoiseSource, RepeatsItselfBySeedAndDiffersByStream) {
  NoiseSource one(7, 1);
  NoiseSource same(7, 1);
  NoiseSource other_stream(7, 2);
  NoiseSource other_seed(8, 1);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(same.sample(0.0), 0.0);  // draws nothing: the two stay together
    const double value = one.sample(1.0);
    EXPECT_EQ(value, same.sample(1.0));
    EXPECT_NE(value, other_stream.sample(1.0));
    EXPECT_NE(value, other_seed.sample(1.0));
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
