#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "sim_hw/nodes/leg_board.hpp"
#include "tests/unit/sim_hw/standing.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

can::CanFrame any_frame() {
  can::CanFrame frame;
  frame.identifier = *rc::gen::oneOf(rc::gen::element<std::uint16_t>(0x080, 0x201, 0x202, 0x301, 0x302, 0x77F),
                                     rc::gen::inRange<std::uint16_t>(0, 0x800));
  frame.length = *rc::gen::element<std::uint8_t>(0, 1, 8, 16, 24, 48, 64);
  for (std::size_t i = 0; i < frame.length; ++i) frame.payload[i] = *rc::gen::arbitrary<std::uint8_t>();
  return frame;
}

RC_GTEST_PROP(LegBoardProperty, KeepsItsTorqueUnderAnyFrameItRefuses, ()) {
  SimConfig config;
  config.command_latency_s = 0.0;
  LegBoard board(Side::kRight, config);
  FrameOutbox outbox;
  const LegCommand command{LegMode::kTorque, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}};
  board.on_sync(1, {}, {}, {}, outbox);
  RC_ASSERT(board.on_command(can::encode_leg_command(Side::kRight, {.tick = 1, .counter = 0}, command), outbox) ==
            can::Rejection::kNone);
  (void)board.begin_step({}, {}, outbox);
  board.on_sync(2, {}, {}, {}, outbox);

  // A good frame with any of its bytes changed, a wrong tick, or rubbish.
  can::CanFrame frame = can::encode_leg_command(Side::kRight, {.tick = 2, .counter = 1}, {});
  switch (*rc::gen::inRange(0, 3)) {
    case 0: {
      const auto byte = *rc::gen::inRange<std::size_t>(0, frame.length);
      frame.payload[byte] = static_cast<std::uint8_t>(frame.payload[byte] ^ *rc::gen::inRange(1, 256));
      break;
    }
    case 1: {
      const auto tick = *rc::gen::suchThat(rc::gen::inRange<std::uint32_t>(0, 0x10000),
                                           [](std::uint32_t value) { return value != 2; });
      frame = can::encode_leg_command(Side::kRight, {.tick = tick, .counter = 1}, {});
      break;
    }
    default:
      frame = any_frame();
  }
  if (board.on_command(frame, outbox) != can::Rejection::kNone) {
    RC_ASSERT(board.begin_step({}, {}, outbox) == command.torque_nm);
  }
}

RC_GTEST_PROP(SimulatedRobotProperty, SurvivesAnyTraffic, ()) {
  const SimConfig config;
  SimulatedRobot robot(config, testing::stance(config.geometry));
  testing::Puppeteer puppeteer(robot);
  const auto rounds = *rc::gen::inRange(1, 30);
  for (int i = 0; i < rounds; ++i) {
    const auto strangers = *rc::gen::inRange(0, 40);
    for (int k = 0; k < strangers; ++k) puppeteer.wire.to_robot.push_back(any_frame());
    puppeteer.tick += *rc::gen::element<std::uint32_t>(0, 0, 0, 3, 0xFFFF'FFF0);
    puppeteer.sync();
    if (*rc::gen::arbitrary<bool>()) {
      const double torque = 1.0 * *rc::gen::inRange(-400, 400);
      LegVector all;
      all.fill(torque);
      puppeteer.command({all, all});
    }
  }
  RC_ASSERT(std::isfinite(robot.truth().body_position_world_m[2]));
  RC_ASSERT(std::isfinite(robot.truth().pitch_rad));
}

}  // namespace
}  // namespace surefoot::sim_hw
