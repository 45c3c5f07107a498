#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {
namespace {

constexpr std::array kStopProfiles{"ramp", "quintic"};

void append_posture(std::vector<Field>& table, safety::StartPostureConfig& posture) {
  table.insert(table.end(), {Field{"posture.joint_tolerance_rad",
                                   &posture.joint_tolerance_rad,
                                   {0.0, 3.0, true},
                                   "rad",
                                   "distance of a joint from standing up to which torques may begin"},
                             Field{"posture.max_tilt_rad",
                                   &posture.max_tilt_rad,
                                   {0.0, 1.5, true},
                                   "rad",
                                   "tilt of the torso up to which torques may begin"},
                             Field{"posture.min_foot_force_n",
                                   &posture.min_foot_force_n,
                                   {0.0, 5000.0},
                                   "N",
                                   "force on each foot from which on torques may begin"}});
}

void append_foot_check(std::vector<Field>& table, safety::FootCheckConfig& foot) {
  table.insert(
      table.end(),
      {Field{"plausibility.foot_frozen_s",
             &foot.frozen_s,
             {0.0, 600.0, true},
             "s",
             "time of walking in which a load cell may repeat itself, more than a gait cycle"},
       Field{"plausibility.foot_frozen_loaded_s",
             &foot.frozen_loaded_s,
             {0.0, 600.0, true},
             "s",
             "the same for a load cell that carries something"},
       Field{"plausibility.foot_loaded_n", &foot.loaded_n, {0.0, 1000.0}, "N", "force from which a cell carries"},
       Field{"plausibility.min_weight_share",
             &foot.min_weight_share,
             {0.0, 1.0},
             "1",
             "least share of the standing weight that the feet must feel"},
       Field{"plausibility.max_weight_share",
             &foot.max_weight_share,
             {1.0, 10.0},
             "1",
             "largest share of the standing weight that the feet may feel"},
       Field{"plausibility.weight_s", &foot.weight_s, {0.0, 60.0, true}, "s", "time for which they may feel another"}});
}

void append_plausibility(std::vector<Field>& table, safety::PlausibilityConfig& config) {
  table.insert(table.end(), {Field{"plausibility.encoder_residual_rad",
                                   &config.encoder.residual_limit_rad,
                                   {0.0, 3.0, true},
                                   "rad",
                                   "disagreement of angle and rate of a joint beyond which a fault latches"},
                             Field{"plausibility.encoder_time_constant_s",
                                   &config.encoder.time_constant_s,
                                   {0.02, 60.0},
                                   "s",
                                   "time after which that disagreement is forgotten"}});
  append_foot_check(table, config.foot);
  table.insert(table.end(), {Field{"plausibility.imu_frozen_s",
                                   &config.imu.frozen_s,
                                   {0.0, 600.0, true},
                                   "s",
                                   "time of walking in which the torso IMU may repeat itself"},
                             Field{"plausibility.imu_max_force_m_s2",
                                   &config.imu.max_force_m_s2,
                                   {10.0, 1000.0},
                                   "m/s2",
                                   "specific force beyond which a fault latches, filtered"},
                             Field{"plausibility.imu_time_constant_s",
                                   &config.imu.force_time_constant_s,
                                   {0.001, 60.0},
                                   "s",
                                   "time constant of that filter"}});
}

}  // namespace

void append_safety_fields(std::vector<Field>& table, Scenario& scenario) {
  ControllerConfig& firmware = scenario.firmware;
  append_posture(table, firmware.posture);
  append_plausibility(table, firmware.plausibility);
  table.insert(
      table.end(),
      {choice_field("stop.profile", firmware.stop.profile, kStopProfiles, "way the feet come down after a fault"),
       Field{"stop.duration_s", &firmware.stop.duration_s, {0.01, 5.0}, "s", "time in which they do"}});
}

}  // namespace surefoot::scenario
