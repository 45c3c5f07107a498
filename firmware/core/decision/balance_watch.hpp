#pragma once

#include "firmware/core/decision/payload_detector.hpp"

namespace surefoot::decision {

/// Everything that lives between two ticks.
struct BalanceWatchState {
  double largest_rate_rad_s = 0.0;  ///< of roll or pitch, seen while the payload detector learned
};

/// One tick of walking. True while the body tips faster than the learned walk ever did, plus the margin: a push
/// changes no weight, but by the linear inverted pendulum each rad/s of tipping moves the capture point by z_c / omega.
/// Learns and is armed with the payload detector; silent before, and while that one learns a
/// loaded walk: what that adds to the rate is learned too.
///
/// @param margin_rad_s                      above the largest learned rate, >= 0
/// @param roll_rate_rad_s, pitch_rate_rad_s  the gyro's
[[nodiscard]] bool is_balance_lost(double margin_rad_s, BalanceWatchState&, DetectorStage, double roll_rate_rad_s,
                                   double pitch_rate_rad_s) noexcept;

}  // namespace surefoot::decision
