#pragma once

#include <cstdint>

#include "firmware/core/decision/tick_time.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Time zero on a whole tick, and the number of ticks until the scenario's end.
struct Schedule {
  std::int64_t zero_tick = 0;
  std::int64_t ticks = 0;
};

[[nodiscard]] inline Schedule schedule_of(const scenario::Scenario& scenario) noexcept {
  const ControllerConfig& firmware = scenario.firmware;
  const double zero_s = time_zero_s(firmware);
  const std::int64_t zero_tick = decision::first_tick_at(zero_s, firmware.period_s);
  return {zero_tick, zero_tick + decision::first_tick_at(scenario.duration_s, firmware.period_s)};
}

/// The scenario with its time zero set: what simulator and judge need.
[[nodiscard]] inline scenario::Scenario scheduled(scenario::Scenario scenario) noexcept {
  scenario.sim.time_zero_s = static_cast<double>(schedule_of(scenario).zero_tick) * scenario.firmware.period_s;
  return scenario;
}

}  // namespace surefoot::run
