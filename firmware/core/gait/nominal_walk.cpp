#include "firmware/core/gait/nominal_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "firmware/core/gait/motion_profile.hpp"

namespace surefoot::gait {
namespace {

constexpr double kPi = std::numbers::pi;

/// Tick times are sums of rounded numbers; this much early is meant to be the boundary itself.
constexpr double kPhaseTolerance_s = 1.0e-9;

void set(FootPath& foot, Eigen::Index axis, const ScalarMotion& motion) noexcept {
  foot.position_body_m[axis] = motion.position;
  foot.velocity_body_m_s[axis] = motion.velocity;
  foot.acceleration_body_m_s2[axis] = motion.acceleration;
}

ScalarMotion sway(const WalkParameters& walk, const HalfCycle& half) noexcept {
  const double rate = kPi / walk.step_s();
  const double amplitude = half.swing == Side::kLeft ? walk.sway_m : -walk.sway_m;
  const double sine = std::sin(rate * half.time_s);
  return {amplitude * sine, amplitude * rate * std::cos(rate * half.time_s), -amplitude * rate * rate * sine};
}

FootReference with_sway(const WalkParameters& walk, const HalfCycle& half, double reference_x_m,
                        const ScalarMotion& sway) noexcept {
  // xi: the standing foot travels from +b_s to -b_s about the reference, the swing foot the other way.
  ScalarMotion stance_x{.position = walk.half_step_m};
  ScalarMotion swing_z{.position = -walk.body_height_m};
  const double since_lift_off_s = half.time_s - 0.5 * walk.double_support_s;
  if (since_lift_off_s >= walk.single_support_s) {
    stance_x.position = -walk.half_step_m;
  } else if (since_lift_off_s > 0.0) {
    const double rate = kPi / walk.single_support_s;
    const double cosine = std::cos(rate * since_lift_off_s);
    const double sine = std::sin(rate * since_lift_off_s);
    const double b = walk.half_step_m;
    stance_x = {b * cosine, -b * rate * sine, -b * rate * rate * cosine};
    // (h_s / 2) (1 - cos 2 theta) and its derivatives, by the double angle of the same theta.
    swing_z.position += walk.swing_height_m * sine * sine;
    swing_z.velocity = walk.swing_height_m * rate * 2.0 * sine * cosine;
    swing_z.acceleration = walk.swing_height_m * rate * rate * 2.0 * (cosine * cosine - sine * sine);
  }
  const ScalarMotion swing_x{-stance_x.position, -stance_x.velocity, -stance_x.acceleration};

  FootReference reference;
  for (const Side side : kSides) {
    FootPath& foot = reference[index(side)];
    const bool swings = side == half.swing;
    const ScalarMotion& x = swings ? swing_x : stance_x;
    const double y_m = walk.reference_y_body_m + lateral_sign(side) * walk.foot_offset_y_m;
    set(foot, 0, {reference_x_m + x.position, x.velocity, x.acceleration});
    set(foot, 1, {y_m + sway.position, sway.velocity, sway.acceleration});
    set(foot, 2, swings ? swing_z : ScalarMotion{.position = -walk.body_height_m});
  }
  return reference;
}

}  // namespace

HalfCycle half_cycle(const WalkParameters& walk, double phase_s) noexcept {
  double phase = std::fmod(phase_s + kPhaseTolerance_s, walk.cycle_s());
  if (phase < 0.0) phase += walk.cycle_s();
  const bool is_second = phase >= walk.step_s();
  const double time_s = phase - (is_second ? walk.step_s() : 0.0) - kPhaseTolerance_s;
  return {is_second ? Side::kRight : Side::kLeft, std::max(time_s, 0.0)};
}

FootReference nominal_walk(const WalkParameters& walk, double phase_s, double reference_x_m) noexcept {
  const HalfCycle half = half_cycle(walk, phase_s);
  return with_sway(walk, half, reference_x_m, sway(walk, half));
}

FootReference nominal_walk_from_rest(const WalkParameters& walk, double phase_s, double reference_x_m,
                                     double since_start_s) noexcept {
  const double fade_s = 0.5 * walk.double_support_s;
  if (since_start_s >= fade_s) return nominal_walk(walk, phase_s, reference_x_m);
  const HalfCycle half = half_cycle(walk, phase_s);
  const ScalarMotion full = sway(walk, half);
  const ScalarMotion fade = rest_to_rest(since_start_s / fade_s);
  const double fade_rate = fade.velocity / fade_s;
  return with_sway(walk, half, reference_x_m,
                   {fade.position * full.position, fade.position * full.velocity + fade_rate * full.position,
                    fade.position * full.acceleration + 2.0 * fade_rate * full.velocity +
                        fade.acceleration / (fade_s * fade_s) * full.position});
}

bool is_double_support(const WalkParameters& walk, double phase_s) noexcept {
  const double since_lift_off_s = half_cycle(walk, phase_s).time_s - 0.5 * walk.double_support_s;
  return since_lift_off_s < 0.0 || since_lift_off_s >= walk.single_support_s;
}

}  // namespace surefoot::gait
