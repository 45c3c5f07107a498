#include <fmt/format.h>

#include "tools/scenario/controller_fields.hpp"
#include "tools/scenario/field_builders.hpp"

namespace surefoot::scenario {
namespace {

void append_damping(std::vector<Field>& table, stabilizer::DampingConfig& damping) {
  table.insert(
      table.end(),
      {Field{"stabilizer.damping_stiffness_nm_per_rad",
             &damping.stiffness_nm_per_rad,
             {100.0, 1e6},
             "N m/rad",
             "stiffness of an ankle with its servo and sole, K, that the damping reckons with"},
       Field{"stabilizer.damping_gain_s", &damping.gain_s, {0.0, 1.0}, "s", "ankle angle against the rate of lean, kd"},
       Field{"stabilizer.damping_time_constant_s",
             &damping.time_constant_s,
             {0.005, 1.0},
             "s",
             "low pass of the lean whose rate is taken"},
       Field{"stabilizer.damping_command_lag_s",
             &damping.command_lag_s,
             {0.0, 0.1},
             "s",
             "time from a command to the moment that answers it"},
       Field{"stabilizer.damping_max_angle_rad", &damping.max_angle_rad, {0.0, 0.2}, "rad", "bound on its angle"}});
}

void append_zmp_compensator(std::vector<Field>& table, stabilizer::ZmpCompensatorConfig& zmp) {
  table.insert(table.end(),
               {Field{"stabilizer.zmp_compensator_stiffness_nm_per_rad",
                      &zmp.stiffness_nm_per_rad,
                      {100.0, 1e6},
                      "N m/rad",
                      "stiffness of an ankle in the observer's model"},
                Field{"stabilizer.zmp_compensator_pendulum_m",
                      &zmp.pendulum_m,
                      {0.1, 3.0},
                      "m",
                      "length of the pendulum in the observer's model, l"},
                array_field("stabilizer.zmp_compensator_feedback_gain", zmp.feedback_gain, {-10.0, 10.0}, "1",
                            "gains from lean and its rate to the pelvis' offset, Kc, in m/rad and m s/rad"),
                array_field("stabilizer.zmp_compensator_observer_gain", zmp.observer_gain, {-1000.0, 1000.0}, "1",
                            "gains of the observer, L, in rad/(m s) and rad/(m s2)"),
                Field{"stabilizer.zmp_compensator_max_offset_m",
                      &zmp.max_offset_m,
                      {0.0, 0.2},
                      "m",
                      "bound on the pelvis' offset of the ZMP compensator"},
                Field{"stabilizer.zmp_compensator_fade_s",
                      &zmp.fade_s,
                      {0.0, 10.0},
                      "s",
                      "time constant to zero of the ZMP compensator while it may not act"}});
}

void append_soft_landing(std::vector<Field>& table, stabilizer::SoftLandingConfig& soft) {
  table.insert(table.end(), {Field{"stabilizer.soft_landing_stiffness_nm_per_rad",
                                   &soft.stiffness_nm_per_rad,
                                   {50.0, 1e6},
                                   "N m/rad",
                                   "spring of a landing ankle that yields to the floor"},
                             Field{"stabilizer.soft_landing_damping_nm_s_per_rad",
                                   &soft.damping_nm_s_per_rad,
                                   {0.0, 1e5},
                                   "N m s/rad",
                                   "damper beside this spring"},
                             Field{"stabilizer.soft_landing_band_nm",
                                   &soft.band_nm,
                                   {0.0, 60.0},
                                   "N m",
                                   "moment at landing that moves nothing"},
                             Field{"stabilizer.soft_landing_max_angle_rad",
                                   &soft.max_angle_rad,
                                   {0.0, 0.2},
                                   "rad",
                                   "bound on the angle of soft landing"}});
}

void append_once_a_step(std::vector<Field>& table, stabilizer::SwayAmplitudeConfig& sway,
                        stabilizer::TorsoTiltConfig& tilt) {
  table.insert(
      table.end(),
      {Field{"stabilizer.sway_amplitude_gain",
             &sway.gain,
             {0.0, 2.0},
             "1",
             "share of the ZMP's error that changes the pelvis' swing in a step, Ka"},
       Field{"stabilizer.sway_amplitude_kept_share",
             &sway.kept_share,
             {0.0, 1.0},
             "1",
             "share of the adapted amplitude kept from step to step"},
       Field{"stabilizer.sway_amplitude_band_m",
             &sway.band_m,
             {0.0, 0.1},
             "m",
             "error of the ZMP from which nothing is learned"},
       Field{"stabilizer.sway_amplitude_min_sway_m", &sway.min_sway_m, {0.0, 0.5}, "m", "least adapted amplitude"},
       Field{"stabilizer.sway_amplitude_max_sway_m", &sway.max_sway_m, {0.0, 0.5}, "m", "largest adapted amplitude"},
       Field{"stabilizer.torso_tilt_gain_m_per_rad",
             &tilt.gain_m_per_rad,
             {0.0, 5.0},
             "m/rad",
             "way of the swing's centre in a step against the mean tilt of the last"},
       Field{"stabilizer.torso_tilt_kept_share",
             &tilt.kept_share,
             {0.0, 1.0},
             "1",
             "share of the adapted centre kept from step to step"},
       Field{"stabilizer.torso_tilt_band_rad",
             &tilt.band_rad,
             {0.0, 0.1},
             "rad",
             "mean tilt from which nothing is learned"},
       Field{"stabilizer.torso_tilt_max_offset_m",
             &tilt.max_offset_m,
             {0.0, 0.2},
             "m",
             "bound on the adapted centre, each axis"}});
}

void append_tilt_over(std::vector<Field>& table, stabilizer::TiltOverConfig& tilt) {
  table.insert(
      table.end(),
      {Field{"stabilizer.tilt_over_gain", &tilt.gain, {0.0, 10.0}, "1", "stance ankle angle per roll beyond the band"},
       Field{"stabilizer.tilt_over_rate_gain_s",
             &tilt.rate_gain_s,
             {0.0, 1.0},
             "s",
             "stance ankle angle per roll rate beyond its band"},
       Field{"stabilizer.tilt_over_band_rad", &tilt.band_rad, {0.0, 0.5}, "rad", "band of normal roll"},
       Field{"stabilizer.tilt_over_rate_band_rad_s",
             &tilt.rate_band_rad_s,
             {0.0, 10.0},
             "rad/s",
             "band of normal roll rate"},
       Field{"stabilizer.tilt_over_max_angle_rad",
             &tilt.max_angle_rad,
             {0.0, 0.2},
             "rad",
             "bound on the angle against tilting over"}});
}

void append_landing_points(std::vector<Field>& table, stabilizer::TiltLandingPositionConfig& tilt,
                           stabilizer::StepAdjustmentConfig& step) {
  table.insert(table.end(), {Field{"stabilizer.tilt_landing_position_gain_m_per_rad",
                                   &tilt.gain_m_per_rad,
                                   {0.0, 5.0},
                                   "m/rad",
                                   "way of the landing point per tilt of the torso, k1"},
                             Field{"stabilizer.tilt_landing_position_rate_gain_m_s_rad",
                                   &tilt.rate_gain_m_s_rad,
                                   {0.0, 5.0},
                                   "m s/rad",
                                   "way of the landing point per rate of tilt, k2"},
                             Field{"stabilizer.tilt_landing_position_band_m",
                                   &tilt.band_m,
                                   {0.0, 0.1},
                                   "m",
                                   "way within which the foot lands where the pattern has it"},
                             Field{"stabilizer.tilt_landing_position_max_shift_m",
                                   &tilt.max_shift_m,
                                   {0.0, 0.2},
                                   "m",
                                   "bound on the way of the landing point"},
                             Field{"stabilizer.tilt_landing_position_max_inward_m",
                                   &tilt.max_inward_m,
                                   {0.0, 0.2},
                                   "m",
                                   "bound on its way towards the other foot"},
                             Field{"stabilizer.step_adjustment_gain",
                                   &step.gain,
                                   {0.0, 5.0},
                                   "1",
                                   "way of the landing point per deviation of the capture point"},
                             Field{"stabilizer.step_adjustment_horizon_s",
                                   &step.horizon_s,
                                   {0.0, 1.0},
                                   "s",
                                   "longest time over which the deviation is foretold"},
                             Field{"stabilizer.step_adjustment_band_m",
                                   &step.band_m,
                                   {0.0, 0.2},
                                   "m",
                                   "deviation within which the foot lands where the pattern has it"},
                             Field{"stabilizer.step_adjustment_max_shift_x_m",
                                   &step.max_shift_x_m,
                                   {0.0, 0.3},
                                   "m",
                                   "bound on the adjustment forward and back"},
                             Field{"stabilizer.step_adjustment_max_outward_m",
                                   &step.max_outward_m,
                                   {0.0, 0.3},
                                   "m",
                                   "bound on the adjustment away from the other foot"},
                             Field{"stabilizer.step_adjustment_max_inward_m",
                                   &step.max_inward_m,
                                   {0.0, 0.2},
                                   "m",
                                   "bound on the adjustment towards the other foot"}});
}

void append_ankles(std::vector<Field>& table, stabilizer::AttitudeFeedbackConfig& attitude,
                   stabilizer::FootTiltConfig& tilt) {
  table.insert(
      table.end(),
      {Field{"stabilizer.attitude_feedback_gain",
             &attitude.gain,
             {0.0, 20.0},
             "1",
             "ankle angle per deviation of the torso's angle"},
       Field{"stabilizer.attitude_feedback_nominal_share",
             &attitude.nominal_share,
             {0.0, 1.0},
             "1",
             "share of flat walking's own swing that is left to it"},
       Field{"stabilizer.attitude_feedback_standing_pitch_share",
             &attitude.standing_pitch_share,
             {0.0, 1.0},
             "1",
             "share of the turn in pitch when the robot begins to stand"},
       Field{"stabilizer.attitude_feedback_standing_fade_s",
             &attitude.standing_fade_s,
             {0.01, 600.0},
             "s",
             "time constant with which that goes over to the upright pose"},
       Field{"stabilizer.attitude_feedback_rate_gain_s",
             &attitude.rate_gain_s,
             {0.0, 1.0},
             "s",
             "seconds of the torso's rate that count as its angle"},
       Field{"stabilizer.attitude_feedback_smoothing_s",
             &attitude.smoothing_s,
             {0.0, 1.0},
             "s",
             "low pass of the angle of the attitude feedback"},
       Field{"stabilizer.attitude_feedback_max_angle_rad",
             &attitude.max_angle_rad,
             {0.0, 0.2},
             "rad",
             "bound on the angle of the attitude feedback"},
       Field{"stabilizer.attitude_feedback_max_rate_rad_s",
             &attitude.max_rate_rad_s,
             {0.0, 30.0},
             "rad/s",
             "fastest change of this angle"},
       Field{"stabilizer.foot_tilt_gain", &tilt.gain, {0.0, 1.0}, "1", "ankle angle per inclination of the sole"},
       Field{"stabilizer.foot_tilt_band_rad",
             &tilt.band_rad,
             {0.0, 0.1},
             "rad",
             "inclination of the sole that moves nothing"},
       Field{"stabilizer.foot_tilt_time_constant_s",
             &tilt.time_constant_s,
             {0.001, 10.0},
             "s",
             "low pass of the sole's inclination"},
       Field{"stabilizer.foot_tilt_max_angle_rad",
             &tilt.max_angle_rad,
             {0.0, 0.2},
             "rad",
             "bound on the angle that follows the sole"}});
}

void append_edge(std::vector<Field>& table, const char* controller, stabilizer::EdgeLimits& edge) {
  table.insert(table.end(), {Field{fmt::format("stabilizer.{}_edge_margin_m", controller),
                                   &edge.margin_m,
                                   {0.0, 0.2},
                                   "m",
                                   "distance of the ZMP from its sole's edge at which the ankle turns no further"},
                             Field{fmt::format("stabilizer.{}_edge_band_m", controller),
                                   &edge.band_m,
                                   {0.001, 1.0},
                                   "m",
                                   "way before that over which the ankle's turn slows down"}});
}

void append_ground_seeking(std::vector<Field>& table, stabilizer::GroundSeekingConfig& config) {
  table.insert(
      table.end(),
      {Field{
           "stabilizer.ground_seeking_speed_m_s", &config.speed_m_s, {0.0, 2.0}, "m/s", "growth of a late foot's leg"},
       Field{"stabilizer.ground_seeking_max_length_m", &config.max_length_m, {0.0, 0.02}, "m", "bound on that growth"},
       Field{"stabilizer.ground_seeking_settling_s",
             &config.settling_s,
             {0.01, 60.0},
             "s",
             "time constant with which the leg comes back to its length"}});
}

}  // namespace

void append_old_controller_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& config) {
  append_damping(table, config.damping);
  append_zmp_compensator(table, config.zmp_compensator);
  append_soft_landing(table, config.soft_landing);
  append_once_a_step(table, config.sway_amplitude, config.torso_tilt);
  append_tilt_over(table, config.tilt_over);
  append_landing_points(table, config.tilt_landing_position, config.step_adjustment);
  append_ankles(table, config.attitude_feedback, config.foot_tilt);
  append_edge(table, "attitude_feedback", config.attitude_feedback.edge);
  append_edge(table, "foot_tilt", config.foot_tilt.edge);
  append_ground_seeking(table, config.ground_seeking);
}

}  // namespace surefoot::scenario
