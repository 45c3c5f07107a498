#pragma once

#include <algorithm>
#include <cmath>

namespace surefoot::sim_hw {

/// Nearest multiple of the resolution; a resolution of zero is an ideal sensor.
[[nodiscard]] inline double quantise(double value, double resolution) noexcept {
  return resolution > 0.0 ? std::round(value / resolution) * resolution : value;
}

/// Nearest value that a sensor of this range can tell, from -range to range.
[[nodiscard]] inline double clipped(double value, double range) noexcept { return std::clamp(value, -range, range); }

}  // namespace surefoot::sim_hw
