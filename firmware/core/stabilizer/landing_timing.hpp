#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Landing timing: the instant t0 at which the supporting leg stops leaning outward tells how the swing foot will land.
/// Before the window [A, B] the body tips inward too early, and the lowering ends by E = A - t0 earlier; within it and
/// after it the pattern keeps its time. In any case the step does not end before the foot carries.
/// Source: Kim, Park, Oh 2007, section 3.2.4. The window's bounds are ours.
struct LandingTimingConfig {
  bool uses_nominal = true;        ///< the window lies about flat walking's t0; else about the foot's largest height
  double before_s = 0.05;          ///< A lies so much before that; B would be 0.1 s after it, and changes nothing here
  double max_earlier_s = 0.285;    ///< 0.3 of the step
  double hysteresis_rad_s = 0.02;  ///< a crossing counts when the rate has gone from so far below zero to so far above
  double max_rate_s_per_s = 2.0;   ///< of the change of the landing's time
};

/// Finds the instant at which a noisy rate crosses zero upward, once.
struct ZeroCrossing {
  double before_s = 0.0;
  double before_rad_s = 0.0;
  double first_s = 0.0;  ///< first and last upward crossing since the rate was clearly below zero
  double last_s = 0.0;
  bool is_armed = false;
  bool has_candidate = false;
  bool is_confirmed = false;

  /// @return the crossing's time once the rate is clearly above zero
  [[nodiscard]] double time_s() const noexcept { return 0.5 * (first_s + last_s); }
};

struct LandingTimingState {
  ZeroCrossing measured;
  ZeroCrossing nominal;
  PerSide<double> nominal_crossing_s{};  ///< of the latest step of each swing foot
  PerSide<bool> is_nominal_known{};
  double top_s = 0.0;  ///< time in the step at which the foot was highest
  double earlier_s = 0.0;
  decision::WalkStage stage = decision::WalkStage::kStanding;
};

/// Reads the hip gyro of the supporting leg. Gives `earlier_landing_s`, which stays until the next lift, and
/// `waits_for_contact`.
[[nodiscard]] Adjustment step(const LandingTimingConfig&, LandingTimingState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
