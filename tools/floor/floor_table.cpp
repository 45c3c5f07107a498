#include "tools/floor/floor_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

namespace surefoot::floor {
namespace {

constexpr std::size_t kMostSeeds = 1000;

/// Number at the beginning of the text, which loses it.
bool take_number(std::string_view& text, std::uint64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end == text.data()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number <= 9007199254740991;  // 2^53 - 1, as floor.tile_seed
}

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

std::size_t runs_of(const FloorTableSpec& spec, FloorCase floor) { return has_seeds(floor) ? spec.seeds.size() : 1; }

}  // namespace

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::set<std::uint64_t> seeds;
  std::string_view rest = text;
  do {
    std::uint64_t first = 0;
    bool is_good = take_number(rest, first);
    std::uint64_t last = first;
    if (is_good && take(rest, '-')) is_good = take_number(rest, last);
    if (!is_good || last < first || last - first >= kMostSeeds || (!rest.empty() && !rest.starts_with(','))) {
      throw BadSeeds(fmt::format("\"{}\" names no seeds; expected 1-20 or 1,4,9-12, at most {}", text, kMostSeeds));
    }
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.insert(seed);
  } while (take(rest, ','));
  if (seeds.size() > kMostSeeds) throw BadSeeds(fmt::format("{} seeds; expected at most {}", seeds.size(), kMostSeeds));
  return {seeds.begin(), seeds.end()};
}

std::size_t FloorTable::falls(const std::string& set) const {
  std::size_t falls = 0;
  for (const FloorRow& row : rows) falls += row.set == set ? row.summary.falls : 0;
  return falls;
}

batch::Batch table_batch(const FloorTableSpec& spec, const batch::Batch& base) {
  batch::Batch batch = base;
  for (const std::string& set : spec.sets) {
    for (const FloorCase floor : kFloorCases) {
      for (std::size_t i = 0; i < runs_of(spec, floor); ++i) {
        batch::Trial trial{overrides_of(floor, spec.slope_under(set), spec.seeds.at(i), spec.duration_s)};
        trial.overrides.push_back("stabilizer.set=" + set);
        batch.trials.push_back(trial);
      }
    }
  }
  return batch;
}

FloorTable table_of(const FloorTableSpec& spec, const std::vector<run::Verdict>& verdicts) {
  FloorTable table{spec, {}};
  std::span<const run::Verdict> rest = verdicts;
  for (const std::string& set : spec.sets) {
    for (const FloorCase floor : kFloorCases) {
      const std::size_t runs = runs_of(spec, floor);
      table.rows.push_back({set, floor, slope_of(floor, spec.slope_under(set)), summary_of(rest.first(runs))});
      rest = rest.subspan(runs);
    }
  }
  return table;
}

const char* printed_in_paper(const std::string& set, FloorCase floor) noexcept {
  constexpr std::array kWithout{"0.8", "about 2", "about 2", "falls", ""};
  constexpr std::array kWith{"0.8", "1", "1", "2", "within 2"};
  return (set == "off" ? kWithout : kWith)[static_cast<std::size_t>(floor)];
}

}  // namespace surefoot::floor
