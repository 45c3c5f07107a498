#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/core/safety/safe_state.hpp"
#include "sim_hw/faults/fault_config.hpp"
#include "tools/faults/command_watch.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::faults {

/// What the robot does when the fault strikes.
enum class Situation : std::uint8_t {
  kStanding,  ///< 1.5 s after power-up, feet side by side
  kWalking,   ///< 2 s after time zero, nominal walk
  kReflex,    ///< in the middle of the reflex that answers 5 kg hung on at 1.2 s
};
inline constexpr std::array kSituations{Situation::kStanding, Situation::kWalking, Situation::kReflex};

[[nodiscard]] const char* name(Situation situation) noexcept;

/// What came of one fault in one situation.
struct TrialResult {
  safety::Fault fault = safety::Fault::kNone;               ///< kNone: ridden through
  safety::SafeState safe_state = safety::SafeState::kNone;  ///< at the end
  std::optional<std::int64_t> answer_ticks;                 ///< from the fault's first tick to the latched fault
  std::optional<double> fell_after_s;                       ///< from the fault's first tick; nothing: it stayed up
  double lowest_body_m = 0.0;                               ///< height of the body frame, lowest
  CommandExtremes command{};                                ///< what left the output gate
};

/// How long a trial goes on after its fault has ended (or, for one that does not end, has begun).
inline constexpr double kWatch_s = 4.0;

/// Runs the scenario in one process up to the situation, lets the fault strike at the situation's instant
/// (its own `at_s` is replaced) and watches what happens. Goes on after a latched fault, other than a run.
///
/// @throws scenario::ScenarioError
[[nodiscard]] TrialResult try_fault(scenario::Scenario scenario, Situation situation, sim_hw::FaultConfig fault);

}  // namespace surefoot::faults
