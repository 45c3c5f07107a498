#pragma once

#include <cstdint>

#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// A leg board's own servo: torque = kp (reference - angle) + kd (reference rate - rate), gains of `DriveConfig`.
///
/// The reference goes linearly, within one control period, from where it is to the angles wanted, and stays there;
/// where the servo begins, it starts from the joints as they are.
class PositionServo {
 public:
  explicit PositionServo(const SimConfig&) noexcept;

  /// New angles wanted from the step on that begins now.
  void aim(const LegVector& wanted_rad, const LegVector& angle_rad) noexcept;

  /// Another mode drives the joints: the next `aim` begins anew.
  void stop() noexcept { is_running_ = false; }

  /// Torque for the physics step that begins now, before the motors' limit.
  [[nodiscard]] LegVector step(const LegVector& angle_rad, const LegVector& rate_rad_s) noexcept;

 private:
  [[nodiscard]] double reference_rad(std::size_t joint) const noexcept;

  LegVector stiffness_nm_per_rad_;
  LegVector damping_nm_s_per_rad_;
  double period_s_;
  std::uint64_t steps_per_period_;
  LegVector from_rad_{};
  LegVector wanted_rad_{};
  std::uint64_t steps_done_ = 0;  ///< of the way from the one to the other, up to `steps_per_period_`
  bool is_running_ = false;
};

}  // namespace surefoot::sim_hw
