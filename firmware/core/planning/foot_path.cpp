#include "firmware/core/planning/foot_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot::planning {
namespace {

using gait::ScalarMotion;

/// 1 - cos of a moving angle, times a length.
ScalarMotion versine(double length_m, const ScalarMotion& angle) noexcept {
  const double sine = std::sin(angle.position);
  const double cosine = std::cos(angle.position);
  return {length_m * (1.0 - cosine), length_m * sine * angle.velocity,
          length_m * (sine * angle.acceleration + cosine * angle.velocity * angle.velocity)};
}

ScalarMotion sine_of(double length_m, const ScalarMotion& angle) noexcept {
  const double sine = std::sin(angle.position);
  const double cosine = std::cos(angle.position);
  return {length_m * sine, length_m * cosine * angle.velocity,
          length_m * (cosine * angle.acceleration - sine * angle.velocity * angle.velocity)};
}

ScalarMotion moved(double by_m, ScalarMotion motion) noexcept {
  motion.position += by_m;
  return motion;
}

constexpr std::array kTwoQuartics{4, 4};
constexpr std::array kTwoCubics{3, 3};

/// From one motion through a place to another: ten conditions with the joint.
Spline through(const std::array<double, 3>& knots_s, const ScalarMotion& begin, double middle,
               const ScalarMotion& end) noexcept {
  const std::array<SplineCondition, 7> conditions{{{0, 0, begin.position},
                                                   {0, 1, begin.velocity},
                                                   {0, 2, begin.acceleration},
                                                   {1, 0, middle},
                                                   {2, 0, end.position},
                                                   {2, 1, end.velocity},
                                                   {2, 2, end.acceleration}}};
  return {knots_s, kTwoQuartics, conditions};
}

bool is_possible(const FootStep& step, bool is_rolled) noexcept {
  const bool is_finite =
      std::isfinite(step.step_length_m + step.toe_s + step.swing_s + step.heel_s + step.top_share + step.top_x_m +
                    step.top_z_m + step.toe_angle_rad + step.heel_angle_rad + step.toe_m + step.heel_m);
  if (is_rolled && !(step.toe_s > 0.0 && step.heel_s > 0.0)) return false;
  return is_finite && step.swing_s > 0.0 && step.top_share > 0.0 && step.top_share < 1.0 && step.toe_angle_rad >= 0.0 &&
         step.heel_angle_rad >= 0.0 && step.toe_m >= 0.0 && step.heel_m >= 0.0;
}

}  // namespace

FootPath::FootPath(FootCase foot_case, const FootStep& step) noexcept
    : step_(step),
      is_rolled_(foot_case == FootCase::kSoftRolled || foot_case == FootCase::kHardRolled),
      lift_s_(is_rolled_ ? step.toe_s : 0.0),
      after_s_(is_rolled_ ? step.heel_s : 0.0) {
  if (!is_possible(step, is_rolled_)) return;
  if (is_rolled_) {
    plan_pitch(foot_case);
    plan_swing();
  } else {
    plan_flat(foot_case);
  }
}

void FootPath::plan_flat(FootCase foot_case) noexcept {
  const double way_m = step_.step_length_m;
  const std::array knots_s{0.0, step_.top_share * step_.swing_s, step_.swing_s};
  if (foot_case == FootCase::kSoftFlat) {
    x_ = through(knots_s, {-way_m, 0.0, 0.0}, step_.top_x_m, {way_m, 0.0, 0.0});
    z_ = through(knots_s, {}, step_.top_z_m, {});
    return;
  }
  constexpr std::array kOneCubic{3};
  x_ = Spline(std::array{0.0, step_.swing_s}, kOneCubic,
              std::array<SplineCondition, 4>{{{0, 0, -way_m}, {0, 1, 0.0}, {0, 2, 0.0}, {1, 0, way_m}}});
  z_ = Spline(
      knots_s, kTwoCubics,
      std::array<SplineCondition, 5>{{{0, 0, 0.0}, {0, 1, 0.0}, {0, 2, 0.0}, {1, 0, step_.top_z_m}, {2, 0, 0.0}}});
}

void FootPath::plan_pitch(FootCase foot_case) noexcept {
  const double lift_rad = step_.toe_angle_rad;
  const double landing_rad = -step_.heel_angle_rad;
  const double end_s = duration_s();
  if (foot_case == FootCase::kHardRolled) {
    constexpr std::array kDegrees{4, 3, 4};
    pitch_ = Spline(std::array{0.0, lift_s(), landing_s(), end_s}, kDegrees,
                    std::array<SplineCondition, 8>{{{0, 0, 0.0},
                                                    {0, 1, 0.0},
                                                    {0, 2, 0.0},
                                                    {1, 0, lift_rad},
                                                    {2, 0, landing_rad},
                                                    {3, 0, 0.0},
                                                    {3, 1, 0.0},
                                                    {3, 2, 0.0}}});
    return;
  }
  pitch_ = through({0.0, lift_s(), landing_s()}, {}, lift_rad, {landing_rad, 0.0, 0.0});
  pitch_on_heel_ =
      through({landing_s(), 0.5 * (landing_s() + end_s), end_s}, {landing_rad, 0.0, 0.0}, 0.5 * landing_rad, {});
}

void FootPath::plan_swing() noexcept {
  if (!pitch_.is_determined()) return;
  const FootPoint lift = on_toe(lift_s());
  const FootPoint landing = on_heel(landing_s());
  const std::array knots_s{lift_s(), lift_s() + step_.top_share * step_.swing_s, landing_s()};
  x_ = through(knots_s, lift.x_m, step_.top_x_m, landing.x_m);
  z_ = through(knots_s, lift.z_m, step_.top_z_m, landing.z_m);
}

bool FootPath::is_determined() const noexcept {
  return x_.is_determined() && z_.is_determined() && (!is_rolled_ || pitch_.is_determined());
}

FootPoint FootPath::on_toe(double time_s) const noexcept {
  const ScalarMotion pitch = pitch_.at(time_s);
  return {moved(-step_.step_length_m, versine(step_.toe_m, pitch)), sine_of(step_.toe_m, pitch), pitch};
}

FootPoint FootPath::on_heel(double time_s) const noexcept {
  const ScalarMotion pitch = pitch_on_heel_.is_determined() ? pitch_on_heel_.at(time_s) : pitch_.at(time_s);
  return {moved(step_.step_length_m, versine(-step_.heel_m, pitch)), sine_of(-step_.heel_m, pitch), pitch};
}

FootPoint FootPath::at(double time_s) const noexcept {
  const double held_s = std::clamp(time_s, 0.0, duration_s());
  if (is_rolled_ && held_s < lift_s()) return on_toe(held_s);
  if (is_rolled_ && held_s >= landing_s()) return on_heel(held_s);
  return {x_.at(held_s), z_.at(held_s), is_rolled_ ? pitch_.at(held_s) : ScalarMotion{}};
}

}  // namespace surefoot::planning
