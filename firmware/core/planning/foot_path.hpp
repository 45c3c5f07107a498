#pragma once

#include <cstdint>

#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/planning/spline.hpp"

namespace surefoot::planning {

/// Trajectory of a foot over one of its steps (Al-Shuka et al. 2014, Table 1).
enum class FootCase : std::uint8_t {
  kSoftFlat,    ///< 1: flat; at rest at both ends, quartic and quartic, eqs. (22) to (24)
  kHardFlat,    ///< 2: flat; lands with speed, cubics, eqs. (25), (26)
  kSoftRolled,  ///< 3: rolls over toe and heel; its turning is at rest where it lands, eqs. (27) to (34)
  kHardRolled,  ///< 4: rolls; its turning goes on through the landing, eq. (35)
};

/// The foot travels 2 S, from -S to +S, which are the places of its ankle while it is flat.
struct FootStep {
  double step_length_m = 0.5;  ///< S
  double toe_s = 0.125;        ///< on its toe, before it is lifted; 0 in cases 1 and 2
  double swing_s = 0.5;        ///< in the air
  double heel_s = 0.125;       ///< on its heel, after it has landed
  double top_share = 0.5;      ///< of the swing, at which the point over the obstacle is passed
  double top_x_m = 0.0;        ///< that point
  double top_z_m = 0.06;
  double toe_angle_rad = 0.2;   ///< pitch at lift, heel up: 0 or more
  double heel_angle_rad = 0.2;  ///< toe up at landing: 0 or more
  double toe_m = 0.15;          ///< l_a: from the ankle to the toe's tip, along the sole
  double heel_m = 0.08;         ///< l_b: to the heel
};

/// Motion of the ankle, which lies on the line of the sole, and of the foot's pitch (positive with the heel up).
struct FootPoint {
  gait::ScalarMotion x_m;  ///< along the direction of walking, from the middle of the way
  gait::ScalarMotion z_m;  ///< above the floor
  gait::ScalarMotion pitch_rad;
};

/// A step of one foot: on its toe, in the air, on its heel. On toe and heel it moves along exact arcs.
class FootPath {
 public:
  FootPath(FootCase, const FootStep&) noexcept;

  /// Whether the step is possible: durations and lengths positive, the top inside the swing.
  [[nodiscard]] bool is_determined() const noexcept;

  [[nodiscard]] double duration_s() const noexcept { return lift_s_ + step_.swing_s + after_s_; }
  [[nodiscard]] double lift_s() const noexcept { return lift_s_; }
  [[nodiscard]] double landing_s() const noexcept { return lift_s_ + step_.swing_s; }

  /// @param time_s  since the heel begins to rise; held in [0, duration]
  [[nodiscard]] FootPoint at(double time_s) const noexcept;

 private:
  [[nodiscard]] FootPoint on_toe(double time_s) const noexcept;
  [[nodiscard]] FootPoint on_heel(double time_s) const noexcept;
  void plan_flat(FootCase) noexcept;
  void plan_pitch(FootCase) noexcept;
  void plan_swing() noexcept;

  FootStep step_;
  bool is_rolled_;
  double lift_s_;
  double after_s_;
  Spline pitch_;          ///< of the whole step (case 4), or up to the landing (case 3)
  Spline pitch_on_heel_;  ///< case 3
  Spline x_;              ///< of the swing
  Spline z_;
};

}  // namespace surefoot::planning
