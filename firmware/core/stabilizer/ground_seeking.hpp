#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Ground seeking: the leg of a foot that has not met the floor when its step is over grows until the sole carries,
/// while the body goes on. Waiting with the whole pattern instead stops the pelvis at its fastest, and topples a robot
/// that walks forward. Afterwards the leg comes back to its length. Source: ours.
struct GroundSeekingConfig {
  double speed_m_s = 0.1;
  double max_length_m = 0.015;
  double settling_s = 0.3;  ///< time constant of the way back
};

struct GroundSeekingState {
  PerSide<double> length_m{};
  PerSide<bool> seeks{};
};

/// One tick.
/// @return leg lengths of both feet, 0 to `max_length_m`
[[nodiscard]] Adjustment step(const GroundSeekingConfig&, GroundSeekingState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
