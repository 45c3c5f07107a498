#pragma once

#include <string>
#include <vector>

#include "sim_hw/faults/fault_config.hpp"

namespace surefoot::faults {

/// One fault worth knowing the answer to.
struct CatalogueEntry {
  std::string what;  ///< in words, e.g. "left foot: every other frame lost, 1 s"
  sim_hw::FaultConfig fault;
};

/// Every kind of fault at each kind of target that it can strike, mild and severe where that differs.
[[nodiscard]] std::vector<CatalogueEntry> catalogue();

}  // namespace surefoot::faults
