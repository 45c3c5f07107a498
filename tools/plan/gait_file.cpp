#include "tools/plan/gait_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/scenario/field.hpp"

namespace surefoot::plan {
namespace {

constexpr double kStartAndStop_s = 8.0;  // to get going, to close the feet, and to be seen standing

constexpr double kUsualCycle_s = 4.0;  // that a scenario averages over by itself

/// To a millionth: nobody reads more, and a gait may be put together from it.
std::string number(double value) { return scenario::toml_number(std::round(value * 1e6) / 1e6); }

/// Of the whole walk: with the lowest no leg is stretched further than its gait's plan has it.
double pelvis_height_m(std::span<const PlanResult> gaits) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const PlanResult& result : gaits) {
    lowest_m = std::min(lowest_m, result.request.body.hip_height_m(result.after.plan.gait.com_height_m));
  }
  return lowest_m;
}

std::string gait_text(const PlanResult& result, int steps) {
  const planning::StepPlan& plan = result.after.plan;
  const planning::GaitFactors& gait = plan.gait;
  const planning::StepMargins& margins = result.after.margins;
  std::string text = fmt::format(
      "\n# {:.3f} m/s; hip {:.3f} m above the floor; planned: ZMP margin {:.0f} mm, friction {:.2f}, legs stretched to "
      "{:.1f} %\n[[planned_gait]]\n",
      gait.speed_m_s(), result.request.body.hip_height_m(gait.com_height_m), 1e3 * margins.least_zmp_margin_m,
      margins.greatest_friction, 100.0 * margins.greatest_stretch);
  text += fmt::format("steps = {}\n", steps);
  text += fmt::format("pattern = \"{}\"\n", kPatterns[static_cast<std::size_t>(plan.pattern)]);
  text += fmt::format("com_method = \"{}\"\n", kComMethods[static_cast<std::size_t>(plan.com_method)]);
  text += fmt::format("lands_hard = {}\n", plan.lands_hard);
  text += fmt::format("com_height_m = {}\nstep_length_m = {}\n", number(gait.com_height_m), number(gait.step_length_m));
  text += fmt::format("single_support_share = {}\nsingle_support_s = {}\ndouble_support_s = {}\n",
                      number(gait.single_support_share), number(gait.single_support_s), number(gait.double_support_s));
  text += fmt::format("toe_angle_deg = {}\nheel_angle_deg = {}\n", number(result.request.toe_angle_deg),
                      number(result.request.heel_angle_deg));
  text += fmt::format("top_share = {}\ntop_x_m = {}\ntop_z_m = {}\n", number(plan.foot.top_share),
                      number(plan.foot.top_x_m), number(plan.foot.top_z_m));
  return text;
}

}  // namespace

std::string gait_file_text(std::span<const PlanResult> gaits, int steps) {
  const std::string& robot = gaits.front().request.robot;
  double duration_s = kStartAndStop_s;
  for (const PlanResult& result : gaits) duration_s += steps * result.after.plan.gait.step_s();
  std::string text = fmt::format(
      "# A gait that surefoot plan has planned for {}: {} of {} steps. Walk it with: surefoot run THIS_FILE\n"
      "# Expect: it walks to the end; exit code 0.\n\nrobot = \"{}\"\n",
      robot, gaits.size() == 1 ? "one" : fmt::format("{} one after the other", gaits.size()), steps, robot);
  if (robot == "elkahlout") text += "plant = \"nominal\"\n";
  text += fmt::format("duration_s = {}\n", scenario::toml_number(std::ceil(duration_s)));
  text += fmt::format("\n# The pelvis is as high as the lowest of these gaits has it.\n[gait]\nbody_height_m = {}\n",
                      number(pelvis_height_m(gaits)));
  double cycle_s = 0.0;
  for (const PlanResult& result : gaits) cycle_s = std::max(cycle_s, 2.0 * result.after.plan.gait.step_s());
  if (cycle_s > kUsualCycle_s) {
    text += fmt::format("\n[payload_shift]\nmeasuring_s = {}\n", scenario::toml_number(std::ceil(cycle_s)));
  }
  for (const PlanResult& result : gaits) text += gait_text(result, steps);
  return text;
}

}  // namespace surefoot::plan
