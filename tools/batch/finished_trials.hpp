#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tools/run/verdict.hpp"

namespace surefoot::batch {

/// The trials of a batch that have ended so far.
class FinishedTrials {
 public:
  /// @param hashes  of each trial's scenario; empty: that trial does not belong here
  explicit FinishedTrials(std::vector<std::string> hashes) : hashes_(std::move(hashes)), verdicts_(hashes_.size()) {}

  /// Takes one line of a journal.
  ///
  /// @param place  where it stands, for messages
  /// @throws scenario::ScenarioError when it is damaged, or of another batch
  void take(const std::string& place, const std::string& line);

  [[nodiscard]] const std::vector<std::string>& hashes() const noexcept { return hashes_; }
  [[nodiscard]] bool has(std::size_t trial) const { return verdicts_.at(trial).has_value(); }

  /// Those that belong here and have not ended.
  [[nodiscard]] std::vector<std::size_t> missing() const;

  /// All of them, in order; none is missing.
  [[nodiscard]] std::vector<run::Verdict> verdicts() &&;

 private:
  std::vector<std::string> hashes_;
  std::vector<std::optional<run::Verdict>> verdicts_;
};

}  // namespace surefoot::batch
