#include "tools/batch/finished_trials.hpp"

#include <fmt/format.h>

#include <utility>

#include "tools/batch/verdict_line.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::batch {
namespace {

[[noreturn]] void refuse(const std::string& place, std::string statement) {
  throw scenario::ScenarioError(
      {{place, std::move(statement), "remove this file, or give another place, and begin anew"}});
}

}  // namespace

void FinishedTrials::take(const std::string& place, const std::string& line) {
  std::optional<FinishedTrial> finished = read_line(line);
  if (!finished) refuse(place, "is no line of a journal");
  if (finished->trial >= hashes_.size()) {
    refuse(place, fmt::format("belongs to another batch: it holds row {}, this batch has {} from 0 on", finished->trial,
                              hashes_.size()));
  }
  if (finished->hash != hashes_[finished->trial]) {
    refuse(place, fmt::format("belongs to another batch: row {} is another scenario", finished->trial));
  }
  verdicts_[finished->trial] = std::move(finished->verdict);
}

std::vector<std::size_t> FinishedTrials::missing() const {
  std::vector<std::size_t> missing;
  for (std::size_t trial = 0; trial < hashes_.size(); ++trial) {
    if (!hashes_[trial].empty() && !verdicts_[trial]) missing.push_back(trial);
  }
  return missing;
}

std::vector<run::Verdict> FinishedTrials::verdicts() && {
  std::vector<run::Verdict> all;
  for (std::optional<run::Verdict>& verdict : verdicts_) all.push_back(std::move(*verdict));
  return all;
}

}  // namespace surefoot::batch
