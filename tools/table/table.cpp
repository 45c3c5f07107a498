#include "tools/table/table.hpp"

#include <algorithm>

namespace surefoot::table {

Comparison compare(const Table& table, const Reference& reference) {
  Comparison sums;
  const std::vector<Load> loads = loads_of(table.grid);
  for (std::size_t cell = 0; cell < table.cells.size(); ++cell) {
    const std::optional<bool> there = reference.at(loads[cell].at_s, loads[cell].mass_kg);
    if (!there) continue;
    ++sums.printed;
    const bool here = table.cells[cell].survives;
    if (*there) ++sums.survive_printed;
    if (here && !*there) ++sums.only_survive_here;
    if (!here && *there) ++sums.only_survive_there;
  }
  return sums;
}

SymmetryCheck check_symmetry(const Table& table, double half_cycle_s) {
  SymmetryCheck check;
  const std::vector<double>& times_s = table.grid.times_s;
  for (std::size_t mass = 0; mass < table.grid.masses_kg.size(); ++mass) {
    for (std::size_t early = 0; early < times_s.size(); ++early) {
      const auto twin =
          std::ranges::find_if(times_s, [&](double time_s) { return is_same(time_s, times_s[early] + half_cycle_s); });
      if (twin == times_s.end()) continue;
      ++check.pairs;
      const auto late = static_cast<std::size_t>(twin - times_s.begin());
      const bool early_survives = table.cells[table.grid.index(early, mass)].survives;
      if (early_survives != table.cells[table.grid.index(late, mass)].survives) {
        check.breaches.push_back({table.grid.masses_kg[mass], times_s[early], times_s[late], early_survives});
      }
    }
  }
  return check;
}

}  // namespace surefoot::table
