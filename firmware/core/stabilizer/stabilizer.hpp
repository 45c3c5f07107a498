#pragma once

#include <array>

#include "firmware/core/stabilizer/activation.hpp"
#include "firmware/core/stabilizer/attitude_feedback.hpp"
#include "firmware/core/stabilizer/damping.hpp"
#include "firmware/core/stabilizer/foot_tilt.hpp"
#include "firmware/core/stabilizer/ground_seeking.hpp"
#include "firmware/core/stabilizer/landing_momentum.hpp"
#include "firmware/core/stabilizer/landing_position.hpp"
#include "firmware/core/stabilizer/landing_timing.hpp"
#include "firmware/core/stabilizer/shock_absorber.hpp"
#include "firmware/core/stabilizer/soft_landing.hpp"
#include "firmware/core/stabilizer/step_adjustment.hpp"
#include "firmware/core/stabilizer/sway_amplitude.hpp"
#include "firmware/core/stabilizer/tilt_landing_position.hpp"
#include "firmware/core/stabilizer/tilt_over.hpp"
#include "firmware/core/stabilizer/torso_tilt.hpp"
#include "firmware/core/stabilizer/upright_pose.hpp"
#include "firmware/core/stabilizer/vibration_reduction.hpp"
#include "firmware/core/stabilizer/zmp_compensator.hpp"

namespace surefoot::stabilizer {

/// One switch for each controller, in the order of `Controller`.
using Switches = std::array<bool, kControllers>;

/// The thirteen of Kim, Park, Oh 2007.
[[nodiscard]] Switches paper_set() noexcept;

/// Those of them that help on these floors, and ours.
[[nodiscard]] Switches extended_set() noexcept;

/// Bounds on the sum of all controllers, to either side.
struct AdjustmentLimits {
  double ankle_rad = 0.15;
  double pelvis_m = 0.05;  ///< each axis
  double leg_m = 0.02;
  double landing_m = 0.05;  ///< each axis
};

struct StabilizerConfig {
  Switches is_on{};
  AdjustmentLimits limits;
  UprightPoseConfig upright_pose;
  LandingMomentumConfig landing_momentum;
  ShockAbsorberConfig shock_absorber;
  LandingTimingConfig landing_timing;
  LandingPositionConfig landing_position;
  VibrationReductionConfig vibration_reduction;
  DampingConfig damping;
  ZmpCompensatorConfig zmp_compensator;
  SoftLandingConfig soft_landing;
  SwayAmplitudeConfig sway_amplitude;
  TorsoTiltConfig torso_tilt;
  TiltOverConfig tilt_over;
  TiltLandingPositionConfig tilt_landing_position;
  AttitudeFeedbackConfig attitude_feedback;
  FootTiltConfig foot_tilt;
  StepAdjustmentConfig step_adjustment;
  GroundSeekingConfig ground_seeking;
};

struct StabilizerState {
  UprightPoseState upright_pose;
  LandingMomentumState landing_momentum;
  ShockAbsorberState shock_absorber;
  LandingTimingState landing_timing;
  LandingPositionState landing_position;
  VibrationReductionState vibration_reduction;
  DampingState damping;
  ZmpCompensatorState zmp_compensator;
  SoftLandingState soft_landing;
  SwayAmplitudeState sway_amplitude;
  TorsoTiltState torso_tilt;
  TiltOverState tilt_over;
  TiltLandingPositionState tilt_landing_position;
  AttitudeFeedbackState attitude_feedback;
  FootTiltState foot_tilt;
  StepAdjustmentState step_adjustment;
  GroundSeekingState ground_seeking;
};

struct StabilizerOutput {
  Adjustment total;                         ///< within the limits
  std::array<Adjustment, kControllers> of;  ///< what each adds, after precedence; zero when switched off
};

/// Steps every controller that is on, each as the schedule has it, and sums.
/// Precedence: the new landing position supersedes the earlier one in y; with shock absorber or landing timing on, soft
/// landing keeps only the orientation of the foot.
[[nodiscard]] StabilizerOutput step(const StabilizerConfig&, StabilizerState&, const StabilizerInput&) noexcept;

}  // namespace surefoot::stabilizer
