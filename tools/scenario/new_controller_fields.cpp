#include <string>
#include <vector>

#include "tools/scenario/controller_fields.hpp"
#include "tools/scenario/field_builders.hpp"

namespace surefoot::scenario {

namespace {

void append_switches(std::vector<Field>& table, stabilizer::Switches& is_on) {
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    const std::string controller = stabilizer::name(row.controller);
    table.push_back(flag_field("stabilizer." + controller, is_on[static_cast<std::size_t>(row.controller)],
                               "whether this controller acts, within its schedule"));
  }
}

void append_upright_pose(std::vector<Field>& table, stabilizer::UprightPoseConfig& config) {
  const std::string prefix = "stabilizer.upright_pose_";
  table.insert(
      table.end(),
      {Field{prefix + "kp", &config.kp, {0.0, 10.0}, "1", "share of the filtered inclination that is made up for"},
       Field{prefix + "ki_per_s", &config.ki_per_s, {0.0, 10.0}, "1/s", "gain of its integral"},
       Field{prefix + "filter_s", &config.filter_s, {0.0, 60.0, true}, "s", "filter of the torso's inclination"},
       Field{prefix + "hip_spacing_m", &config.hip_spacing_m, {0.01, 1.0}, "m", "distance between the legs"},
       Field{prefix + "max_angle_rad", &config.max_angle_rad, {0.0, 0.5}, "rad", "steepest floor made up for"}});
}

void append_landing_momentum(std::vector<Field>& table, stabilizer::LandingMomentumConfig& config) {
  const std::string prefix = "stabilizer.landing_momentum_";
  table.insert(
      table.end(),
      {Field{prefix + "inertia_kg_m2", &config.inertia_kg_m2, {1.0, 500.0}, "kg m2", "inertia about the landing foot"},
       flag_field(prefix + "uses_nominal", config.uses_nominal, "flat walking's momentum as the desired one"),
       Field{prefix + "printed_nms", &config.printed_momentum_nms, {-200.0, 200.0}, "N m s", "desired one otherwise"},
       Field{prefix + "range_nms", &config.range_nms, {0.0, 100.0}, "N m s", "deviation that calls for nothing"},
       Field{prefix + "window_s", &config.window_s, {0.01, 1.0}, "s", "longest action after a landing"},
       Field{prefix + "max_moment_nm", &config.max_moment_nm, {0.0, 200.0}, "N m", "largest moment asked for"},
       Field{prefix + "kp_rad_per_nm", &config.kp_rad_per_nm, {0.0, 0.01}, "rad/(N m)", "ankle per error of moment"},
       Field{prefix + "ki_rad_per_nms", &config.ki_rad_per_nms, {0.0, 1.0}, "rad/(N m s)", "gain of its integral"},
       Field{prefix + "max_angle_rad", &config.max_angle_rad, {0.0, 0.2}, "rad", "largest ankle angle"},
       Field{prefix + "standing_fade_s",
             &config.standing_fade_s,
             {0.0, 600.0, true},
             "s",
             "time constant with which the angle of a standing foot returns"},
       Field{prefix + "fade_s", &config.fade_s, {0.0, 10.0, true}, "s", "time constant of a lifted foot's return"}});
}

void append_shock_absorber(std::vector<Field>& table, stabilizer::ShockAbsorberConfig& config) {
  const std::string prefix = "stabilizer.shock_absorber_";
  table.insert(
      table.end(),
      {Field{prefix + "mass_kg", &config.mass_kg, {0.1, 500.0}, "kg", "virtual mass, m of eq. (11)"},
       Field{prefix + "damping_ns_per_m", &config.damping_ns_per_m, {0.0, 1e5}, "N s/m", "virtual damper, c"},
       Field{prefix + "stiffness_n_per_m", &config.stiffness_n_per_m, {100.0, 1e7}, "N/m", "virtual spring, k"},
       Field{prefix + "latest_share",
             &config.latest_share,
             {0.5, 1.0},
             "1",
             "place in the swing up to which a contact is an early landing"},
       Field{prefix + "max_offset_m", &config.max_offset_m, {0.0, 0.1}, "m", "largest way of the pelvis"},
       Field{prefix + "washout_s", &config.washout_s, {0.0, 10.0, true}, "s", "time constant of the way back"}});
}

void append_landing_timing(std::vector<Field>& table, stabilizer::LandingTimingConfig& config) {
  const std::string prefix = "stabilizer.landing_timing_";
  table.insert(
      table.end(),
      {flag_field(prefix + "uses_nominal", config.uses_nominal, "window about flat walking's turn, not the foot's top"),
       Field{prefix + "before_s", &config.before_s, {-0.5, 0.5}, "s", "begin of the window before that"},
       Field{prefix + "max_earlier_s", &config.max_earlier_s, {0.0, 0.5}, "s", "largest advance of a landing"},
       Field{prefix + "hysteresis_rad_s",
             &config.hysteresis_rad_s,
             {0.0, 1.0},
             "rad/s",
             "roll rate to either side that makes a turn certain"}});
}

void append_landing_position(std::vector<Field>& table, stabilizer::LandingPositionConfig& config) {
  const std::string prefix = "stabilizer.landing_position_";
  table.insert(
      table.end(),
      {Field{prefix + "inertia_kg_m2", &config.inertia_kg_m2, {1.0, 500.0}, "kg m2", "inertia about the landing foot"},
       Field{prefix + "contact_s", &config.contact_s, {0.01, 1.0}, "s", "duration of the contact, Delta t"},
       flag_field(prefix + "uses_nominal", config.uses_nominal, "flat walking's landing as the planned one"),
       Field{prefix + "printed_nms", &config.printed_momentum_nms, {-200.0, 200.0}, "N m s", "momentum after landing"},
       Field{prefix + "printed_distance_m", &config.printed_distance_m, {0.0, 0.5}, "m", "planned distance otherwise"},
       Field{prefix + "kp", &config.kp, {0.0, 2.0}, "1", "share of the wanted shift"},
       Field{prefix + "max_shift_m", &config.max_shift_m, {0.0, 0.2}, "m", "largest shift"},
       Field{prefix + "single_support_s", &config.single_support_s, {0.05, 10.0}, "s", "length of the swing"},
       Field{prefix + "freeze_s", &config.freeze_s, {0.0, 0.5}, "s", "time before the landing without a change"}});
}

void append_vibration_reduction(std::vector<Field>& table, stabilizer::VibrationReductionConfig& config) {
  const std::string prefix = "stabilizer.vibration_reduction_";
  table.insert(
      table.end(),
      {Field{prefix + "gain_s", &config.gain_s, {0.0, 1.0}, "s", "hip angle per rate of the swinging leg, K"},
       Field{prefix + "leak_rad_s", &config.leak_rad_s, {0.01, 100.0}, "rad/s", "leak of the integral, epsilon"},
       Field{prefix + "high_pass_rad_s", &config.high_pass_rad_s, {0.01, 100.0}, "rad/s", "high-pass filter"},
       Field{prefix + "leg_length_m", &config.leg_length_m, {0.05, 2.0}, "m", "hip to sole"},
       Field{prefix + "max_angle_rad", &config.max_angle_rad, {0.0, 0.1}, "rad", "largest hip angle"}});
}

}  // namespace

void append_new_controller_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& config) {
  append_switches(table, config.is_on);
  append_upright_pose(table, config.upright_pose);
  append_landing_momentum(table, config.landing_momentum);
  append_shock_absorber(table, config.shock_absorber);
  append_landing_timing(table, config.landing_timing);
  append_landing_position(table, config.landing_position);
  append_vibration_reduction(table, config.vibration_reduction);
}

}  // namespace surefoot::scenario
