#include "firmware/core/gait/four_factor_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::gait {

using std::numbers::pi;

double sway_y_m(const WalkParameters& walk, double amplitude_m, Side moving, double step_time_s) noexcept {
  return -lateral_sign(moving) * amplitude_m *
         std::sin(pi * (step_time_s - 0.5 * walk.double_support_s) / walk.step_s());
}

double swing_height_m(const WalkParameters& walk, double swing_share) noexcept {
  return 0.5 * walk.swing_height_m * (1.0 - std::cos(2.0 * pi * swing_share));
}

double swing_progress(double swing_share) noexcept { return 0.5 * (1.0 - std::cos(pi * swing_share)); }

double swing_share(const WalkParameters& walk, double step_time_s) noexcept {
  return std::clamp((step_time_s - walk.double_support_s) / walk.single_support_s, 0.0, 1.0);
}

}  // namespace surefoot::gait
