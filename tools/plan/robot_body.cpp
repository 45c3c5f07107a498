#include "tools/plan/robot_body.hpp"

namespace surefoot::plan {

planning::SagittalBody sagittal_body(const scenario::Scenario& scenario) {
  const geometry::RobotGeometry& robot = scenario.firmware.geometry;
  const sim_hw::MassConfig& mass = scenario.sim.mass;
  planning::SagittalBody body;
  body.link_m = 0.5 * (robot.thigh_m + robot.calf_m);
  body.ankle_height_m = robot.ankle_height_m;
  body.trunk_com_m = mass.trunk_com_body_m[2];
  body.trunk_kg = mass.trunk_kg;
  body.thigh_kg = mass.thigh_kg;
  body.shank_kg = mass.calf_kg;
  body.foot_kg = mass.foot_kg;
  const double rod_m2 = body.link_m * body.link_m / 12.0;
  body.thigh_inertia_kg_m2 = mass.thigh_kg * rod_m2;
  body.shank_inertia_kg_m2 = mass.calf_kg * rod_m2;
  // Standing, the legs' links are at a quarter, at three quarters and at the end of the way from hip to ankle.
  const double leg_m = scenario.firmware.walk.body_height_m - robot.ankle_height_m;
  const double below_kg_m = 2.0 * leg_m * (0.25 * mass.thigh_kg + 0.75 * mass.calf_kg + mass.foot_kg);
  body.com_above_hip_m = (mass.trunk_kg * body.trunk_com_m - below_kg_m) / body.mass_kg();
  return body;
}

}  // namespace surefoot::plan
