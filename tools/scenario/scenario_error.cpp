#include "tools/scenario/scenario_error.hpp"

#include <utility>

namespace surefoot::scenario {
namespace {

std::string render(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += problem.place + ": " + problem.statement + "\n  remedy: " + problem.remedy;
  }
  return text;
}

}  // namespace

ScenarioError::ScenarioError(std::vector<Problem> problems)
    : std::runtime_error(render(problems)), problems_(std::move(problems)) {}

}  // namespace surefoot::scenario
