#include "tools/plan/samples.hpp"

#include <fmt/format.h>

#include <cmath>

namespace surefoot::plan {
namespace {

std::string foot_csv(const planning::FootPoint& foot, const PlanSample& sample, std::size_t place) {
  std::string text =
      fmt::format(",{},{},{}", foot.x_m.position, foot.z_m.position, foot.pitch_rad.position * 180.0 / M_PI);
  return text + (sample.loads ? fmt::format(",{},{}", sample.loads->normal_n[place], sample.loads->tangential_n[place])
                              : ",,");
}

}  // namespace

std::vector<PlanSample> samples_of(const PlanRequest& request, const planning::StepPlan& plan, int count) {
  const planning::PlannedStep step(plan);
  const planning::GaitFactors& gait = plan.gait;
  const double hip_height_m = request.body.hip_height_m(gait.com_height_m);
  std::vector<PlanSample> samples;
  for (int i = 0; i < count; ++i) {
    PlanSample sample;
    sample.time_s = gait.step_s() * i / (count - 1);
    sample.instant = step.at(sample.time_s);
    sample.ideal_zmp_m = ideal_zmp_m(gait, sample.instant.com_x_m);
    sample.loads = loads(request.body, hip_height_m, sample.instant, sample.time_s / gait.double_support_s);
    sample.edges = support_edges(step.plan().foot, sample.instant);
    samples.push_back(sample);
  }
  return samples;
}

std::string samples_csv(const std::vector<PlanSample>& samples) {
  std::string text =
      "time_s,support,com_x_m,com_x_m_s,com_x_m_s2,ideal_zmp_m,real_zmp_m,support_rear_m,support_front_m,"
      "stance_x_m,stance_z_m,stance_pitch_deg,stance_normal_n,stance_tangential_n,"
      "swing_x_m,swing_z_m,swing_pitch_deg,swing_normal_n,swing_tangential_n\n";
  for (const PlanSample& sample : samples) {
    const gait::ScalarMotion& com = sample.instant.com_x_m;
    text += fmt::format(
        "{},{},{},{},{},{},{},{},{}", sample.time_s, sample.instant.is_double_support ? "double" : "single",
        com.position, com.velocity, com.acceleration, sample.ideal_zmp_m,
        sample.loads ? fmt::format("{}", sample.loads->zmp_x_m) : "", sample.edges.rear_m, sample.edges.front_m);
    text += foot_csv(sample.instant.stance, sample, 0) + foot_csv(sample.instant.swing, sample, 1) + "\n";
  }
  return text;
}

}  // namespace surefoot::plan
