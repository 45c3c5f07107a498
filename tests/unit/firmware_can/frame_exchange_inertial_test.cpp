#include <gtest/gtest.h>

#include "tests/unit/firmware_can/frame_exchange_fixture.hpp"

namespace surefoot::can {
namespace {

/// A robot whose legs and feet answer SYNC twice.
struct FrameExchangeInertialTest : testing::FrameExchangeTest {
  std::array<std::uint8_t, 4> counter{};

  CanFrame leg(Side side, std::uint32_t tick) {
    const LegInertialSensors sensors{.hip_roll_rate_rad_s = side == Side::kRight ? 0.5 : -0.5, .freshness = {}};
    return encode_leg_inertial(side, {.tick = tick, .counter = counter[index(side)]++}, sensors);
  }
  CanFrame foot(Side side, std::uint32_t tick) {
    const FootInertialSensors sensors{.roll_rad = side == Side::kRight ? 0.01 : -0.01,
                                      .pitch_rad = 0.02,
                                      .specific_force_x_foot_m_s2 = 1.5,
                                      .specific_force_y_foot_m_s2 = -2.5,
                                      .freshness = {}};
    return encode_foot_inertial(side, {.tick = tick, .counter = counter[2 + index(side)]++}, sensors);
  }
  std::vector<CanFrame> inertial(std::uint32_t tick) {
    return {leg(Side::kRight, tick), leg(Side::kLeft, tick), foot(Side::kRight, tick), foot(Side::kLeft, tick)};
  }
  std::vector<CanFrame> everything(std::uint32_t tick) {
    std::vector<CanFrame> frames = robot.answer(tick);
    for (const CanFrame& frame : inertial(tick)) frames.push_back(frame);
    return frames;
  }
  /// Before tick 0.
  void announce(std::initializer_list<Node> nodes) {
    for (const Node node : nodes) bus.incoming.push_back(encode_heartbeat(node, {}, {.has_inertial_sensors = true}));
    exchange.listen(bus);
  }
};

constexpr auto kWithSensors = {Node::kLegRight, Node::kLegLeft, Node::kFootRight, Node::kFootLeft};

TEST_F(FrameExchangeInertialTest, PutsEachValueInItsPlace) {
  const SensorSnapshot& snapshot = run_tick(9, everything(9));
  EXPECT_NEAR(snapshot.leg_inertial[index(Side::kRight)].hip_roll_rate_rad_s, 0.5, 1e-9);
  EXPECT_NEAR(snapshot.leg_inertial[index(Side::kLeft)].hip_roll_rate_rad_s, -0.5, 1e-9);
  EXPECT_NEAR(snapshot.foot_inertial[index(Side::kRight)].roll_rad, 0.01, 1e-9);
  EXPECT_NEAR(snapshot.foot_inertial[index(Side::kLeft)].roll_rad, -0.01, 1e-9);
  EXPECT_NEAR(snapshot.foot_inertial[0].pitch_rad, 0.02, 1e-9);
  EXPECT_NEAR(snapshot.foot_inertial[0].specific_force_x_foot_m_s2, 1.5, 1e-9);
  EXPECT_NEAR(snapshot.foot_inertial[0].specific_force_y_foot_m_s2, -2.5, 1e-9);
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_TRUE(snapshot.leg_inertial[side].freshness.is_fresh());
    EXPECT_TRUE(snapshot.foot_inertial[side].freshness.is_fresh());
  }
  EXPECT_EQ(exchange.counters().received, 9U);
  EXPECT_EQ(rejected(), 0U);
}

TEST_F(FrameExchangeInertialTest, NeverWaitsForARobotWithoutThemNorTakesThemForHeard) {
  for (std::uint32_t tick = 0; tick < 5; ++tick) {
    exchange.begin_tick(bus, tick);
    bus.incoming = robot.answer(tick);
    EXPECT_TRUE(exchange.collect(bus));
    const SensorSnapshot& snapshot = exchange.finish_collecting();
    EXPECT_FALSE(snapshot.leg_inertial[0].freshness.was_heard());
    EXPECT_FALSE(snapshot.foot_inertial[1].freshness.was_heard());
  }
}

TEST_F(FrameExchangeInertialTest, WaitsFromTheFirstTickOnForEachNodeWhoseHeartbeatSpokeOfThem) {
  announce(kWithSensors);
  exchange.begin_tick(bus, 0);
  bus.incoming = robot.answer(0);
  EXPECT_FALSE(exchange.collect(bus));
  for (const CanFrame& frame : inertial(0)) {
    EXPECT_FALSE(exchange.collect(bus)) << frame.identifier;
    bus.incoming = {frame};
  }
  EXPECT_TRUE(exchange.collect(bus));
  exchange.begin_tick(bus, 1);
  bus.incoming = inertial(1);
  EXPECT_FALSE(exchange.collect(bus)) << "nor do they stand for the states";
}

TEST_F(FrameExchangeInertialTest, WaitsForANodeThatHasSentThemWithoutAnnouncingThem) {
  std::vector<CanFrame> incoming = robot.answer(0);
  incoming.push_back(foot(Side::kLeft, 0));
  static_cast<void>(run_tick(0, incoming));
  exchange.begin_tick(bus, 1);
  bus.incoming = robot.answer(1);
  EXPECT_FALSE(exchange.collect(bus));
  bus.incoming = {foot(Side::kLeft, 1)};
  EXPECT_TRUE(exchange.collect(bus)) << "and for nobody else";
}

TEST_F(FrameExchangeInertialTest, DoesNotWaitForAFrameThatItRefuses) {
  std::vector<CanFrame> incoming = robot.answer(100);
  incoming.push_back(leg(Side::kRight, 3));  // an old one, played back
  static_cast<void>(run_tick(100, incoming));
  EXPECT_EQ(rejected(Rejection::kLate), 1U);
  exchange.begin_tick(bus, 101);
  bus.incoming = robot.answer(101);
  EXPECT_TRUE(exchange.collect(bus));
}

TEST_F(FrameExchangeInertialTest, CeasesToWaitForANodeThatStartsAnewWithoutThem) {
  announce({Node::kFootRight});
  std::vector<CanFrame> incoming = robot.answer(0);
  incoming.push_back(encode_heartbeat(Node::kFootRight, {.tick = 0, .counter = 1}, {.state = NodeState::kOperational}));
  exchange.begin_tick(bus, 0);
  bus.incoming = incoming;
  EXPECT_FALSE(exchange.collect(bus)) << "a heartbeat alone takes nothing back";
  bus.incoming = {encode_heartbeat(Node::kFootRight, {.tick = 0, .counter = 0}, {.state = NodeState::kBootUp})};
  EXPECT_TRUE(exchange.collect(bus));
}

TEST_F(FrameExchangeInertialTest, KeepsAndAgesTheValuesOfASensorThatFellSilentAndRenewsThem) {
  static_cast<void>(run_tick(1, everything(1)));
  for (std::uint32_t tick = 2; tick <= 4; ++tick) {
    std::vector<CanFrame> answer = everything(tick);
    answer.erase(answer.begin() + 5);  // the right hip
    const SensorSnapshot& snapshot = run_tick(tick, answer);
    EXPECT_EQ(snapshot.leg_inertial[index(Side::kRight)].freshness.age_ticks, tick - 1);
    EXPECT_NEAR(snapshot.leg_inertial[index(Side::kRight)].hip_roll_rate_rad_s, 0.5, 1e-9);
    EXPECT_TRUE(snapshot.leg_inertial[index(Side::kLeft)].freshness.is_fresh());
    EXPECT_TRUE(snapshot.leg[index(Side::kRight)].freshness.is_fresh()) << "the board itself has answered";
  }
  EXPECT_TRUE(run_tick(5, everything(5)).leg_inertial[index(Side::kRight)].freshness.is_fresh());
  EXPECT_EQ(exchange.counters().lost, 3U);
}

TEST_F(FrameExchangeInertialTest, AgesAnnouncedSensorsThatNeverSpeakFromTheFirstTickOnAndNoOthers) {
  announce({Node::kLegLeft, Node::kFootRight});
  for (std::uint32_t tick = 0; tick < 15; ++tick) {
    const SensorSnapshot& snapshot = run_tick(tick, robot.answer(tick));
    EXPECT_EQ(snapshot.leg_inertial[index(Side::kLeft)].freshness.age_ticks, tick + 1);
    EXPECT_EQ(snapshot.foot_inertial[index(Side::kRight)].freshness.age_ticks, tick + 1);
    EXPECT_FALSE(snapshot.leg_inertial[index(Side::kRight)].freshness.was_heard());
    EXPECT_FALSE(snapshot.foot_inertial[index(Side::kLeft)].freshness.was_heard());
  }
}

TEST_F(FrameExchangeInertialTest, TakesALaterAnnouncementForNoSignOfLife) {
  static_cast<void>(run_tick(1, everything(1)));
  std::vector<CanFrame> answer = robot.answer(2);
  answer.push_back(encode_heartbeat(Node::kFootLeft, {.tick = 2}, {.has_inertial_sensors = true}));
  EXPECT_EQ(run_tick(2, answer).foot_inertial[index(Side::kLeft)].freshness.age_ticks, 1U);
}

TEST_F(FrameExchangeInertialTest, DropsWhatIsStaleRepeatedDamagedOrBeforeTheLoop) {
  bus.incoming = inertial(0);
  exchange.listen(bus);
  EXPECT_EQ(rejected(Rejection::kLate), 4U);
  static_cast<void>(run_tick(1, everything(1)));
  CanFrame damaged = foot(Side::kRight, 2);
  damaged.payload[9] ^= 4U;
  CanFrame cut = foot(Side::kRight, 2);
  cut.length = 12;
  const CanFrame good = foot(Side::kLeft, 2);
  const SensorSnapshot& snapshot = run_tick(2, {damaged, cut, good, good, leg(Side::kRight, 1), leg(Side::kLeft, 3)});
  EXPECT_EQ(rejected(Rejection::kWrongCrc), 1U);
  EXPECT_EQ(rejected(Rejection::kWrongLength), 1U);
  EXPECT_EQ(rejected(Rejection::kRepeated), 1U);
  EXPECT_EQ(rejected(Rejection::kLate), 6U);
  EXPECT_EQ(snapshot.foot_inertial[index(Side::kRight)].freshness.age_ticks, 1U);
  EXPECT_EQ(snapshot.leg_inertial[index(Side::kLeft)].freshness.age_ticks, 1U);
  EXPECT_TRUE(snapshot.foot_inertial[index(Side::kLeft)].freshness.is_fresh());
}

TEST_F(FrameExchangeInertialTest, RefusesThemFromTheTorsoAndFromNobody) {
  CanFrame torso = leg(Side::kRight, 1);
  torso.identifier = 0x285;
  CanFrame nobody = torso;
  nobody.identifier = 0x280;
  static_cast<void>(run_tick(1, {torso, nobody}));
  EXPECT_EQ(rejected(Rejection::kUnknownIdentifier), 2U);
}

}  // namespace
}  // namespace surefoot::can
