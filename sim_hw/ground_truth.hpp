#pragma once

#include <array>
#include <cstdint>

#include "firmware/core/joints.hpp"

namespace surefoot::sim_hw {

/// What really happened in the last period; for logs and verdicts, never for the firmware.
///
/// The world frame is the floor's: on a slope positions run along it, and torso angles, the fall among them, are
/// against its normal. Where gravity points there: `gravity_floor_m_s2`.
struct GroundTruth {
  double time_s = 0.0;                            ///< scenario clock; 0 is the begin of the first scored gait cycle
  std::array<double, 3> body_position_world_m{};  ///< origin of the body frame
  std::array<double, 3> body_velocity_world_m_s{};
  double roll_rad = 0.0;   ///< about x, of the body frame, rotation z-y-x
  double pitch_rad = 0.0;  ///< about y, positive leaning forward (beta in the thesis)
  double yaw_rad = 0.0;
  std::array<double, 3> body_rate_body_rad_s{};
  PerSide<std::array<double, 4>> corner_force_n{};  ///< normal, mean over the period
  PerSide<LegVector> angle_rad{};
  PerSide<LegVector> rate_rad_s{};
  PerSide<LegVector> torque_nm{};                  ///< applied by the motors at the end of the period
  double zmp_x_body_m = 0.0;                       ///< from the contact forces
  int payloads_hung = 0;                           ///< so far
  double payload_kg = 0.0;                         ///< hung on so far, whether it hangs still or not
  int payloads_removed = 0;                        ///< so far
  double removed_kg = 0.0;                         ///< taken off so far
  std::array<double, 3> push_impulse_world_n_s{};  ///< running total of all pushes
  std::uint32_t pushes_begun = 0;                  ///< bit i: push i of the scenario has begun
  std::uint32_t pushes_ended = 0;                  ///< bit i: it is over
  double slip_m = 0.0;  ///< running total: way the soles slid over the floor, weighted with the share of load
  std::uint32_t faults_active = 0;  ///< bit i: fault i of the scenario is on
  bool has_fallen = false;          ///< latched: the body is below half its height or tilted by more than 45 degrees
};

}  // namespace surefoot::sim_hw
