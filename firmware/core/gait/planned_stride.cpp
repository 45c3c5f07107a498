#include "firmware/core/gait/planned_stride.hpp"

#include <algorithm>

#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::gait {
namespace {

using planning::FootPoint;
using planning::PlannedStep;
using planning::StepPlan;

StepPlan with_way(StepPlan plan, double step_length_m) noexcept {
  plan.gait.step_length_m = step_length_m;
  return plan;
}

FootPoint moved(double by_m, FootPoint foot) noexcept {
  foot.x_m.position += by_m;
  return foot;
}

/// Seen from a time that runs the other way.
ScalarMotion turned_round(const ScalarMotion& motion) noexcept {
  return {motion.position, -motion.velocity, motion.acceleration};
}

/// The gait's own centre of mass, from the ankle of the foot that carries.
ScalarMotion own_com(const StepPlan& plan, double time_s) noexcept {
  const planning::GaitFactors& gait = plan.gait;
  if (time_s < gait.double_support_s) {
    ScalarMotion com = planning::com_in_double_support(plan.com_method, gait, time_s);
    com.position -= 0.5 * gait.step_length_m;
    return com;
  }
  return planning::com_in_single_support(gait, time_s - gait.double_support_s);
}

}  // namespace

const planning::StepPlan& PlannedGaits::of_step(std::uint32_t step) const noexcept {
  std::size_t place = 0;
  std::uint32_t until = 0;
  while (place + 1 < count && step >= until + gait[place].steps) until += gait[place++].steps;
  return gait[place].plan;
}

std::uint32_t PlannedGaits::steps() const noexcept {
  if (count == 0 || gait[count - 1].steps == 0) return 0;
  std::uint32_t sum = 0;
  for (std::size_t place = 0; place < count; ++place) sum += gait[place].steps;
  return sum;
}

PlannedStride::PlannedStride() noexcept : step_(StepPlan{}), feet_(StepPlan{}), feet_before_(StepPlan{}) {}

PlannedStride::PlannedStride(const StepPlan& plan, const StrideBorders& borders, const PlannedStride& before) noexcept
    : step_(plan),
      feet_(with_way(plan, 0.5 * (borders.from_m + borders.to_m))),
      feet_before_(before.feet_),
      borders_(borders),
      walks_(true),
      walked_before_(before.walks_) {
  using planning::operator-;
  join_at_begin_ = borders.com_x_m - own_com(plan, 0.0);
  const ScalarMotion end = own_com(plan, duration_s());
  if (borders.comes_to_rest) join_at_end_ = turned_round(ScalarMotion{} - end);
}

StrideInstant PlannedStride::at(double time_s) const noexcept {
  using planning::operator+;
  StrideInstant instant;
  if (!walks_) return instant;
  const double held_s = std::clamp(time_s, 0.0, duration_s());
  instant.com_x_m = own_com(step_.plan(), held_s) + quintic(join_at_begin_, 0.0, duration_s(), held_s) +
                    turned_round(quintic(join_at_end_, 0.0, duration_s(), duration_s() - held_s));
  const double half_way_m = 0.25 * (borders_.from_m + borders_.to_m);  // S / 2 of the feet's step
  instant.swing = feet_.is_determined() ? moved(half_way_m - borders_.from_m, feet_.at(held_s).swing) : FootPoint{};
  if (walked_before_ && feet_before_.is_determined()) {
    instant.stance =
        moved(-0.5 * feet_before_.plan().gait.step_length_m, feet_before_.at(std::max(0.0, time_s)).stance);
  }
  return instant;
}

}  // namespace surefoot::gait
