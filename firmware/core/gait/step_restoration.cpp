#include "firmware/core/gait/step_restoration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/gait/stance.hpp"

namespace surefoot::gait {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSmallestFactor = 1.0e-3;

/// height / 2 (1 - cos(2 pi t / duration)): up and down again, at rest at both ends and outside.
ScalarMotion hump(double height, double duration_s, double time_s) noexcept {
  if (time_s <= 0.0 || time_s >= duration_s) return {};
  const double rate = kPi / duration_s;
  const double sine = std::sin(rate * time_s);
  const double cosine = std::cos(rate * time_s);
  return {height * sine * sine, 2.0 * height * rate * sine * cosine,
          2.0 * height * rate * rate * (cosine * cosine - sine * sine)};
}

/// m of (3.26): from `start` to `end` along half a cosine, at rest before and after.
ScalarMotion half_cosine(double start, double end, double duration_s, double time_s) noexcept {
  if (time_s <= 0.0) return {.position = start};
  if (time_s >= duration_s) return {.position = end};
  const double rate = kPi / duration_s;
  const double half = 0.5 * (end - start);
  const double cosine = std::cos(rate * time_s);
  return {start + half * (1.0 - cosine), half * rate * std::sin(rate * time_s), half * rate * rate * cosine};
}

void add(FootPath& foot, Eigen::Index axis, double sign, const ScalarMotion& motion) noexcept {
  foot.position_body_m[axis] += sign * motion.position;
  foot.velocity_body_m_s[axis] += sign * motion.velocity;
  foot.acceleration_body_m_s2[axis] += sign * motion.acceleration;
}

}  // namespace

StepRestoration plan_restoration(const WalkParameters& walk, RestorationTiming timing, double reference_x_m,
                                 double right_x_m, double left_x_m) noexcept {
  StepRestoration plan;
  plan.swing = right_x_m <= left_x_m ? Side::kLeft : Side::kRight;
  plan.reference_x_body_m = reference_x_m;
  plan.half_spread_m = 0.5 * std::abs(right_x_m - left_x_m);
  const double front_x_m = std::max(right_x_m, left_x_m);
  plan.factor = std::abs(reference_x_m + walk.half_step_m - front_x_m) / (2.0 * walk.half_step_m);
  if (!(plan.factor >= kSmallestFactor)) return plan;  // NaN, from a step length of zero, too

  const double cosine = timing == RestorationTiming::kAcosFactor ? plan.factor : 1.0 - 2.0 * plan.factor;
  plan.single_support_s = walk.single_support_s * std::acos(std::clamp(cosine, -1.0, 1.0)) / kPi;
  plan.double_support_s = walk.double_support_s / walk.single_support_s * plan.single_support_s;
  return plan;
}

FootReference restoration_reference(const WalkParameters& walk, const StepRestoration& plan, double time_s) noexcept {
  FootReference reference = stance(walk, {plan.reference_x_body_m, plan.reference_x_body_m});
  const double since_lift_off_s = time_s - 0.5 * plan.double_support_s;
  // A skipped step leaves the feet as they stand.
  const double half_step_m = plan.duration_s() > 0.0 ? walk.half_step_m : plan.half_spread_m;
  const ScalarMotion spread = half_cosine(plan.half_spread_m, half_step_m, plan.single_support_s, since_lift_off_s);
  const ScalarMotion sway = hump(walk.sway_m * plan.factor, plan.duration_s(), time_s);
  const double sway_sign = lateral_sign(plan.swing);  // -sigma: the body leans over the standing foot
  for (const Side side : kSides) {
    FootPath& foot = reference[index(side)];
    add(foot, 0, side == plan.swing ? 1.0 : -1.0, spread);
    add(foot, 1, sway_sign, sway);
  }
  add(reference[index(plan.swing)], 2, 1.0,
      hump(walk.swing_height_m * plan.factor, plan.single_support_s, since_lift_off_s));
  return reference;
}

}  // namespace surefoot::gait
