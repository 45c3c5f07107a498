#include "tools/table/cell.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "firmware/core/decision/reflex_phase.hpp"

namespace surefoot::table {
namespace {

/// Tilted by less than this the body has sunk rather than toppled; a fall is latched at 45 degrees.
constexpr double kLeastTopple_deg = 20.0;

Direction direction_of(const run::Verdict& verdict) noexcept {
  const std::array tilts_deg{verdict.torso_pitch_deg.max, -verdict.torso_pitch_deg.min, -verdict.torso_roll_deg.min,
                             verdict.torso_roll_deg.max};
  const auto largest = std::ranges::max_element(tilts_deg);
  if (*largest < kLeastTopple_deg) return Direction::kDown;
  return static_cast<Direction>(largest - tilts_deg.begin());
}

/// Follows the events through the reflex' own transitions.
Fall fall_of(const run::Verdict& verdict, double load_at_s) {
  Fall fall;
  fall.direction = direction_of(verdict);
  fall.after_load_s = verdict.ended_at_s - load_at_s;
  decision::ReflexPhase phase = decision::ReflexPhase::kStanding;
  for (const run::TimedEvent& event : verdict.events) {
    const std::string_view event_name = event.name;
    if (event_name == decision::name(decision::ReflexEvent::kPayloadDetected) ||
        event_name == decision::name(decision::ReflexEvent::kBalanceLost)) {
      fall.after_trigger_s = verdict.ended_at_s - event.time_s;
    }
    for (const decision::ReflexEvent moved : decision::kReflexEvents) {
      if (event_name == decision::name(moved)) phase = decision::next_phase(phase, moved).value_or(phase);
    }
  }
  const bool walks_again = phase == decision::ReflexPhase::kWalking && fall.after_trigger_s.has_value();
  fall.phase = walks_again ? "walking on" : decision::name(phase);
  return fall;
}

}  // namespace

const char* name(Direction direction) noexcept {
  constexpr std::array kNames{"forward", "backward", "left", "right", "down"};
  return kNames.at(static_cast<std::size_t>(direction));
}

Cell cell_of(const run::Verdict& verdict, double load_at_s) {
  Cell cell;
  cell.survives = verdict.outcome == run::Outcome::kWalked;
  cell.outcome = verdict.outcome;
  cell.reason = verdict.reason;
  if (verdict.outcome == run::Outcome::kFell) cell.fall = fall_of(verdict, load_at_s);
  return cell;
}

std::vector<Cell> cells_of(const std::vector<Load>& loads, const std::vector<run::Verdict>& verdicts) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < loads.size(); ++i) cells.push_back(cell_of(verdicts.at(i), loads[i].at_s));
  return cells;
}

std::size_t survivors(const std::vector<Cell>& cells) noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(cells, &Cell::survives));
}

char symbol(const Cell& cell) noexcept {
  switch (cell.outcome) {
    case run::Outcome::kWalked:
      return '+';
    case run::Outcome::kFell:
      return 'f';
    case run::Outcome::kFault:
      return 'x';
    case run::Outcome::kLimit:
    case run::Outcome::kInterrupted:
      return 'l';
  }
  return '?';
}

}  // namespace surefoot::table
