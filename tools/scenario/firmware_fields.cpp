#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {
namespace {

constexpr std::array kReflexMethods{"off", "original", "modified", "capture"};
constexpr std::array kReflexProfiles{"ramp", "quintic"};
constexpr std::array kRestorationTimings{"acos_factor", "nominal_cosine"};

void append_gait(std::vector<Field>& table, gait::WalkParameters& walk) {
  table.insert(
      table.end(),
      {Field{"gait.single_support_s", &walk.single_support_s, {0.05, 10.0}, "s", "time with one foot in the air, t_ss"},
       Field{"gait.double_support_s", &walk.double_support_s, {0.01, 10.0}, "s", "time with both feet down, t_ds"},
       Field{"gait.half_step_m",
             &walk.half_step_m,
             {0.0, 0.5, true},
             "m",
             "half travel of a foot about the reference, b_s"},
       Field{"gait.reference_x_body_m", &walk.reference_x_body_m, {-0.5, 0.5}, "m", "midpoint of the feet, x_ref_as"},
       Field{"gait.reference_y_body_m", &walk.reference_y_body_m, {-0.5, 0.5}, "m", "midpoint of the feet, y_ref_as"},
       Field{"gait.foot_offset_y_m",
             &walk.foot_offset_y_m,
             {0.01, 0.5},
             "m",
             "distance of a foot from the midline, w_of"},
       Field{"gait.sway_m", &walk.sway_m, {0.0, 0.5}, "m", "amplitude of the lateral sway, w"},
       Field{
           "gait.body_height_m", &walk.body_height_m, {0.1, 2.0}, "m", "height of the body frame above the soles, h_b"},
       Field{"gait.swing_height_m", &walk.swing_height_m, {0.0, 0.3}, "m", "apex of the swing foot, h_s"}});
}

void append_estimation(std::vector<Field>& table, estimation::EstimatorConfig& estimator) {
  table.insert(table.end(), {Field{"estimation.force_time_constant_s",
                                   &estimator.force_time_constant_s,
                                   {1e-3, 60.0},
                                   "s",
                                   "time constant of the vertical force filter, eq. (3.7)"},
                             Field{"estimation.zmp_time_constant_s",
                                   &estimator.zmp_time_constant_s,
                                   {1e-3, 60.0},
                                   "s",
                                   "time constant of the ZMP filter, eq. (3.18)"},
                             Field{"estimation.min_force_for_zmp_n",
                                   &estimator.min_force_for_zmp_n,
                                   {0.0, 2000.0, true},
                                   "N",
                                   "vertical force below which the ZMP keeps its value"}});
}

void append_capture(std::vector<Field>& table, decision::CaptureConfig& capture) {
  table.insert(table.end(), {Field{"reflex.capture_com_height_m",
                                   &capture.com_height_m,
                                   {0.05, 3.0},
                                   "m",
                                   "height of the centre of mass, for the linear inverted pendulum"},
                             Field{"reflex.capture_load_shift_m",
                                   &capture.load_shift_m,
                                   {0.0, 0.5},
                                   "m",
                                   "way of the centre of mass under the load that the capture step is designed for"},
                             Field{"reflex.capture_tilt_back_rad_s",
                                   &capture.tilt_back_rad_s,
                                   {0.0, 30.0},
                                   "rad/s",
                                   "backward rise of the pitch rate that tells of a load at the back"},
                             Field{"reflex.capture_tilt_margin_rad_s",
                                   &capture.tilt_margin_rad_s,
                                   {0.0, 30.0},
                                   "rad/s",
                                   "rate of roll or pitch above the learned ones at which balance is lost"},
                             Field{"reflex.capture_max_step_m",
                                   &capture.max_step_m,
                                   {0.0, 0.5},
                                   "m",
                                   "longest way of the swing foot against the body within the capture step"},
                             Field{"reflex.capture_leg_use",
                                   &capture.leg_use,
                                   {0.1, 1.0},
                                   "1",
                                   "share of the stretched leg that the capture step may use"},
                             Field{"reflex.capture_shift_acceleration_m_s2",
                                   &capture.shift_acceleration_m_s2,
                                   {0.01, 10.0},
                                   "m/s2",
                                   "peak acceleration of the capture method's shift of the feet"},
                             Field{"reflex.capture_max_lateral_shift_m",
                                   &capture.max_lateral_shift_m,
                                   {0.0, 0.5},
                                   "m",
                                   "bound on one lateral adaptation of the capture method"}});
}

void append_reflex(std::vector<Field>& table, decision::PayloadDetectorConfig& detector,
                   decision::ReflexConfig& reflex) {
  table.insert(
      table.end(),
      {Field{"detector.warm_up_s", &detector.warm_up_s, {0.0, 600.0}, "s", "walking time before learning starts"},
       Field{"detector.learning_s",
             &detector.learning_s,
             {0.0, 600.0, true},
             "s",
             "time over which the largest unloaded force is learned, at least one gait cycle"},
       Field{"detector.margin_n", &detector.margin_n, {0.0, 1000.0}, "N", "margin above the largest learned force"},
       Field{"detector.relearning_s",
             &detector.relearning_s,
             {0.0, 60.0},
             "s",
             "time of learning after a recovery; where not given 2.4, or 4.8 with capture"},
       Field{"detector.resume_margin_n",
             &detector.resume_margin_n,
             {0.0, 1000.0},
             "N",
             "threshold raised by this from a recovery until the loaded walk is learned"},
       choice_field("reflex.method", reflex.method, kReflexMethods,
                    "reflex that answers a payload; on khr2 every one but off moves its pelvis (payload_shift)"),
       flag_field("reflex.mirrored", reflex.mirrored, "mirroring of eq. (3.17) when the right foot swings"),
       choice_field("reflex.profile", reflex.profile, kReflexProfiles, "way the feet move into the reflex stance"),
       choice_field("reflex.timing", reflex.timing, kRestorationTimings, "law for the duration of the restoring step"),
       Field{"reflex.reflex_s", &reflex.reflex_s, {0.01, 5.0}, "s", "duration of the reflex movement, t_refl"},
       Field{"reflex.settling_s",
             &reflex.settling_s,
             {0.01, 60.0},
             "s",
             "settling time, t_set; where not given 2, 4 with the modified method, 3 with capture"},
       Field{"reflex.shift_s", &reflex.shift_s, {0.01, 60.0}, "s", "duration of the shift of the feet, t_x"},
       Field{"reflex.foot_offset_m",
             &reflex.foot_offset_m,
             {0.0, 0.2},
             "m",
             "foot offset of the reflex stance, |x_refl|"},
       Field{"reflex.standing_s", &reflex.standing_s, {0.01, 600.0}, "s", "standing time before the first step"},
       Field{"reflex.max_shift_m", &reflex.max_shift_m, {0.0, 0.5}, "m", "bound on one adaptation a"},
       Field{"reflex.balance_offset_m",
             &reflex.balance_offset_m,
             {-0.2, 0.2},
             "m",
             "distance of the balance ZMP behind the measured standing ZMP"}});
}

Field gains_field(std::string key, servo::ServoConfig& servo, double servo::JointGains::*gain, double max,
                  std::string unit, std::string doc) {
  Numbers numbers;
  for (servo::JointGains& joint : servo.gains) numbers.push_back(&(joint.*gain));
  return {std::move(key), std::move(numbers), {0.0, max}, std::move(unit), std::move(doc)};
}

void append_servo(std::vector<Field>& table, servo::ServoConfig& servo) {
  // The CAN frames carry torques to 300 N m.
  table.insert(table.end(), {gains_field("servo.kp_nm_per_rad", servo, &servo::JointGains::kp_nm_per_rad, 1e6,
                                         "N m/rad", "proportional gains from hip yaw to ankle roll"),
                             gains_field("servo.ki_nm_per_rad_s", servo, &servo::JointGains::ki_nm_per_rad_s, 1e6,
                                         "N m/(rad s)", "integral gains from hip yaw to ankle roll"),
                             gains_field("servo.kd_nm_s_per_rad", servo, &servo::JointGains::kd_nm_s_per_rad, 1e4,
                                         "N m s/rad", "derivative gains from hip yaw to ankle roll")});
}

void append_gate(std::vector<Field>& table, safety::OutputGateConfig& gate) {
  table.insert(table.end(), {Field{"gate.torque_limit_nm",
                                   &gate.torque_limit_nm,
                                   {0.0, 300.0, true},
                                   "N m",
                                   "largest torque that leaves the firmware"},
                             Field{"gate.torque_rate_limit_nm_s",
                                   &gate.torque_rate_limit_nm_s,
                                   {0.0, 1e9, true},
                                   "N m/s",
                                   "fastest change of a torque"},
                             Field{"gate.joint_rate_limit_rad_s",
                                   &gate.joint_rate_limit_rad_s,
                                   {0.0, 30.0, true},
                                   "rad/s",
                                   "joint rate beyond which a fault latches"},
                             Field{"gate.reference_rate_limit_rad_s",
                                   &gate.reference_rate_limit_rad_s,
                                   {0.0, 30.0, true},
                                   "rad/s",
                                   "fastest change of the angles sent to a leg board's own servo"},
                             array_field("gate.angle_min_rad", gate.angle_min_rad, {-3.2, 3.2}, "rad",
                                         "lower ends of the joints' ranges, hip yaw to ankle roll"),
                             array_field("gate.angle_max_rad", gate.angle_max_rad, {-3.2, 3.2}, "rad",
                                         "upper ends of the joints' ranges, hip yaw to ankle roll"),
                             Field{"gate.ride_through_ticks",
                                   &gate.ride_through_ticks,
                                   {0.0, 1000.0},
                                   "ticks",
                                   "time a node may be silent before a fault latches"}});
}

void append_geometry(std::vector<Field>& table, geometry::RobotGeometry& geometry) {
  table.insert(
      table.end(),
      {Field{"geometry.hip_x_body_m", &geometry.hip_x_body_m, {-0.5, 0.5}, "m", "hip axes ahead of the body frame"},
       Field{"geometry.hip_y_body_m", &geometry.hip_y_body_m, {0.01, 0.5}, "m", "distance of a hip from the midline"},
       Field{"geometry.thigh_m", &geometry.thigh_m, {0.05, 1.0}, "m", "length from hip to knee"},
       Field{"geometry.calf_m", &geometry.calf_m, {0.05, 1.0}, "m", "length from knee to ankle"},
       Field{
           "geometry.ankle_height_m", &geometry.ankle_height_m, {0.01, 0.5}, "m", "height of the ankle above the sole"},
       Field{"geometry.sole_heel_m", &geometry.sole_heel_m, {0.01, 0.5}, "m", "distance from ankle to rear edge"},
       Field{"geometry.sole_toe_m", &geometry.sole_toe_m, {0.01, 0.5}, "m", "distance from ankle to front edge"},
       Field{"geometry.sole_width_m", &geometry.sole_width_m, {0.01, 0.5}, "m", "width of a sole"}});
}

}  // namespace

void append_firmware_fields(std::vector<Field>& table, Scenario& scenario) {
  append_gait(table, scenario.firmware.walk);
  append_estimation(table, scenario.firmware.estimator);
  append_reflex(table, scenario.firmware.detector, scenario.firmware.reflex);
  append_capture(table, scenario.firmware.reflex.capture);
  append_servo(table, scenario.firmware.servo);
  append_gate(table, scenario.firmware.gate);
  append_geometry(table, scenario.firmware.geometry);
}

}  // namespace surefoot::scenario
