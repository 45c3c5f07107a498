#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "sim_hw/faults/fault_check.hpp"
#include "sim_hw/faults/fault_random.hpp"
#include "sim_hw/faults/frame_fault.hpp"
#include "tests/unit/sim_hw/standing.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

/// A frame of the contract, any kind, any sender, any values.
can::CanFrame any_intact_frame(FaultRandom random, std::uint32_t i) {
  const auto number = [&](std::uint32_t what) { return random.draw(i, what, 0); };
  const auto value = [&](std::uint32_t what) { return 200.0 * FaultRandom::uniform(number(what)) - 100.0; };
  const can::FrameStamp stamp{.tick = static_cast<std::uint32_t>(number(1)),
                              .counter = static_cast<std::uint8_t>(number(2))};
  const Side side = kSides[number(3) % 2];
  LegVector six{};
  for (std::uint32_t joint = 0; joint < kJointsPerLeg; ++joint) six[joint] = value(10 + joint);
  LegSensors leg;
  leg.angle_rad = leg.rate_rad_s = leg.torque_nm = six;
  FootSensors foot;
  foot.corner_force_n = {six[0], six[1], six[2], six[3]};
  switch (number(0) % 10) {
    case 0:
      return can::encode_sync(stamp);
    case 1:
      return can::encode_leg_command(side, stamp, {.mode = LegMode::kTorque, .torque_nm = six});
    case 2:
      return can::encode_leg_state(side, stamp, leg, {});
    case 3:
      return can::encode_foot_force(side, stamp, foot);
    case 4:
      return can::encode_imu(stamp, {});
    case 5:
      return can::encode_heartbeat(can::kNodes[number(4) % can::kNodes.size()], stamp, {});
    case 6:
      return can::encode_leg_command(side, stamp, {.mode = LegMode::kPosition, .angle_rad = six});
    case 7:
      return can::encode_leg_inertial(side, stamp, {.hip_roll_rate_rad_s = six[0], .freshness = {}});
    case 8:
      return can::encode_foot_inertial(side, stamp, {.roll_rad = six[0], .pitch_rad = six[1], .freshness = {}});
    default:
      return can::encode_emergency(can::kNodes[number(4) % can::kNodes.size()], stamp, {.code = 0x8130});
  }
}

// What the CRC promises, over a hundred thousand frames: one to three bits, or an odd number of them.
TEST(CorruptedFrames, AreNeverTakenForIntactOnes) {
  const FaultRandom random(4711, 1);
  constexpr std::array<unsigned, 6> kBits{1, 2, 3, 5, 7, 15};
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    const can::CanFrame intact = any_intact_frame(random, i);
    ASSERT_TRUE(is_acceptable(intact)) << i;
    const can::CanFrame damaged = corrupted(intact, kBits[i % kBits.size()], random.draw(i, 99, 0));
    ASSERT_TRUE(damaged.identifier != intact.identifier || damaged.length != intact.length ||
                damaged.payload != intact.payload);
    ASSERT_FALSE(is_acceptable(damaged)) << i;
  }
}

// Beyond its promise the CRC lets one in 65,536 pass.
TEST(CorruptedFrames, OfManyBitsPassOnceInSixtyFiveThousandAtMost) {
  const FaultRandom random(4712, 1);
  int unnoticed = 0;
  for (std::uint32_t i = 0; i < 100'000; ++i) {
    unnoticed += is_acceptable(corrupted(any_intact_frame(random, i), 24, random.draw(i, 99, 0))) ? 1 : 0;
  }
  EXPECT_LE(unnoticed, 8);
}

RC_GTEST_PROP(SwappedFrames, ComeBackWhenSwappedTwice, (std::uint32_t i, bool is_sealed)) {
  const can::CanFrame intact = any_intact_frame(FaultRandom(1, 1), i);
  const can::CanFrame back = swapped(swapped(intact, is_sealed), is_sealed);
  RC_ASSERT(back.identifier == intact.identifier);
  RC_ASSERT(back.payload == intact.payload);
  RC_ASSERT(is_acceptable(swapped(intact, true)));
}

