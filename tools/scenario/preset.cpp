#include "tools/scenario/preset.hpp"

#include "firmware/core/stabilizer/stabilizer.hpp"

namespace surefoot::scenario {
namespace {

void set_elkahlout(const PresetNames& names, Scenario& scenario) {
  if (names.plant != "nominal") {
    // Calibrated so that the unaided robot falls as the thesis' does (Table 4.1): 2.5 kg survived, 5 kg not, at any
    // instant. Toes of 0.117 to 0.1228 m do; the longest is taken, where halving the physics step changes no verdict.
    // A calibration, then, not a prediction.
    scenario.firmware.geometry.sole_heel_m = 0.0923;
    scenario.firmware.geometry.sole_toe_m = 0.1228;
    scenario.sim.contact.friction = 0.11;
  }
  if (names.reflex == "modified") scenario.firmware.reflex.settling_s = 4.0;
  if (names.reflex == "capture") {
    scenario.firmware.reflex.settling_s = 3.0;
    scenario.firmware.detector.relearning_s = 4.8;  // a load at a side makes the two steps of a cycle differ
  }
}

/// Lengths, masses' sum and the pattern as Kim, Park, Oh 2007 print them; the split of the mass, the heights of its
/// centres, drives and contact are assumptions under which the printed pattern walks.
void set_khr2(Scenario& scenario) {
  geometry::RobotGeometry& robot = scenario.firmware.geometry;
  robot.hip_x_body_m = 0.0;
  robot.hip_y_body_m = 0.071;
  robot.thigh_m = 0.29;
  robot.calf_m = 0.28;
  robot.ankle_height_m = 0.10;
  robot.sole_heel_m = 0.105;
  robot.sole_toe_m = 0.128;
  robot.sole_width_m = 0.14;

  sim_hw::MassConfig& mass = scenario.sim.mass;
  mass.trunk_kg = 34.0;
  mass.trunk_size_m = {0.213, 0.42, 0.55};
  mass.trunk_com_body_m = {0.0, 0.0, 0.25};
  mass.thigh_kg = 5.0;
  mass.calf_kg = 3.5;
  mass.foot_kg = 2.5;
  mass.foot_com_x_foot_m = 0.0;

  sim_hw::DriveConfig& drive = scenario.sim.drive;
  drive.rotor_inertia_kg_m2 = 0.1;
  drive.rotor_share = {0.5, 0.5, 1.0, 1.0, 0.5, 0.5};
  drive.hip_knee_friction_nm_s_per_rad = 5.0;
  drive.ankle_friction_nm_s_per_rad = 5.0;
  drive.servo_stiffness_nm_per_rad = {3000.0, 17000.0, 8000.0, 8000.0, 2450.0, 2450.0};  // ankle: 21.4 N m to 0.5 deg
  scenario.firmware.gate.torque_limit_nm = 150.0;

  sim_hw::ContactConfig& contact = scenario.sim.contact;
  contact.friction = 0.8;
  contact.normal_stiffness_n_per_m = 3.0e5;
  contact.normal_damping_n_s_per_m = 600.0;
  scenario.sim.sensor.has_inertial_legs = true;
  scenario.firmware.plausibility.foot.frozen_s = 600.0;  // a corner over a low tile may never touch
  scenario.sim.bus.count = 2;                            // the inertial frames do not fit on one bus at 1 kHz

  gait::WalkParameters& walk = scenario.firmware.walk;
  walk.single_support_s = 0.9025;
  walk.double_support_s = 0.0475;
  walk.half_step_m = 0.1;
  walk.reference_x_body_m = 0.0;
  walk.foot_offset_y_m = 0.071;
  walk.sway_m = 0.060;
  walk.body_height_m = 0.65;
  walk.swing_height_m = 0.04;
  scenario.firmware.floor.pattern.standing_s = 12.0;  // on a slope the torso needs that long to come upright
}

/// El-Kahlout's robot on KHR-2's stages and controllers, its boards as position servos.
void set_planned_elkahlout(Scenario& scenario) {
  gait::WalkParameters& walk = scenario.firmware.walk;
  walk.reference_x_body_m = 0.0;
  walk.half_step_m = 0.075;
  walk.sway_m = 0.06;
  walk.body_height_m = 0.55;
  FloorWalkerConfig& floor = scenario.firmware.floor;
  floor.pattern.standing_s = 3.0;
  floor.pattern.com_height_m = 0.67;
  floor.pattern.pelvis_x_m = 0.034;  // puts the mass over the ankles
}

/// The payload reflex' times are long enough for cycles of up to 4 s. The ZMP compensator is left out of the extended
/// set: it compares with recorded tables, which a planned gait does not have, and shifts a pelvis that is where it
/// should be.
void set_planned_walk(Scenario& scenario) {
  scenario.gaits.resize(1);
  if (scenario.controllers == "extended") {
    scenario.firmware.floor.stabilizer.is_on[static_cast<std::size_t>(stabilizer::Controller::kZmpCompensator)] = false;
  }
  scenario.firmware.floor.payload.measuring_s = 4.0;
  scenario.firmware.detector.learning_s = 8.0;
  scenario.firmware.detector.relearning_s = 8.0;
}

/// What every walk with KHR-2's stages begins with.
void set_floor_walk(const PresetNames& names, Scenario& scenario) {
  // One landing on a bad tile, 1.9 times the weight, must not look like a load: with 0.1 s it does, by 66 N, with
  // 0.3 s it stays within 18 N of what was learned (tiles on the slope, seeds 1 to 20).
  scenario.firmware.estimator.force_time_constant_s = 0.3;
  scenario.firmware.detector = {
      .warm_up_s = 0.0, .learning_s = 3.8, .margin_n = 25.0, .relearning_s = 3.8, .resume_margin_n = 25.0};

  stabilizer::StabilizerConfig& controllers = scenario.firmware.floor.stabilizer;
  controllers.is_on = {};
  if (names.controllers == "paper") controllers.is_on = stabilizer::paper_set();
  if (scenario.controllers == "extended") {
    controllers.is_on = stabilizer::extended_set();
    scenario.firmware.floor.pattern.sway_profile = gait::SwayProfile::kPendulum;
  }
  controllers.attitude_feedback.nominal_share = 0.45;  // damps the flat walk's own swing; 1 would leave it as it is
}

}  // namespace

PresetNames preset_names(const Scenario& scenario) {
  return {.robot = scenario.robot,
          .plant = scenario.plant,
          .controllers = scenario.controllers,
          .reflex = "original",
          .has_planned_gaits = !scenario.gaits.empty()};
}

Scenario preset(const PresetNames& names) {
  Scenario scenario;
  const bool is_khr2 = names.robot == "khr2";
  scenario.robot = is_khr2 ? "khr2" : "elkahlout";
  scenario.plant = is_khr2 || names.plant == "nominal" ? "nominal" : "thesis";
  scenario.controllers = names.controllers == "off" || names.controllers == "paper" ? names.controllers : "extended";
  is_khr2 ? set_khr2(scenario) : set_elkahlout(names, scenario);
  if (is_khr2 || names.has_planned_gaits) set_floor_walk(names, scenario);
  if (names.has_planned_gaits) {
    if (!is_khr2) set_planned_elkahlout(scenario);
    set_planned_walk(scenario);
  }
  share_numbers(scenario);
  return scenario;
}

}  // namespace surefoot::scenario
