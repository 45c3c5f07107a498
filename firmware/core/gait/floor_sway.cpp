#include "firmware/core/gait/floor_sway.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::gait {
namespace {

using decision::WalkStage;

constexpr double kGravity_m_s2 = 9.81;

/// Time in which the pressure centre goes from foot to foot.
double transfer_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.gaits.is_empty() ? pattern.transfer_s : walk.double_support_s;
}

/// How much of the sway there is.
double sway_share(const WalkParameters& walk, const FourFactorParameters& pattern,
                  const FloorWalkState& state) noexcept {
  switch (state.stage) {
    case WalkStage::kStanding:
      return 0.0;
    case WalkStage::kShifting:
      return smooth(1.0 + state.step_time_s / shift_s(walk, pattern));
    case WalkStage::kLanding:  // a planned walk comes to rest by itself
      return pattern.gaits.is_empty() ? 1.0 - smooth(state.time_in_stage_s / walk.step_s()) : 1.0;
    default:
      return 1.0;
  }
}

/// Pelvis over the middle of the feet, without what fades it in and out.
double full_sway_y_m(const WalkParameters& walk, const FourFactorParameters& pattern, const FloorWalkState& state,
                     double added_m) noexcept {
  if (pattern.gaits.is_empty() && pattern.sway_profile == SwayProfile::kSine) {
    return sway_y_m(walk, walk.sway_m + added_m, state.moving, state.step_time_s);
  }
  const double share = 1.0 / pattern.com_share + added_m / state.com_y.amplitude_m();
  const double earlier_s = 0.5 * (walk.double_support_s - transfer_s(walk, pattern));
  const bool comes_to_rest = !pattern.gaits.is_empty() && state.stage == WalkStage::kLanding;
  const double own_y_m = comes_to_rest ? 0.0 : state.com_y.at(state.step_time_s - earlier_s).position;
  const double com_y_m = own_y_m + quintic(state.sway_join_m, 0.0, walk.step_s(), state.step_time_s).position;
  return -lateral_sign(state.moving) * share * com_y_m;
}

}  // namespace

double natural_rate_rad_s(const FourFactorParameters& pattern) noexcept {
  return std::sqrt(kGravity_m_s2 / pattern.com_height_m);
}

double shift_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.shift_steps * walk.step_s() - 0.5 * walk.double_support_s;
}

double smooth(double share) noexcept {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

LateralPendulum lateral_pendulum(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  const double transfer = transfer_s(walk, pattern);
  return {walk.foot_offset_y_m, natural_rate_rad_s(pattern), walk.step_s() - transfer, transfer};
}

double pelvis_sway_y_m(const WalkParameters& walk, const FourFactorParameters& pattern, const FloorWalkState& state,
                       double added_m) noexcept {
  return sway_share(walk, pattern, state) * full_sway_y_m(walk, pattern, state, added_m);
}

}  // namespace surefoot::gait
