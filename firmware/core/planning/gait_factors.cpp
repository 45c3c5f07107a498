#include "firmware/core/planning/gait_factors.hpp"

#include <cmath>

namespace surefoot::planning {
namespace {

constexpr double kGravity_m_s2 = 9.81;
constexpr int kHalvings = 60;  // of (0, 1): to the last bit

}  // namespace

double natural_rate_rad_s(double com_height_m) noexcept { return std::sqrt(kGravity_m_s2 / com_height_m); }

double continuous_double_support_s(const GaitFactors& gait) noexcept {
  const double share = gait.single_support_share;
  const double single_rate = natural_rate_rad_s(gait.com_height_m);
  const double double_rate = single_rate * std::sqrt(share / (1.0 - share));  // eqs. (8), (9)
  return 2.0 / double_rate *
         std::atan(std::sqrt((1.0 - share) / share) * std::tanh(0.5 * single_rate * gait.single_support_s));
}

std::optional<double> continuous_single_support_share(double com_height_m, double single_support_s,
                                                      double double_support_s) noexcept {
  const bool is_sound = com_height_m > 0.0 && single_support_s > 0.0 && double_support_s > 0.0 &&
                        std::isfinite(com_height_m + single_support_s + double_support_s);
  if (!is_sound) return std::nullopt;
  GaitFactors gait{.com_height_m = com_height_m, .single_support_s = single_support_s};
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    gait.single_support_share = 0.5 * (low + high);
    (continuous_double_support_s(gait) > double_support_s ? low : high) = gait.single_support_share;
  }
  const double share = 0.5 * (low + high);
  if (share < 1e-9 || share > 1.0 - 1e-9) return std::nullopt;
  return share;
}

double least_friction(const GaitFactors& gait) noexcept { return gait.single_support_half_way_m() / gait.com_height_m; }

}  // namespace surefoot::planning
