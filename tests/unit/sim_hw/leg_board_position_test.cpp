#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "sim_hw/nodes/leg_board.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr LegVector kAngles{0.10, -0.20, 0.30, 0.40, -0.50, 0.60};
constexpr LegVector kWanted{0.11, -0.22, 0.33, 0.36, -0.45, 0.54};
constexpr LegVector kRates{0.1, 0.2, -0.3, 0.4, -0.5, 0.6};

LegVector along(double share) {
  LegVector angle;
  for (std::size_t i = 0; i < kJointsPerLeg; ++i) angle[i] = kAngles[i] + share * (kWanted[i] - kAngles[i]);
  return angle;
}

/// A board whose joints are held at `kAngles` and turn at `kRates`: 10 ms of control period, four physics steps.
class LegBoardPositionTest : public ::testing::Test {
 protected:
  LegBoardPositionTest() {
    config.command_latency_s = 0.0;
    config.control_period_s = 0.01;
    config.physics_step_s = 0.0025;
    config.watchdog_s = 0.05;
    config.drive.torque_limit_nm = 1.0e6;
  }

  LegBoard& board() {
    if (!board_) board_.emplace(Side::kLeft, config);
    return *board_;
  }

  void sync() { board().on_sync(++tick, {}, {}, {}, outbox); }

  can::CanFrame positions(const LegVector& angle_rad) {
    const LegCommand command{.mode = LegMode::kPosition, .angle_rad = angle_rad};
    return can::encode_leg_command(Side::kLeft, {.tick = tick, .counter = position_counter++}, command);
  }

  can::CanFrame torques(const LegVector& torque_nm, LegMode mode = LegMode::kTorque) {
    return can::encode_leg_command(Side::kLeft, {.tick = tick, .counter = torque_counter++}, {mode, torque_nm});
  }

  /// A tick's command, and that it was taken.
  void command(const can::CanFrame& frame) { ASSERT_EQ(board().on_command(frame, outbox), can::Rejection::kNone); }
  void aim(const LegVector& angle_rad) {
    sync();
    command(positions(angle_rad));
  }

  LegVector step() { return board().begin_step(kAngles, kRates, outbox); }

  /// kp (reference - angle) + kd (its rate - rate), by joint.
  void expect_servo(const LegVector& torque_nm, const LegVector& reference_rad, double share_per_s) {
    for (std::size_t i = 0; i < kJointsPerLeg; ++i) {
      const double rate = share_per_s * (kWanted[i] - kAngles[i]);
      EXPECT_NEAR(torque_nm[i],
                  config.drive.servo_stiffness_nm_per_rad[i] * (reference_rad[i] - kAngles[i]) +
                      config.drive.servo_damping_nm_s_per_rad[i] * (rate - kRates[i]),
                  1e-6)
          << i;
    }
  }

