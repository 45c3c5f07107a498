#include "tools/scenario/planned_gait_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "firmware/core/gait/lateral_pendulum.hpp"
#include "tools/scenario/field_table.hpp"

namespace surefoot::scenario {
namespace {

using planning::FootPoint;
using planning::PlannedStep;

constexpr double kGravity_m_s2 = 9.81;
constexpr double kMostStretch = 0.999;  // share of a leg's length; beyond it the knee cannot follow
constexpr int kSamples = 200;

/// Where in a step a leg is stretched most, share of its length.
double greatest_stretch(const ControllerConfig& firmware, const planning::StepPlan& plan) {
  const geometry::RobotGeometry& robot = firmware.geometry;
  const gait::FourFactorParameters& pattern = firmware.floor.pattern;
  const PlannedStep step(plan);
  const gait::LateralPendulum sway(firmware.walk.foot_offset_y_m, std::sqrt(kGravity_m_s2 / pattern.com_height_m),
                                   plan.gait.single_support_s, plan.gait.double_support_s);
  double greatest_m = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    const double time_s = plan.gait.step_s() * i / kSamples;
    const planning::StepInstant now = step.at(time_s);
    const double sway_m = sway.at(time_s).position / pattern.com_share;  // towards the foot that carries
    const double hip_x_m = now.com_x_m.position + pattern.pelvis_x_m + robot.hip_x_body_m;
    const double apart_m = firmware.walk.foot_offset_y_m - robot.hip_y_body_m;
    const auto stretched_m = [&](const FootPoint& foot, double inward_m) {
      const double pitch_rad = foot.pitch_rad.position;
      const double x_m = foot.x_m.position + robot.ankle_height_m * std::sin(pitch_rad) - hip_x_m;
      const double z_m = firmware.walk.body_height_m - foot.z_m.position - robot.ankle_height_m * std::cos(pitch_rad);
      return std::hypot(x_m, inward_m, z_m);
    };
    greatest_m =
        std::max({greatest_m, stretched_m(now.stance, apart_m - sway_m), stretched_m(now.swing, apart_m + sway_m)});
  }
  return greatest_m / (robot.thigh_m + robot.calf_m);
}

/// The double support with which the centre of mass goes on without a step in its acceleration.
double joining_double_support_s(const planning::StepPlan& plan) {
  return plan.com_method == planning::ComMethod::kMirroredAcceleration
             ? planning::mirrored_double_support_s(plan.gait)
             : planning::continuous_double_support_s(plan.gait);
}

Finding about(std::size_t place, const char* key, std::string statement, std::string remedy) {
  return {{element_key("planned_gait", place, key)}, std::move(statement), std::move(remedy)};
}

}  // namespace

void check_planned_gaits(const Scenario& scenario, std::vector<Finding>& findings) {
  constexpr double kTolerance = 0.02;  // of the double support; the strides' joins take up what is less
  const gait::PlannedGaits& gaits = scenario.firmware.floor.pattern.gaits;
  for (std::size_t i = 0; i < gaits.count; ++i) {
    const planning::StepPlan& plan = gaits.gait[i].plan;
    if (i + 1 < gaits.count && gaits.gait[i].steps == 0) {
      findings.push_back(about(i, "steps", fmt::format("planned_gait[{}].steps is 0, but another gait follows", i),
                               "give the steps that are walked before the next gait, or remove the gaits after it"));
    }
    const double joining_s = joining_double_support_s(plan);
    if (std::abs(plan.gait.double_support_s - joining_s) > kTolerance * joining_s) {
      findings.push_back(
          about(i, "double_support_s",
                fmt::format("planned_gait[{}].double_support_s is {:.4g}; with it the path of the centre "
                            "of mass would jump where the supports join",
                            i, plan.gait.double_support_s),
                fmt::format("take {:.6g} s, or let surefoot plan choose the share", joining_s)));
    }
    if (!PlannedStep(plan).is_determined()) {
      findings.push_back(about(i, "step_length_m", fmt::format("planned_gait[{}] is no possible step", i),
                               "compare its durations and lengths with those that surefoot plan writes"));
      continue;
    }
    const double stretch = greatest_stretch(scenario.firmware, plan);
    if (!(stretch < kMostStretch)) {
      findings.push_back(
          {{"gait.body_height_m", element_key("planned_gait", i, "step_length_m")},
           fmt::format("planned_gait[{}] stretches a leg to {:.1f} % of its length; expected less than {:.1f} %", i,
                       100.0 * stretch, 100.0 * kMostStretch),
           "lower gait.body_height_m, the gait's step_length_m, or its toe_angle_deg and heel_angle_deg"});
    }
  }
}

}  // namespace surefoot::scenario
