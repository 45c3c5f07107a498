#include "tools/table/grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace surefoot::table {
namespace {

constexpr std::size_t kMostValues = 10'000;
constexpr std::size_t kMostLoads = 1'000'000;

double parse_number(std::string_view text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || rest != text.data() + text.size() || !std::isfinite(value)) {
    throw BadList(fmt::format("\"{}\" is no number", text));
  }
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

void add_range(const std::vector<std::string_view>& parts, std::vector<double>& values) {
  const double first = parse_number(parts[0]);
  const double last = parse_number(parts[1]);
  const double step = parse_number(parts[2]);
  if (step <= 0.0) throw BadList(fmt::format("the step {} is not positive", step));
  if (last < first) throw BadList(fmt::format("{} is below {}", last, first));
  const double count = std::floor((last - first) / step + 1e-6) + 1.0;
  if (count > static_cast<double>(kMostValues)) throw BadList(fmt::format("more than {} values", kMostValues));
  for (double i = 0.0; i < count; i += 1.0) values.push_back(std::round((first + i * step) * 1e9) / 1e9);
}

}  // namespace

std::vector<double> parse_list(const std::string& text) {
  std::vector<double> values;
  for (const std::string_view item : split(text, ',')) {
    const std::vector<std::string_view> parts = split(item, ':');
    if (parts.size() == 1) {
      values.push_back(parse_number(item));
    } else if (parts.size() == 3) {
      add_range(parts, values);
    } else {
      throw BadList(fmt::format("\"{}\" is neither a number nor FIRST:LAST:STEP", item));
    }
    if (values.size() > kMostValues) throw BadList(fmt::format("more than {} values", kMostValues));
  }
  std::ranges::sort(values);
  const auto repeated = std::ranges::unique(values, is_same);
  values.erase(repeated.begin(), repeated.end());
  return values;
}

Bounds parse_bounds(const std::string& text) {
  const std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() != 2) throw BadList(fmt::format("\"{}\" is not LOW:HIGH", text));
  const Bounds bounds{parse_number(parts[0]), parse_number(parts[1])};
  if (bounds.high <= bounds.low) throw BadList(fmt::format("{} is not above {}", bounds.high, bounds.low));
  return bounds;
}

std::vector<Load> loads_of(const Grid& grid) {
  if (grid.times_s.size() * grid.masses_kg.size() > kMostLoads) {
    throw BadList(fmt::format("{} loads at {} instants are more than {} runs", grid.masses_kg.size(),
                              grid.times_s.size(), kMostLoads));
  }
  std::vector<Load> loads;
  for (const double time_s : grid.times_s) {
    for (const double mass_kg : grid.masses_kg) loads.push_back({mass_kg, time_s});
  }
  return loads;
}

Grid thesis_grid() { return {parse_list("0.1:4.8:0.1"), parse_list("2.5:15:2.5")}; }

}  // namespace surefoot::table