FaultConfig any_fault(bool has_inertial_legs) {
  FaultConfig fault;
  fault.kind = static_cast<FaultKind>(*rc::gen::inRange<std::size_t>(0, kFaultKinds));
  fault.target = static_cast<FaultTarget>(*rc::gen::inRange(0, 7));
  fault.at_s = 1e-3 * *rc::gen::inRange(-20, 60);
  fault.for_s = 1e-3 * *rc::gen::inRange(1, 60);
  fault.value = *rc::gen::element(0.0, 1.0, 3.0, 8.0);
  if (is_frame_fault(fault.kind)) fault.probability = *rc::gen::element(0.1, 0.5, 1.0);
  if (is_sensor_fault(fault.kind)) {
    fault.signal = static_cast<FaultSignal>(*rc::gen::inRange(0, has_inertial_legs ? 10 : 7));
    fault.element = static_cast<FaultElement>(*rc::gen::inRange(0, 14));
  }
  return fault;
}

SimConfig any_faulty_robot() {
  SimConfig config;
  config.seed = *rc::gen::arbitrary<std::uint32_t>();
  config.time_zero_s = 0.01;
  config.sensor.has_inertial_legs = *rc::gen::arbitrary<bool>();
  const std::size_t count = *rc::gen::inRange<std::size_t>(0, kMaxFaults + 1);
  while (config.faults.size() < count) {
    const FaultConfig fault = any_fault(config.sensor.has_inertial_legs);
    if (!find_problem(fault)) config.faults.push_back(fault);
  }
  return config;
}

/// Everything that went over the wire in 60 ticks, and where the robot was then.
struct Course {
  std::vector<can::CanFrame> frames;
  double height_m = 0.0;
  double largest_torque_nm = 0.0;
};

Course course_of(const SimConfig& config) {
  Course course;
  const PerSide<LegVector> pose = testing::stance(config.geometry);
  SimulatedRobot robot(config, pose);
  testing::Puppeteer puppeteer(robot);
  for (int i = 0; i < 60; ++i) {
    puppeteer.sync();
    puppeteer.command(testing::hold(pose, {puppeteer.leg[0].angle_rad, puppeteer.leg[1].angle_rad},
                                    {puppeteer.leg[0].rate_rad_s, puppeteer.leg[1].rate_rad_s}));
    for (const auto& leg : {puppeteer.leg[0], puppeteer.leg[1]}) {
      course.frames.push_back(can::encode_leg_state(Side::kLeft, {}, leg, {}));
    }
    for (const LegVector& torque_nm : robot.truth().torque_nm) {
      for (const double torque : torque_nm) {
        course.largest_torque_nm = std::max(course.largest_torque_nm, std::abs(torque));
      }
    }
  }
  course.height_m = robot.truth().body_position_world_m[2];
  return course;
}

RC_GTEST_PROP(FaultyRobotProperty, SurvivesAnyFaultsRepeatsItselfAndKeepsItsTorqueLimit, ()) {
  const SimConfig config = any_faulty_robot();
  const Course one = course_of(config);
  const Course two = course_of(config);
  RC_ASSERT(std::isfinite(one.height_m));
  RC_ASSERT(one.height_m == two.height_m);
  RC_ASSERT(one.largest_torque_nm <= config.drive.torque_limit_nm);
  for (std::size_t i = 0; i < one.frames.size(); ++i) RC_ASSERT(one.frames[i].payload == two.frames[i].payload);
}

// Streams are told apart by what a fault is, not by where it stands.
RC_GTEST_PROP(FaultStreams, StayTheSameWhateverStandsAroundThem, ()) {
  std::vector<FaultConfig> faults;
  for (int i = 0; i < 6; ++i) faults.push_back(any_fault(true));
  const std::size_t place = *rc::gen::inRange<std::size_t>(0, faults.size());
  const std::uint64_t stream = fault_stream(faults, place);
  FaultConfig other = any_fault(true);
  other.at_s = 1000.0;
  std::vector<FaultConfig> more = faults;
  more.insert(more.begin(), other);
  RC_ASSERT(fault_stream(more, place + 1) == stream);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    RC_ASSERT(i == place || fault_stream(faults, i) != stream);  // not even equal faults share one
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
