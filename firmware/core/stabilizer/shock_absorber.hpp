#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// Landing shock absorber: when a foot lands before its lowering has ended, it goes no further down, and the pelvis
/// yields to the force like a mass on a spring and a damper, z = -F / (m s^2 + c s + k).
/// Source: Kim, Park, Oh 2007, section 3.2.3, eq. (11). The values are ours: 27 mm under the full weight, critically
/// damped. A landing at the planned time moves nothing: it would bob the body at every step.
struct ShockAbsorberConfig {
  double mass_kg = 28.0;
  double damping_ns_per_m = 1.5e3;
  double stiffness_n_per_m = 2.0e4;
  double latest_share = 0.92;  ///< of the swing, up to which a contact is early; here the foot has 2.5 of 40 mm to go
  double max_offset_m = 0.03;
  double washout_s = 0.2;  ///< time constant of the way back after the double support
};

struct ShockAbsorberState {
  double offset_m = 0.0;  ///< of the pelvis, 0 or less
  double velocity_m_s = 0.0;
  bool is_absorbing = false;
};

/// Reads the normal force on the landing foot. Gives `pelvis_z_m` in [-max_offset_m, 0] and, from an early contact to
/// the next lift, `holds_lowering`.
[[nodiscard]] Adjustment step(const ShockAbsorberConfig&, ShockAbsorberState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
