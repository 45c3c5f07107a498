#pragma once

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {

/// How far a foot lands from where the pattern has it: forward, and to the left.
struct LandingShift {
  double x_m = 0.0;
  double y_m = 0.0;
};

struct LandingShiftLimit {
  double max_x_m = 0.0;        ///< to either side
  double max_outward_m = 0.0;  ///< away from the other foot
  double max_inward_m = 0.0;   ///< towards it
};

[[nodiscard]] LandingShift clipped(const LandingShift&, const LandingShiftLimit&, Side moving) noexcept;

/// Whether the moving foot has come down and stands where its landing point was.
[[nodiscard]] bool stands_on_shift(const WalkView&) noexcept;

/// Goes `share` of the way to `target`.
void approach(LandingShift& shift, const LandingShift& target, double share) noexcept;

/// An adjustment of the landing point alone.
[[nodiscard]] Adjustment with_landing(const LandingShift&) noexcept;

}  // namespace surefoot::stabilizer
