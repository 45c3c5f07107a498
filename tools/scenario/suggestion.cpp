#include "tools/scenario/suggestion.hpp"

#include <algorithm>
#include <vector>

namespace surefoot::scenario {
namespace {

/// Longer names are no key of ours; keeps the cost of hostile input small.
constexpr std::size_t kLongestName = 80;

std::string_view last_part(std::string_view key) { return key.substr(key.rfind('.') + 1); }

/// Smaller is nearer.
std::size_t distance(std::string_view unknown, std::string_view candidate) {
  std::size_t nearest = edit_distance(unknown, candidate);
  if (unknown.size() >= 2 && candidate.starts_with(unknown)) nearest = std::min<std::size_t>(nearest, 1);
  const std::size_t name_only = 1 + edit_distance(last_part(unknown), last_part(candidate));
  return std::min(nearest, name_only);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<std::size_t> cost((a.size() + 1) * columns);
  const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return cost[i * columns + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replacement = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
      at(i, j) = std::min({replacement, at(i - 1, j) + 1, at(i, j - 1) + 1});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
    }
  }
  return at(a.size(), b.size());
}

std::string nearest_key(std::string_view unknown, std::span<const std::string> known) {
  if (unknown.size() > kLongestName) return {};
  const std::size_t tolerance = std::max<std::size_t>(2, last_part(unknown).size() / 3);
  std::string nearest;
  std::size_t smallest = tolerance + 1;
  for (const std::string& candidate : known) {
    const std::size_t candidate_distance = distance(unknown, candidate);
    if (candidate_distance < smallest) {
      smallest = candidate_distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace surefoot::scenario
