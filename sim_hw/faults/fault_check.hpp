#pragma once

#include <optional>
#include <string>

#include "sim_hw/faults/fault_config.hpp"

namespace surefoot::sim_hw {

/// Why a fault cannot be.
struct FaultProblem {
  const char* field;      ///< member of `FaultConfig`, e.g. "target"
  std::string statement;  ///< what it is and what was expected, without the field's name
  std::string remedy;
};

/// The first impossible thing about a fault: a number out of its range, a kind that its target, signal or element
/// cannot have. Ranges of `value`: copies 1-8, delay 1-100 ticks, flipped bits 1-64, swap 0 or 1, frames a tick
/// 1-200, saturation and noise from 0.
[[nodiscard]] std::optional<FaultProblem> find_problem(const FaultConfig& fault);

}  // namespace surefoot::sim_hw
