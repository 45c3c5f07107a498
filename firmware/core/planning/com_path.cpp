#include "firmware/core/planning/com_path.hpp"

#include <cmath>

namespace surefoot::planning {
namespace {

using gait::ScalarMotion;

constexpr double kGravity_m_s2 = 9.81;

/// Velocity at both ends of single support, w_s s_s coth(w_s T_s / 2).
double switching_velocity_m_s(const GaitFactors& gait) noexcept {
  const double rate = natural_rate_rad_s(gait.com_height_m);
  return rate * gait.single_support_half_way_m() / std::tanh(0.5 * rate * gait.single_support_s);
}

/// From -s_d with the switching velocity, eq. (7).
ScalarMotion swinging(const GaitFactors& gait, double rate, double time_s) noexcept {
  const double begin_m = -gait.double_support_half_way_m();
  const double sine_m = switching_velocity_m_s(gait) / rate;
  const double cosine = std::cos(rate * time_s);
  const double sine = std::sin(rate * time_s);
  const double position_m = begin_m * cosine + sine_m * sine;
  return {position_m, rate * (sine_m * cosine - begin_m * sine), -rate * rate * position_m};
}

/// Method 3 with its time scaled by k = T_s / T_d: x''(t) = -x_s''(k t).
ScalarMotion mirrored(const GaitFactors& gait, double scale, double time_s) noexcept {
  const double rate = natural_rate_rad_s(gait.com_height_m);
  const double half = 0.5 * rate * gait.single_support_s;
  const double amplitude_m = gait.single_support_half_way_m() / std::sinh(half);
  const double phase = rate * scale * time_s - half;
  const double velocity_m_s = switching_velocity_m_s(gait);
  const double way_m = velocity_m_s * time_s + rate * amplitude_m / scale * std::cosh(half) * time_s -
                       amplitude_m / (scale * scale) * (std::sinh(phase) + std::sinh(half));
  return {way_m - gait.double_support_half_way_m(),
          velocity_m_s - rate * amplitude_m / scale * (std::cosh(phase) - std::cosh(half)),
          -rate * rate * amplitude_m * std::sinh(phase)};
}

}  // namespace

ScalarMotion com_in_single_support(const GaitFactors& gait, double time_s) noexcept {
  const double rate = natural_rate_rad_s(gait.com_height_m);
  const double half = 0.5 * rate * gait.single_support_s;
  const double amplitude_m = gait.single_support_half_way_m() / std::sinh(half);
  const double position_m = amplitude_m * std::sinh(rate * time_s - half);
  return {position_m, rate * amplitude_m * std::cosh(rate * time_s - half), rate * rate * position_m};
}

ScalarMotion com_in_double_support(ComMethod method, const GaitFactors& gait, double time_s) noexcept {
  const double share = gait.single_support_share;
  switch (method) {
    case ComMethod::kSharedPressure: {
      const double pressure_per_way = 1.0 / (1.0 - share);  // 1 / a_d, eqs. (6), (9)
      return swinging(gait, std::sqrt(kGravity_m_s2 * (pressure_per_way - 1.0) / gait.com_height_m), time_s);
    }
    case ComMethod::kHangingPendulum: {
      const double length_m = (1.0 - share) * gait.com_height_m / share;  // H_d, eq. (15)
      return swinging(gait, natural_rate_rad_s(length_m), time_s);
    }
    case ComMethod::kMirroredAcceleration:
      return mirrored(gait, gait.single_support_s / gait.double_support_s, time_s);
    case ComMethod::kMirroredAsPrinted:
      return mirrored(gait, 1.0, time_s);
  }
  return {};
}

double ideal_zmp_m(const GaitFactors& gait, const ScalarMotion& com) noexcept {
  return com.position - gait.com_height_m / kGravity_m_s2 * com.acceleration;
}

double mirrored_double_support_s(const GaitFactors& gait) noexcept {
  constexpr int kHalvings = 60;
  GaitFactors tried = gait;
  double low = 0.0;
  double high = 4.0 * continuous_double_support_s(gait);
  for (int i = 0; i < kHalvings; ++i) {
    tried.double_support_s = 0.5 * (low + high);
    const double end_m =
        mirrored(tried, tried.single_support_s / tried.double_support_s, tried.double_support_s).position;
    (end_m < gait.double_support_half_way_m() ? low : high) = tried.double_support_s;
  }
  return 0.5 * (low + high);
}

}  // namespace surefoot::planning
