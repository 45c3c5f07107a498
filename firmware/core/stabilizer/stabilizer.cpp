#include "firmware/core/stabilizer/stabilizer.hpp"

#include <algorithm>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr bool is_on(const Switches& switches, Controller controller) noexcept {
  return switches[static_cast<std::size_t>(controller)];
}

Adjustment step_one(Controller controller, const StabilizerConfig& config, StabilizerState& state,
                    const StabilizerInput& input) noexcept {
  const bool acts = is_active(controller, input.walk);
  switch (controller) {
    case Controller::kUprightPose:
      return step(config.upright_pose, state.upright_pose, input, acts);
    case Controller::kLandingMomentum:
      return step(config.landing_momentum, state.landing_momentum, input, acts);
    case Controller::kShockAbsorber:
      return step(config.shock_absorber, state.shock_absorber, input, acts);
    case Controller::kLandingTiming:
      return step(config.landing_timing, state.landing_timing, input, acts);
    case Controller::kLandingPosition:
      return step(config.landing_position, state.landing_position, input, acts);
    case Controller::kVibrationReduction:
      return step(config.vibration_reduction, state.vibration_reduction, input, acts);
    case Controller::kDamping:
      return step(config.damping, state.damping, input, acts);
    case Controller::kZmpCompensator:
      return step(config.zmp_compensator, state.zmp_compensator, input, acts);
    case Controller::kSoftLanding:
      return step(config.soft_landing, state.soft_landing, input, acts);
    case Controller::kSwayAmplitude:
      return step(config.sway_amplitude, state.sway_amplitude, input, acts);
    case Controller::kTorsoTilt:
      return step(config.torso_tilt, state.torso_tilt, input, acts);
    case Controller::kTiltOver:
      return step(config.tilt_over, state.tilt_over, input, acts);
    case Controller::kTiltLandingPosition:
      return step(config.tilt_landing_position, state.tilt_landing_position, input, acts);
    case Controller::kAttitudeFeedback:
      return step(config.attitude_feedback, state.attitude_feedback, input, acts);
    case Controller::kFootTilt:
      return step(config.foot_tilt, state.foot_tilt, input, acts);
    case Controller::kStepAdjustment:
      return step(config.step_adjustment, state.step_adjustment, input, acts);
    case Controller::kGroundSeeking:
      return step(config.ground_seeking, state.ground_seeking, input, acts);
  }
  return {};
}

Adjustment orientation_of(const Adjustment& all) noexcept {
  Adjustment orientation;
  orientation.ankle_roll_rad = all.ankle_roll_rad;
  orientation.ankle_pitch_rad = all.ankle_pitch_rad;
  return orientation;
}

/// What a controller's output is worth beside the others that are on.
Adjustment after_precedence(Controller controller, const Switches& switches, Adjustment adjustment) noexcept {
  if (controller == Controller::kTiltLandingPosition && is_on(switches, Controller::kLandingPosition)) {
    adjustment.landing_y_m = 0.0;
  }
  const bool others_soften = is_on(switches, Controller::kShockAbsorber) || is_on(switches, Controller::kLandingTiming);
  if (controller == Controller::kSoftLanding && others_soften) return orientation_of(adjustment);
  return adjustment;
}

void clip(double& value, double limit) noexcept { value = std::clamp(value, -limit, limit); }

void clip(Adjustment& total, const AdjustmentLimits& limits) noexcept {
  for (double* pelvis_m : {&total.pelvis_x_m, &total.pelvis_y_m, &total.pelvis_z_m}) clip(*pelvis_m, limits.pelvis_m);
  for (const Side side : kSides) {
    clip(total.leg_length_m[index(side)], limits.leg_m);
    clip(total.ankle_roll_rad[index(side)], limits.ankle_rad);
    clip(total.ankle_pitch_rad[index(side)], limits.ankle_rad);
  }
  clip(total.landing_x_m, limits.landing_m);
  clip(total.landing_y_m, limits.landing_m);
}

}  // namespace

Switches paper_set() noexcept {
  Switches switches{};
  for (const ActivationRow& row : kActivation) {
    switches[static_cast<std::size_t>(row.controller)] = row.controller <= Controller::kTiltLandingPosition;
  }
  return switches;
}

Switches extended_set() noexcept {
  Switches switches{};
  for (const Controller controller :
       {Controller::kUprightPose, Controller::kLandingMomentum, Controller::kShockAbsorber, Controller::kDamping,
        Controller::kZmpCompensator, Controller::kAttitudeFeedback, Controller::kFootTilt,
        Controller::kGroundSeeking}) {
    switches[static_cast<std::size_t>(controller)] = true;
  }
  return switches;
}

StabilizerOutput step(const StabilizerConfig& config, StabilizerState& state, const StabilizerInput& given) noexcept {
  StabilizerInput input = given;
  if (!is_usable_period(input.period_s)) input.period_s = 0.0;  // everybody holds
  StabilizerOutput output;
  for (const ActivationRow& row : kActivation) {
    if (!is_on(config.is_on, row.controller)) continue;
    Adjustment& one = output.of[static_cast<std::size_t>(row.controller)];
    one = after_precedence(row.controller, config.is_on, step_one(row.controller, config, state, input));
    output.total += one;
  }
  clip(output.total, config.limits);
  return output;
}

}  // namespace surefoot::stabilizer
