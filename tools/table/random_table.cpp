#include "tools/table/random_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace surefoot::table {
namespace {

/// The upper 53 bits as a number in [0, 1): the standard's distributions differ between libraries.
double uniform(std::mt19937_64& generator) { return static_cast<double>(generator() >> 11U) * 0x1p-53; }

double between(const Bounds& bounds, std::mt19937_64& generator) {
  return std::round((bounds.low + (bounds.high - bounds.low) * uniform(generator)) * 1e3) / 1e3;
}

}  // namespace

std::vector<Load> draw_loads(std::size_t count, std::uint64_t seed, const Bounds& masses_kg, const Bounds& times_s) {
  std::mt19937_64 generator(seed);
  std::vector<Load> loads;
  for (std::size_t i = 0; i < count; ++i) {
    const double mass_kg = between(masses_kg, generator);
    loads.push_back({mass_kg, between(times_s, generator)});
  }
  return loads;
}

std::string random_text(const RandomTable& table, const Bounds& masses_kg) {
  constexpr std::size_t kQuarters = 4;
  std::size_t survive[kQuarters] = {};
  std::size_t drawn[kQuarters] = {};
  const double width_kg = (masses_kg.high - masses_kg.low) / kQuarters;
  for (std::size_t i = 0; i < table.loads.size(); ++i) {
    const double place = std::floor((table.loads[i].mass_kg - masses_kg.low) / width_kg);
    const auto quarter = static_cast<std::size_t>(std::fmin(std::fmax(place, 0.0), kQuarters - 1.0));
    ++drawn[quarter];
    if (table.cells[i].survives) ++survive[quarter];
  }
  std::string text = fmt::format("  {} of {} random loads survive (seed {})\n", survivors(table.cells),
                                 table.cells.size(), table.seed);
  for (std::size_t quarter = 0; quarter < kQuarters; ++quarter) {
    const double from_kg = masses_kg.low + width_kg * static_cast<double>(quarter);
    text += fmt::format("    {:>5.4g} to {:<5.4g} kg: {} of {}\n", from_kg, from_kg + width_kg, survive[quarter],
                        drawn[quarter]);
  }
  return text;
}

}  // namespace surefoot::table
