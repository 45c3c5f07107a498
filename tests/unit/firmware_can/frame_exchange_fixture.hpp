#pragma once

#include <gtest/gtest.h>

#include "firmware/can/frame_exchange.hpp"
#include "tests/unit/firmware_can/scripted_bus.hpp"

namespace surefoot::can::testing {

/// Five nodes in good health, one counter for each.
struct Robot {
  std::array<std::uint8_t, 5> counter{};

  CanFrame leg(Side side, std::uint32_t tick) {
    LegSensors sensors;
    sensors.angle_rad.fill(side == Side::kRight ? 0.25 : -0.25);
    return encode_leg_state(side, {.tick = tick, .counter = counter[index(side)]++}, sensors, {.is_damping = true});
  }
  CanFrame foot(Side side, std::uint32_t tick) {
    FootSensors sensors;
    sensors.corner_force_n.fill(side == Side::kRight ? 100.0 : 50.0);
    return encode_foot_force(side, {.tick = tick, .counter = counter[2 + index(side)]++}, sensors);
  }
  CanFrame imu(std::uint32_t tick) {
    ImuSensors sensors;
    sensors.specific_force_body_m_s2 = {0.0, 0.0, 9.81};
    return encode_imu({.tick = tick, .counter = counter[4]++}, sensors);
  }
  std::vector<CanFrame> answer(std::uint32_t tick) {
    return {leg(Side::kRight, tick), leg(Side::kLeft, tick), foot(Side::kRight, tick), foot(Side::kLeft, tick),
            imu(tick)};
  }
};

struct FrameExchangeTest : ::testing::Test {
  ScriptedBus bus;
  FrameExchange exchange;
  Robot robot;

  std::uint64_t rejected(Rejection cause) const {
    return exchange.counters().rejected[static_cast<std::size_t>(cause)];
  }
  std::uint64_t rejected() const {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : exchange.counters().rejected) sum += count;
    return sum;
  }
  const SensorSnapshot& run_tick(std::uint32_t tick, std::vector<CanFrame> incoming) {
    exchange.begin_tick(bus, tick);
    bus.incoming = std::move(incoming);
    static_cast<void>(exchange.collect(bus));
    return exchange.finish_collecting();
  }
};

}  // namespace surefoot::can::testing
