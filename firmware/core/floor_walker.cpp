#include "firmware/core/floor_walker.hpp"

#include "firmware/core/kinematics/leg_kinematics.hpp"

namespace surefoot {
namespace {

using stabilizer::PhaseSample;
using stabilizer::StabilizerInput;
using stabilizer::WalkView;

void read_legs_and_feet(const FloorWalkerConfig& config, const geometry::RobotGeometry& geometry,
                        const SensorSnapshot& sensors, const PerSide<double>& planned_foot_pitch_rad,
                        StabilizerInput& input) noexcept {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    input.ankle[i] = estimation::ankle_load(geometry, sensors.foot[i], config.ankle_range);
    input.hip_roll_rate_rad_s[i] = sensors.leg_inertial[i].hip_roll_rate_rad_s;
    input.foot_roll_rad[i] = sensors.foot_inertial[i].roll_rad;
    input.foot_pitch_rad[i] = sensors.foot_inertial[i].pitch_rad - planned_foot_pitch_rad[i];
    input.foot_lateral_force_m_s2[i] = sensors.foot_inertial[i].specific_force_y_foot_m_s2;
  }
}

PhaseSample measure(const StabilizerInput& input, const estimation::Attitude& torso) noexcept {
  const std::size_t support = index(input.walk.support());
  return {.torso_roll_rad = torso.roll_rad,
          .torso_pitch_rad = torso.pitch_rad,
          .torso_roll_rate_rad_s = torso.roll_rate_rad_s,
          .torso_pitch_rate_rad_s = torso.pitch_rate_rad_s,
          .zmp_x_foot_m = input.ankle[support].zmp_x_foot_m(),
          .zmp_y_foot_m = input.ankle[support].zmp_y_foot_m(),
          .support_roll_rate_rad_s = input.hip_roll_rate_rad_s[support]};
}

/// The foot whose step's clock runs: in double support the next one to be lifted.
Side stepping_foot(const WalkView& walk) noexcept {
  return walk.is_double_support ? opposite(walk.moving) : walk.moving;
}

/// What the payload reflex adds to the pelvis' place; nothing before the first step and after the last.
double answer_payload(const FloorWalkerConfig& config, const decision::PayloadDetectorConfig& detector, bool answers,
                      FloorWalkerState& state, const estimation::Estimate& estimate, const StabilizerInput& input,
                      double period_s) noexcept {
  decision::PayloadShiftState& payload = state.payload;
  if (state.walk.steps == 0 || state.walk.stage == decision::WalkStage::kStanding) {
    payload.event.reset();
    payload.is_payload_seen = false;
    return payload.offset_m.position;
  }
  const double carried_before_kg = payload.added_mass_kg;
  const double offset_m = step(config.payload, detector, payload,
                               {.vertical_force_n = estimate.vertical_force_n,
                                .filtered_force_n = estimate.filtered_force_n,
                                .zmp_x_foot_m = input.measured.zmp_x_foot_m,
                                .answers = answers && !state.walk.stops},
                               period_s);
  constexpr double kGravity_m_s2 = 9.81;
  state.standing_force_n += (payload.added_mass_kg - carried_before_kg) * kGravity_m_s2;
  return offset_m;
}

void turn_joints(const stabilizer::Adjustment& adjust, JointReference& joints) noexcept {
  for (const Side side : kSides) {
    LegVector& angle_rad = joints.angle_rad[index(side)];
    angle_rad[index(LegJoint::kHipRoll)] += adjust.hip_roll_rad[index(side)];
    angle_rad[index(LegJoint::kAnklePitch)] += adjust.ankle_pitch_rad[index(side)];
    angle_rad[index(LegJoint::kAnkleRoll)] += adjust.ankle_roll_rad[index(side)];
  }
}

}  // namespace

FloorWalkerOutput step(const FloorWalkerConfig& config, const gait::WalkParameters& walk,
                       const geometry::RobotGeometry& geometry, const decision::PayloadDetectorConfig& detector,
                       bool answers, FloorWalkerState& state, const SensorSnapshot& sensors,
                       const estimation::Estimate& estimate, bool stops, double period_s) noexcept {
  FloorWalkerOutput out;
  StabilizerInput& input = out.input;
  input.period_s = period_s;
  input.body_mass_kg = config.body_mass_kg + state.payload.added_mass_kg;
  input.sole = {
      .toe_m = geometry.sole_toe_m, .heel_m = geometry.sole_heel_m, .half_width_m = 0.5 * geometry.sole_width_m};
  read_legs_and_feet(config, geometry, sensors, state.planned_foot_pitch_rad, input);
  const estimation::Attitude torso = estimation::step(config.attitude, state.attitude, sensors.torso, period_s);

  input.walk = gait::advance(walk, config.pattern, state.walk, input.ankle, state.last, stops, period_s);
  if (input.walk.stage == decision::WalkStage::kStanding) state.standing_force_n = estimate.filtered_force_n;
  input.measured = measure(input, torso);
  const bool is_stepping = decision::is_lifting(input.walk.stage) || decision::is_lowering(input.walk.stage);
  if (is_stepping) input.nominal = config.nominal.at(stepping_foot(input.walk), input.walk.step_share);

  out.adjustment = stabilizer::step(config.stabilizer, state.stabilizer, input);
  state.last = out.adjustment.total;
  stabilizer::Adjustment adjusted = state.last;
  adjusted.pelvis_x_m += answer_payload(config, detector, answers, state, estimate, input, period_s);
  out.foot_reference = gait::foot_reference(walk, config.pattern, state.walk, adjusted);
  out.planned_zmp_x_foot_m = gait::planned_zmp_x_foot_m(config.pattern, state.walk, geometry.ankle_height_m);
  for (const Side side : kSides) state.planned_foot_pitch_rad[index(side)] = out.foot_reference[index(side)].pitch_rad;
  out.joint_reference = kinematics::inverse(geometry, out.foot_reference);
  turn_joints(state.last, out.joint_reference);
  return out;
}

}  // namespace surefoot
