#pragma once

#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Refuses configurations that no robot could have.
/// @throws std::invalid_argument naming the field, what it is, what was expected, and the remedy
void check(const SimConfig&);

}  // namespace surefoot::sim_hw
