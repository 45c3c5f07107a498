#pragma once

#include "firmware/core/gait/floor_walk.hpp"

/// The floor walk along its direction where gaits are planned: stride after stride.
namespace surefoot::gait {

/// The walk with the durations of the stride that is walked, or will be first; as given where nothing is planned.
[[nodiscard]] WalkParameters timed(WalkParameters, const FourFactorParameters&, const FloorWalkState&) noexcept;

/// Plans the stride that begins, and what its sway lacks; `state` still has the stride before.
/// @param before  durations of that one
void plan_stride(const WalkParameters& before, const FourFactorParameters&, FloorWalkState& state) noexcept;

/// Whether a planned walk has taken its last step, the one that closes the feet.
[[nodiscard]] bool has_closed(const FourFactorParameters&, const FloorWalkState&) noexcept;

/// Where a foot of a planned stride is, seen from its foothold; from the straight way to the next one while it is in
/// the air.
struct FootOffset {
  double x_m = 0.0;
  double z_m = 0.0;
  double pitch_rad = 0.0;
};

[[nodiscard]] PerSide<FootOffset> planned_offsets(const WalkParameters&, const FloorWalkState&) noexcept;

/// A foot whose lowering was stopped stands as high as it was then.
void keep_held_height(const WalkParameters&, FloorWalkState&) noexcept;

/// x of the pelvis, walking frame.
[[nodiscard]] double planned_pelvis_x_m(const FourFactorParameters&, const FloorWalkState&) noexcept;

}  // namespace surefoot::gait
