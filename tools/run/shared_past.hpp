#pragma once

#include <cstdint>
#include <string>

#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Scenarios whose keys are equal and not empty go alike, to the last bit, until the first payload or push of either
/// begins: they differ in payloads, pushes, duration and limits alone. Empty: this one cannot be branched
/// (`sim_hw::SimulatedRobot::can_branch`).
[[nodiscard]] std::string past_key(scenario::Scenario scenario);

/// Ticks from power-up on in which nothing has happened to the robot yet, at most those of the scenario; a tick or two
/// on the safe side.
[[nodiscard]] std::int64_t undisturbed_ticks(const scenario::Scenario& scenario) noexcept;

/// The scenario without payloads and pushes.
[[nodiscard]] scenario::Scenario undisturbed(scenario::Scenario scenario);

}  // namespace surefoot::run
