#pragma once

#include <cstdint>

#include "firmware/core/planning/sagittal_body.hpp"

namespace surefoot::planning {

/// What a planned step may not exceed.
struct StepLimits {
  double friction = 0.6;        ///< mu, of sole and floor
  double zmp_margin_m = 0.0;    ///< between ZMP and edge of the support, at least
  double most_stretch = 0.999;  ///< of a leg, share of its length
};

/// The first constraint that a step breaks, in the order in which they are looked at: near a stretched knee loads mean
/// nothing.
enum class StepConstraint : std::uint8_t {
  kNone,
  kDetermined,  ///< durations, lengths or shares are no possible step
  kKnee,        ///< a leg is too short, eqs. (36), (37)
  kLift,        ///< a foot would have to pull, eqs. (38) to (40)
  kFriction,    ///< a foot would slip
  kZmp,         ///< the ZMP leaves the support polygon, eq. (43)
};

/// "none", "determined", "knee", "lift", "friction", "zmp".
[[nodiscard]] const char* name(StepConstraint) noexcept;

/// The worst instants of a step.
struct StepMargins {
  double greatest_stretch = 0.0;
  double least_normal_n = 0.0;         ///< on a foot that carries at least a hundredth of the weight
  double greatest_friction = 0.0;      ///< tangential over normal
  double least_zmp_margin_m = 0.0;     ///< negative: outside
  double least_zmp_margin_at_s = 0.0;  ///< since the landing
  double zmp_outside_share = 0.0;      ///< of the step's time
  StepConstraint broken = StepConstraint::kNone;
};

/// Looks at evenly spaced instants, just inside the borders of its supports.
/// @param hip_height_m  above the floor, constant: `SagittalBody::hip_height_m` of the gait's H
/// @param samples       in a step, 10 or more
[[nodiscard]] StepMargins check_step(const SagittalBody&, const StepLimits&, const PlannedStep&, double hip_height_m,
                                     int samples = 500) noexcept;

}  // namespace surefoot::planning
