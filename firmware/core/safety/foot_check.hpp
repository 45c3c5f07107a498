#pragma once

#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// Load cells that answer but do not weigh.
struct FootCheckConfig {
  double frozen_s = 7.2;          ///< of walking in which a corner may keep its very bits: one and a half gait cycles
  double frozen_loaded_s = 0.5;   ///< the same for a corner that carries something: that trembles
  double loaded_n = 20.0;         ///< from here on a corner carries something
  double min_weight_share = 0.4;  ///< of the standing weight that both feet together must feel ..
  double max_weight_share = 1.8;  ///< .. and may feel, payloads included ..
  double weight_s = 0.4;          ///< .. but for so long: the hop and the landing of a reflex are shorter
};

/// Everything that lives between two ticks.
struct FootCheckState {
  PerSide<std::array<double, geometry::kCornersPerFoot>> last_force_n{};
  PerSide<std::array<std::uint32_t, geometry::kCornersPerFoot>> frozen_ticks{};
  std::uint32_t wrong_weight_ticks = 0;
};

/// One tick.
///
/// A cell in the air reads a constant zero for the time of a swing, and one under an edge that carries
/// nothing for a stance more; while the robot walks each of them feels the floor once a cycle.
///
/// @param is_moving   the robot walks, or has just ceased to: the frozen cells are counted while true, and forgotten
/// when not
/// @param weight_n    filtered force of the last standing; 0 while it is not known: no weight is judged
/// @param period_s    time since the last call, > 0
[[nodiscard]] bool are_feet_plausible(const FootCheckConfig&, FootCheckState&, const PerSide<FootSensors>&,
                                      bool is_moving, double weight_n, double period_s) noexcept;

}  // namespace surefoot::safety
