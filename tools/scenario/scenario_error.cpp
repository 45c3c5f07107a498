#include "tools/scenario/scenario_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace surefoot::scenario {
namespace {

/// Keys and values may hold anything; a terminal shall not obey it.
std::string escaped(const std::string& text) {
  std::string visible;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    visible += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02X}", byte) : std::string(1, c);
  }
  return visible;
}

std::string render(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += escaped(problem.place) + ": " + escaped(problem.statement) + "\n  remedy: " + escaped(problem.remedy);
  }
  return text;
}

}  // namespace

ScenarioError::ScenarioError(std::vector<Problem> problems)
    : std::runtime_error(render(problems)), problems_(std::move(problems)) {}

}  // namespace surefoot::scenario
