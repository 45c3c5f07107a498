#include "firmware/core/gait/motion_plan.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/gait/nominal_walk.hpp"

namespace surefoot::gait {
namespace {

/// A quintic to the floor can dip below it: started shortly before touch-down (by 0.03 mm in 0.1 s, 0.11 mm in
/// 0.2 s), or while the foot is accelerated downwards (1.9 mm in 0.5 s). So a foot lands no later than it would
/// by braking evenly, 2 h / |v|, and before 10 h + 4 v T + a T^2 / 2 turns negative: the quintic is (1 - t/T)^3
/// times a parabola that is h at its begin and this at its end.
double landing_s(const ScalarMotion& motion, double floor_m, double duration_s) noexcept {
  const double height_m = motion.position - floor_m;
  double landing_s = duration_s;
  if (motion.velocity < 0.0) landing_s = std::min(landing_s, 2.0 * height_m / -motion.velocity);
  if (motion.acceleration >= 0.0) return landing_s;
  const double root = std::sqrt(16.0 * motion.velocity * motion.velocity - 20.0 * motion.acceleration * height_m);
  return std::min(landing_s, (4.0 * motion.velocity + root) / -motion.acceleration);
}

ScalarMotion smooth(const ScalarMotion& from, double end_m, Eigen::Index axis, double duration_s,
                    double time_s) noexcept {
  return quintic(from, end_m, axis == 2 ? landing_s(from, end_m, duration_s) : duration_s, time_s);
}

FootPath moved(const MotionPlan& plan, Side side, double time_s) noexcept {
  const FootPath& start = plan.start[index(side)];
  const FootPath& end = plan.end[index(side)];
  if (time_s >= plan.duration_s) return end;
  FootPath foot;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double end_m = end.position_body_m[axis];
    const ScalarMotion from{start.position_body_m[axis], start.velocity_body_m_s[axis],
                            start.acceleration_body_m_s2[axis]};
    const ScalarMotion now = plan.profile == MotionProfile::kRamp ? ramp(from.position, end_m, plan.duration_s, time_s)
                                                                  : smooth(from, end_m, axis, plan.duration_s, time_s);
    foot.position_body_m[axis] = now.position;
    foot.velocity_body_m_s[axis] = now.velocity;
    foot.acceleration_body_m_s2[axis] = now.acceleration;
  }
  return foot;
}

FootReference aside(FootReference feet, double offset_y_m) noexcept {
  for (FootPath& foot : feet) foot.position_body_m.y() += offset_y_m;
  return feet;
}

}  // namespace

MotionPlan stand(const FootReference& stance) noexcept { return {.start = stance, .end = stance}; }

MotionPlan move(const FootReference& start, const FootReference& end, MotionProfile profile,
                double duration_s) noexcept {
  return {.profile = profile, .duration_s = duration_s, .start = start, .end = end};
}

MotionPlan restore(const StepRestoration& step, double offset_y_body_m) noexcept {
  return {.motion = Motion::kStep, .step = step, .offset_y_body_m = offset_y_body_m};
}

MotionPlan walk_on(double start_phase_s, double reference_x_body_m, double offset_y_body_m) noexcept {
  return {.motion = Motion::kWalk,
          .start_phase_s = start_phase_s,
          .reference_x_body_m = reference_x_body_m,
          .offset_y_body_m = offset_y_body_m};
}

FootReference foot_reference(const WalkParameters& walk, const MotionPlan& plan, double time_s) noexcept {
  switch (plan.motion) {
    case Motion::kStep:
      return aside(restoration_reference(walk, plan.step, time_s), plan.offset_y_body_m);
    case Motion::kWalk:
      return aside(nominal_walk_from_rest(walk, plan.start_phase_s + time_s, plan.reference_x_body_m, time_s),
                   plan.offset_y_body_m);
    case Motion::kMove:
      break;
  }
  return {moved(plan, Side::kRight, time_s), moved(plan, Side::kLeft, time_s)};
}

}  // namespace surefoot::gait
