#include "tools/table/table_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace surefoot::table {
namespace {

std::string head(const std::vector<double>& masses_kg) {
  std::string text;
  for (const double mass_kg : masses_kg) text += fmt::format("{:>5} ", mass_kg);
  return text;
}

char symbol_of(std::optional<bool> survives) noexcept { return !survives ? '-' : *survives ? '+' : 'f'; }

std::string breach_lines(const SymmetryCheck& check) {
  std::string text;
  for (const SymmetryBreach& breach : check.breaches) {
    const auto [survived_s, fell_s] =
        breach.early_survives ? std::pair{breach.early_s, breach.late_s} : std::pair{breach.late_s, breach.early_s};
    text += fmt::format("    {:>5} kg: survives at {} s, not at {} s\n", breach.mass_kg, survived_s, fell_s);
  }
  return text;
}

/// "forward 20, left 2", most frequent first.
std::string directions_of(const Table& table) {
  std::array<std::pair<std::size_t, Direction>, 5> counts{};
  for (std::size_t i = 0; i < counts.size(); ++i) counts.at(i).second = static_cast<Direction>(i);
  for (const Cell& cell : table.cells) {
    if (cell.fall) ++counts.at(static_cast<std::size_t>(cell.fall->direction)).first;
  }
  std::ranges::stable_sort(counts, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [count, direction] : counts) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name(direction), count);
  }
  return text;
}

}  // namespace

std::string matrix_text(const Table& table, const std::optional<Reference>& reference) {
  const Grid& grid = table.grid;
  const std::string loads = head(grid.masses_kg);
  std::string text =
      fmt::format("  load at  {:<{}}{}\n", "here, kg", loads.size(), reference ? "   " + reference->name + ", kg" : "");
  text += "          " + loads + (reference ? "   " + loads : "") + "\n";
  for (std::size_t time = 0; time < grid.times_s.size(); ++time) {
    std::string here;
    std::string there;
    for (std::size_t mass = 0; mass < grid.masses_kg.size(); ++mass) {
      const Cell& cell = table.cells[grid.index(time, mass)];
      const std::optional<bool> printed =
          reference ? reference->at(grid.times_s[time], grid.masses_kg[mass]) : std::nullopt;
      here += fmt::format("    {}{}", symbol(cell), printed && *printed != cell.survives ? '!' : ' ');
      there += fmt::format("    {} ", symbol_of(printed));
    }
    text += fmt::format("  {:>5} s {}{}\n", grid.times_s[time], here, reference ? "   " + there : "");
  }
  return text;
}

std::string summary_text(const Table& table, const std::optional<Reference>& reference, double half_cycle_s) {
  std::string text = fmt::format("  {} of {} cells survive\n", survivors(table.cells), table.cells.size());
  if (reference) {
    const Comparison sums = compare(table, *reference);
    text += fmt::format("  {}: {} of {} printed cells survive\n", reference->name, sums.survive_printed, sums.printed);
    text += fmt::format("  {} differ (!): {} survive here only, {} there only\n", sums.differing(),
                        sums.only_survive_here, sums.only_survive_there);
  }
  if (const std::string directions = directions_of(table); !directions.empty()) {
    text += "  falls: " + directions + "\n";
  }
  const auto others = std::ranges::count_if(table.cells, [](const Cell& cell) { return !cell.survives && !cell.fall; });
  if (others > 0) text += fmt::format("  no fall, but not walked on either: {} (--falls says why)\n", others);
  const SymmetryCheck check = check_symmetry(table, half_cycle_s);
  if (check.pairs > 0) {
    text += fmt::format("  half-cycle symmetry (t and t + {} s): {} of {} pairs differ\n", half_cycle_s,
                        check.breaches.size(), check.pairs);
  }
  return text + breach_lines(check);
}

std::string falls_text(const std::vector<Load>& loads, const std::vector<Cell>& cells) {
  if (survivors(cells) == cells.size()) return {};
  std::string text = "     kg     at s  outcome   after load  after trigger  direction  phase\n";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    if (cell.survives) continue;
    const std::string place =
        fmt::format("  {:>5.4g}  {:>7.4g}  {:<7}", loads[i].mass_kg, loads[i].at_s, run::name(cell.outcome));
    if (!cell.fall) {
      text += place + "   " + cell.reason + "\n";
      continue;
    }
    const std::optional<double> trigger_s = cell.fall->after_trigger_s;
    text +=
        fmt::format("{}   {:>8.3f} s  {:>11} s  {:<9}  {}\n", place, cell.fall->after_load_s,
                    trigger_s ? fmt::format("{:.3f}", *trigger_s) : "-", name(cell.fall->direction), cell.fall->phase);
  }
  return text;
}

}  // namespace surefoot::table