  /// Codes of the emergencies sent since the last call.
  std::vector<int> emergencies() {
    outbox.flush(wire);
    std::vector<int> codes;
    for (const can::CanFrame& frame : std::exchange(wire.from_robot, {})) {
      can::FrameStamp stamp;
      can::Emergency emergency;
      if (can::decode_emergency(frame, stamp, emergency) == can::Rejection::kNone) codes.push_back(emergency.code);
    }
    return codes;
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
  std::uint8_t position_counter = 7;
  std::uint8_t torque_counter = 0;

 private:
  std::optional<LegBoard> board_;
};

TEST_F(LegBoardPositionTest, GoesFromTheJointsAsTheyAreToTheAnglesWantedWithinAPeriodAndHoldsThem) {
  aim(kWanted);
  for (const double share : {0.0, 0.25, 0.5, 0.75}) expect_servo(step(), along(share), 100.0);
  for (int i = 0; i < 5; ++i) expect_servo(step(), kWanted, 0.0);
}

TEST_F(LegBoardPositionTest, GoesOnFromTheLastAnglesWantedAndNotFromTheJoints) {
  aim(kWanted);
  for (int i = 0; i < 4; ++i) (void)step();
  aim(kAngles);
  for (const double share : {1.0, 0.75, 0.5, 0.25}) expect_servo(step(), along(share), -100.0);
  expect_servo(step(), kAngles, 0.0);
}

TEST_F(LegBoardPositionTest, TurnsWhereItsReferenceIsWhenACommandComesEarly) {
  aim(kWanted);
  (void)step();
  (void)step();
  aim(kAngles);
  for (const double share : {0.5, 0.375, 0.25, 0.125}) expect_servo(step(), along(share), -50.0);
}

TEST_F(LegBoardPositionTest, BeginsAnewFromTheJointsAfterAnyOtherMode) {
  for (const LegMode between : {LegMode::kTorque, LegMode::kDamp}) {
    aim(kWanted);
    for (int i = 0; i < 6; ++i) (void)step();
    sync();
    command(torques({}, between));
    (void)step();
    aim(kWanted);
    expect_servo(step(), kAngles, 100.0);
  }
}

TEST_F(LegBoardPositionTest, AppliesAnglesAfterTheLatencyCountedInSteps) {
  config.command_latency_s = 0.005;
  aim(kWanted);
  EXPECT_EQ(step(), damped());
  EXPECT_EQ(step(), damped());
  expect_servo(step(), kAngles, 100.0);
}

TEST_F(LegBoardPositionTest, KeepsItsMotorsWithinTheirLimit) {
  config.drive.torque_limit_nm = 50.0;
  aim({1.0, -1.0, 1.0, -1.0, 1.0, -1.0});
  for (int i = 0; i < 8; ++i) (void)step();
  EXPECT_EQ(step(), (LegVector{50.0, -50.0, 50.0, -50.0, 50.0, -50.0}));
}

// 50 ms of silence at 2.5 ms: 20 steps work, the 21st damps. Afterwards the servo begins from the joints.
TEST_F(LegBoardPositionTest, DampsAfterTheWatchdogTimeAndComesBack) {
  aim(kWanted);
  (void)emergencies();
  for (int i = 0; i < 20; ++i) ASSERT_NE(step(), damped()) << i;
  EXPECT_EQ(step(), damped());
  EXPECT_EQ(emergencies(), (std::vector{0x8130}));
  aim(kWanted);
  EXPECT_EQ(emergencies(), (std::vector{0x0000}));
  expect_servo(step(), kAngles, 100.0);
}

TEST_F(LegBoardPositionTest, TakesTorquesAndAnglesOfOneTickForTwoMasters) {
  for (const bool is_position_first : {true, false}) {
    sync();
    const can::CanFrame first = is_position_first ? positions(kWanted) : torques({});
    const can::CanFrame second = is_position_first ? torques({}) : positions(kWanted);
    command(first);
    (void)step();
    (void)emergencies();
    EXPECT_EQ(board().on_command(second, outbox), can::Rejection::kRepeated);
    EXPECT_EQ(step(), damped());
    EXPECT_EQ(emergencies(), (std::vector{0x8150}));
    sync();
    EXPECT_EQ(board().on_command(positions(kWanted), outbox), can::Rejection::kUnknownIdentifier);
    EXPECT_TRUE(board().has_command()) << "in lockstep the world goes on";
    EXPECT_EQ(step(), damped());
    board().release_master();
  }
}

TEST_F(LegBoardPositionTest, KeepsItsAnglesUnderEveryFrameItMustRefuse) {
  const can::CanFrame early = positions(kWanted);
  EXPECT_EQ(board().on_command(early, outbox), can::Rejection::kLate) << "no SYNC yet";
  sync();
  const can::CanFrame good = positions(kWanted);
  command(good);
  for (int i = 0; i < 4; ++i) (void)step();
  EXPECT_EQ(board().on_command(good, outbox), can::Rejection::kRepeated);
  EXPECT_TRUE(emergencies().empty()) << "the same frame once more is harmless";
  sync();
  EXPECT_FALSE(board().has_command());
  EXPECT_EQ(board().on_command(good, outbox), can::Rejection::kLate) << "a replay";
  --position_counter;
  EXPECT_EQ(board().on_command(positions(kAngles), outbox), can::Rejection::kRepeated) << "counter did not move";
  can::CanFrame corrupt = positions(kAngles);
  corrupt.payload[9] ^= 1U;
  EXPECT_EQ(board().on_command(corrupt, outbox), can::Rejection::kWrongCrc);
  const LegCommand other{.mode = LegMode::kPosition, .angle_rad = kAngles};
  EXPECT_EQ(board().on_command(can::encode_leg_command(Side::kRight, {.tick = tick, .counter = 90}, other), outbox),
            can::Rejection::kUnknownIdentifier);
  expect_servo(step(), kWanted, 0.0);
}

TEST_F(LegBoardPositionTest, CountsTheFramesOfItsTwoCommandsApart) {
  aim(kWanted);
  sync();
  command(torques({}));
  aim(kWanted);
  EXPECT_EQ(board().lost(), 0U);
  position_counter += 3;
  aim(kWanted);
  EXPECT_EQ(board().lost(), 3U);
}

// One inertia J behind the servo: e = reference - angle obeys J e'' + kd e' + kp e = J reference''. The reference's
// rate jumps to v at 0 and back to 0 after a period T, so e(t) = v [h(t) - h(t - T)] with the impulse response
// h(t) = exp(-s t) sin(w t) / w, s = kd / 2 J, w = sqrt(kp / J - s^2).
TEST(LegBoardServo, AnswersAsTheSecondOrderSystemOfOneInertiaDoes) {
  constexpr double kInertia = 0.8;
  constexpr double kWay = 0.01;
  SimConfig config;
  config.command_latency_s = 0.0;
  config.control_period_s = 0.01;
  config.physics_step_s = 1.0e-5;
  LegBoard board(Side::kRight, config);
  FrameOutbox outbox;
  testing::Wire wire;
  LegVector angle{};
  LegVector rate{};
  LegVector wanted;
  wanted.fill(kWay);
  for (std::uint32_t tick = 0; tick < 12; ++tick) {
    board.on_sync(tick, angle, rate, {}, outbox);
    const LegCommand command{.mode = LegMode::kPosition, .angle_rad = wanted};
    const can::FrameStamp stamp{.tick = tick, .counter = static_cast<std::uint8_t>(tick)};
    ASSERT_EQ(board.on_command(can::encode_leg_command(Side::kRight, stamp, command), outbox), can::Rejection::kNone);
    outbox.flush(wire);
    for (int i = 0; i < 1000; ++i) {
      const LegVector torque = board.begin_step(angle, rate, outbox);
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        rate[joint] += torque[joint] / kInertia * config.physics_step_s;
        angle[joint] += rate[joint] * config.physics_step_s;
      }
    }
    const double time = (tick + 1) * config.control_period_s;
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double decay = config.drive.servo_damping_nm_s_per_rad[joint] / (2.0 * kInertia);
      const double ring = std::sqrt(config.drive.servo_stiffness_nm_per_rad[joint] / kInertia - decay * decay);
      const auto response = [&](double t) { return std::exp(-decay * t) * std::sin(ring * t) / ring; };
      const double error = kWay / config.control_period_s * (response(time) - response(time - config.control_period_s));
      EXPECT_NEAR(kWay - angle[joint], error, 0.005 * kWay) << "joint " << joint << " at " << time << " s";
    }
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
