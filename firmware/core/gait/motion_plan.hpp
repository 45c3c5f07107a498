#pragma once

#include <cstdint>

#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/gait/step_restoration.hpp"
#include "firmware/core/gait/walk_parameters.hpp"

namespace surefoot::gait {

/// What the feet are doing.
enum class Motion : std::uint8_t {
  kMove,  ///< both feet from `start` to `end` in `duration_s`, then at rest; standing is a move to where one is
  kStep,  ///< the restoring step
  kWalk,  ///< the nominal walk, started from rest at `start_phase_s`
};

/// A motion from its beginning on: what the decision hands to the gait. Only the fields of its
/// `motion` count.
struct MotionPlan {
  Motion motion = Motion::kMove;
  // kMove
  MotionProfile profile = MotionProfile::kRamp;
  double duration_s = 0.0;
  FootReference start{};  ///< with velocity and acceleration, for the quintic profile
  FootReference end{};    ///< at rest
  // kStep
  StepRestoration step{};
  // kWalk
  double start_phase_s = 0.0;
  double reference_x_body_m = 0.0;
  // kStep and kWalk
  double offset_y_body_m = 0.0;  ///< of both feet, from y_ref_as
};

/// Both feet stand still at `stance`.
[[nodiscard]] MotionPlan stand(const FootReference& stance) noexcept;

/// Both feet move from `start` to `end`. By the quintic profile a foot that is about to touch down
/// reaches the floor earlier than `duration_s`: it would dip below otherwise.
///
/// @param duration_s  > 0
[[nodiscard]] MotionPlan move(const FootReference& start, const FootReference& end, MotionProfile profile,
                              double duration_s) noexcept;

/// The restoring step.
[[nodiscard]] MotionPlan restore(const StepRestoration& step, double offset_y_body_m = 0.0) noexcept;

/// The nominal walk from `start_phase_s` on, with the sway faded in.
[[nodiscard]] MotionPlan walk_on(double start_phase_s, double reference_x_body_m,
                                 double offset_y_body_m = 0.0) noexcept;

/// Where the feet shall be: a pure function of the plan and the time.
///
/// @param time_s  since the plan began, >= 0
[[nodiscard]] FootReference foot_reference(const WalkParameters&, const MotionPlan&, double time_s) noexcept;

}  // namespace surefoot::gait
