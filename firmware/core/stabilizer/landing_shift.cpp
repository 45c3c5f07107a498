#include "firmware/core/stabilizer/landing_shift.hpp"

namespace surefoot::stabilizer {

LandingShift clipped(const LandingShift& shift, const LandingShiftLimit& limit, Side moving) noexcept {
  const double outwards = lateral_sign(moving);
  const double outwards_m = std::clamp(outwards * shift.y_m, -limit.max_inward_m, limit.max_outward_m);
  return {within(shift.x_m, limit.max_x_m), outwards * outwards_m};
}

bool stands_on_shift(const WalkView& walk) noexcept {
  return decision::is_lowering(walk.stage) && (walk.is_double_support || walk.has_landed);
}

void approach(LandingShift& shift, const LandingShift& target, double share) noexcept {
  approach(shift.x_m, target.x_m, share);
  approach(shift.y_m, target.y_m, share);
}

Adjustment with_landing(const LandingShift& shift) noexcept {
  Adjustment adjustment;
  adjustment.landing_x_m = shift.x_m;
  adjustment.landing_y_m = shift.y_m;
  return adjustment;
}

}  // namespace surefoot::stabilizer
