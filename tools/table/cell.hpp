#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/verdict.hpp"
#include "tools/table/grid.hpp"

namespace surefoot::table {

/// Where the torso went.
enum class Direction : std::uint8_t {
  kForward,
  kBackward,
  kLeft,
  kRight,
  kDown,  ///< collapsed upright
};

[[nodiscard]] const char* name(Direction direction) noexcept;

/// How a robot fell.
struct Fall {
  Direction direction = Direction::kForward;
  double after_load_s = 0.0;
  std::optional<double> after_trigger_s;  ///< since the payload was answered; nothing where it was not
  std::string phase;                      ///< of the reflex when it lay on the floor, e.g. "settling"
};

/// What became of one experiment.
struct Cell {
  bool survives = false;  ///< the verdict is "walked": no fall, and two gait cycles after the walk resumed
  run::Outcome outcome = run::Outcome::kInterrupted;
  std::string reason;        ///< of the verdict
  std::optional<Fall> fall;  ///< where it fell
};

/// @param load_at_s  instant of the load, or of another disturbance, on the scenario's clock
[[nodiscard]] Cell cell_of(const run::Verdict& verdict, double load_at_s);

/// One cell for each load.
/// @param verdicts  as many
[[nodiscard]] std::vector<Cell> cells_of(const std::vector<Load>& loads, const std::vector<run::Verdict>& verdicts);

[[nodiscard]] std::size_t survivors(const std::vector<Cell>& cells) noexcept;

/// '+' survives, 'f' fell, 'l' a limit or too little walked, 'x' a latched fault.
[[nodiscard]] char symbol(const Cell& cell) noexcept;

}  // namespace surefoot::table
