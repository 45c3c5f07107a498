#pragma once

#include <cmath>

namespace surefoot::sim_hw {

/// Nearest multiple of the resolution; a resolution of zero is an ideal sensor.
[[nodiscard]] inline double quantise(double value, double resolution) noexcept {
  return resolution > 0.0 ? std::round(value / resolution) * resolution : value;
}

}  // namespace surefoot::sim_hw
