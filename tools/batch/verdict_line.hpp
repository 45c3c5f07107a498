#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "tools/run/verdict.hpp"

namespace surefoot::batch {

/// A finished trial as a journal keeps it.
struct FinishedTrial {
  std::size_t trial = 0;
  std::string hash;  ///< of its effective scenario
  run::Verdict verdict;
};

/// One line of JSON without line break: everything of a verdict that is the same each time, numbers to the last
/// bit. Wall time, hash of a recording and the identifiers on the bus are left out.
[[nodiscard]] std::string line_of(const FinishedTrial& finished);

/// The inverse; nothing when the line is damaged.
[[nodiscard]] std::optional<FinishedTrial> read_line(const std::string& line);

}  // namespace surefoot::batch
