#pragma once

namespace surefoot::gait {

/// The nominal walk of El-Kahlout 2003, section 3.2 (values: appendix and Fig 3.2).
/// One cycle: double support, left swing, double support, right swing.
struct WalkParameters {
  double single_support_s = 1.4;      ///< t_ss: a foot is in the air, > 0
  double double_support_s = 1.0;      ///< t_ds: both feet carry, > 0
  double half_step_m = 0.08;          ///< b_s: a foot travels from -b_s to +b_s about the reference
  double reference_x_body_m = -0.09;  ///< x_ref_as: midpoint of the feet before any adaptation
  double reference_y_body_m = 0.0;    ///< y_ref_as
  double foot_offset_y_m = 0.11;      ///< w_of: each foot's distance from the midline
  double sway_m = 0.13;               ///< w: amplitude of the lateral sway
  double body_height_m = 0.5;         ///< h_b: body frame above the soles
  double swing_height_m = 0.03;       ///< h_s: apex of the swing foot

  /// T = 2 (t_ss + t_ds).
  [[nodiscard]] constexpr double cycle_s() const noexcept { return 2.0 * step_s(); }
  /// Half a cycle: one step.
  [[nodiscard]] constexpr double step_s() const noexcept { return single_support_s + double_support_s; }
};

}  // namespace surefoot::gait
