#pragma once

#include "firmware/core/sensor_snapshot.hpp"

namespace surefoot::safety {

/// Angle and rate of a joint come from different sensors and must tell the same story.
struct EncoderCheckConfig {
  double residual_limit_rad = 0.01;  ///< > 0
  double time_constant_s = 0.1;      ///< the residual leaks: what a good sensor's errors add up to stays bounded
};

/// Everything that lives between two ticks.
struct EncoderCheckState {
  PerSide<LegVector> residual_rad{};
  PerSide<LegVector> last_angle_rad{};
  PerSide<LegVector> last_rate_rad_s{};
  PerSide<std::uint32_t> elapsed_ticks{};  ///< since the last word of the board
  PerSide<bool> was_heard{};
};

/// One tick. For each joint the way that the encoder moved, less the way by the mean of the rates before
/// and after, is added to a leaky sum: an encoder that sticks or jumps, and a rate that sticks, show there.
/// What happens in a gap of more than five ticks is not judged. Nor do show: both stuck together, a drift
/// slower than limit / time constant, a joint that does not move.
///
/// @param period_s  time since the last call, > 0, and less than the time constant
/// @return false when a joint that spoke in this tick is beyond the limit
[[nodiscard]] bool are_encoders_plausible(const EncoderCheckConfig&, EncoderCheckState&, const PerSide<LegSensors>&,
                                          double period_s) noexcept;

}  // namespace surefoot::safety
