#include <fmt/format.h>

#include "tools/scenario/controller_fields.hpp"

namespace surefoot::scenario {
namespace {

/// A time constant of a controller's output or of one of its filters.
Field time_field(const char* name, double& member, const char* doc) {
  return {fmt::format("stabilizer.{}", name), &member, {0.0, 60.0}, "s", doc};
}

Field rate_field(const char* name, double& member, const char* unit) {
  return {fmt::format("stabilizer.{}", name), &member, {0.0, 1000.0, true}, unit, "fastest change of the output"};
}

}  // namespace

void append_smoothing_fields(std::vector<Field>& table, stabilizer::StabilizerConfig& c) {
  const char* const fades = "time constant with which it fades in and out";
  const char* const smooths = "time constant of the output's smoothing";
  table.insert(
      table.end(),
      {time_field("upright_pose_fade_s", c.upright_pose.fade_s, fades),
       rate_field("landing_momentum_max_rate_rad_s", c.landing_momentum.max_rate_rad_s, "rad/s"),
       rate_field("landing_timing_max_rate_s_per_s", c.landing_timing.max_rate_s_per_s, "s/s"),
       time_field("landing_position_smoothing_s", c.landing_position.smoothing_s, smooths),
       rate_field("landing_position_max_rate_m_s", c.landing_position.max_rate_m_s, "m/s"),
       time_field("landing_position_fade_s", c.landing_position.fade_s, fades),
       rate_field("vibration_reduction_max_rate_rad_s", c.vibration_reduction.max_rate_rad_s, "rad/s"),
       time_field("vibration_reduction_fade_s", c.vibration_reduction.fade_s, fades),
       time_field("damping_smoothing_s", c.damping.smoothing_s, smooths),
       time_field("soft_landing_fade_s", c.soft_landing.fade_s, fades),
       time_field("sway_amplitude_time_constant_s", c.sway_amplitude.time_constant_s,
                  "time constant of the ZMP's low pass"),
       time_field("sway_amplitude_smoothing_s", c.sway_amplitude.smoothing_s, smooths),
       time_field("torso_tilt_smoothing_s", c.torso_tilt.smoothing_s, smooths),
       time_field("tilt_over_smoothing_s", c.tilt_over.smoothing_s, smooths),
       time_field("tilt_landing_position_smoothing_s", c.tilt_landing_position.smoothing_s, smooths),
       time_field("attitude_feedback_load_time_constant_s", c.attitude_feedback.load_time_constant_s,
                  "time constant of the shares of the load"),
       time_field("attitude_feedback_fade_s", c.attitude_feedback.fade_s, fades),
       time_field("foot_tilt_slope_time_constant_s", c.foot_tilt.slope_time_constant_s,
                  "time constant with which the floor's slope is learned"),
       time_field("step_adjustment_freeze_s", c.step_adjustment.freeze_s, "time before the landing without a change"),
       time_field("step_adjustment_smoothing_s", c.step_adjustment.smoothing_s, smooths)});
  table.insert(table.end(), {Field{"stabilizer.landing_momentum_half_width_m",
                                   &c.landing_momentum.half_width_m,
                                   {0.0, 0.5},
                                   "m",
                                   "half width of the sole, which bounds the moment"},
                             Field{"stabilizer.zmp_compensator_max_zmp_error_m",
                                   &c.zmp_compensator.max_zmp_error_m,
                                   {0.0, 1.0},
                                   "m",
                                   "largest error of the ZMP that counts"},
                             Field{"stabilizer.sway_amplitude_zmp_per_sway",
                                   &c.sway_amplitude.zmp_per_sway,
                                   {0.1, 100.0},
                                   "1",
                                   "way of the ZMP per sway, 1 + l w^2 / g"},
                             Field{"stabilizer.tilt_landing_position_settled_share",
                                   &c.tilt_landing_position.settled_share,
                                   {0.0, 1.0},
                                   "1",
                                   "share of the swing from which the landing point stays"}});
}

}  // namespace surefoot::scenario
