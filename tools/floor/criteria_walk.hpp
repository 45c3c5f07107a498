#pragma once

#include <cstddef>
#include <vector>

#include "firmware/core/stabilizer/stabilizer.hpp"
#include "sim_hw/inclination.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::floor {

/// One tick of a walk: what the controllers knew and gave, and what really happened.
struct ObservedTick {
  double time_s = 0.0;  ///< on the scenario's clock; negative until the first foot is lifted
  stabilizer::WalkView walk;
  stabilizer::PhaseSample measured;
  stabilizer::PhaseSample nominal;
  PerSide<estimation::AnkleLoad> ankle;
  PerSide<double> hip_roll_rate_rad_s{};  ///< hip gyros
  stabilizer::Adjustment total;           ///< of all controllers
  sim_hw::Inclination torso;              ///< true, against the vertical
  PerSide<double> force_n{};              ///< true normal force on each sole
  PerSide<geometry::Vector3> foot_body_m{geometry::Vector3::Zero(),
                                         geometry::Vector3::Zero()};  ///< true soles below the ankles, body frame
  PerSide<double> ankle_roll_rad{};                                   ///< true
  PerSide<double> hip_joint_rate_rad_s{};  ///< true roll rate of the hip joints, behind a flexible drive
};

/// A walk from power-up to its end or fall, tick by tick.
struct ObservedWalk {
  std::vector<ObservedTick> ticks;
  stabilizer::StabilizerConfig config;  ///< of its controllers
  double period_s = 1.0e-3;
  double body_mass_kg = 56.0;
  double foot_offset_y_m = 0.071;  ///< of a foot from the midline, in the pattern
  double push_s = 0.0;             ///< begin of the scenario's first push; 0: none
  bool has_fallen = false;

  /// Whole ticks in a time.
  [[nodiscard]] std::size_t ticks_in(double duration_s) const noexcept;
};

/// Walks the scenario in lockstep, unrecorded.
[[nodiscard]] ObservedWalk observe(const scenario::Scenario& scenario);

/// One foot that came down. Ticks are places in `ObservedWalk::ticks`.
struct Landing {
  Side foot = Side::kLeft;
  std::size_t contact = 0;   ///< first tick in which it carries 5 kgf
  std::size_t step_end = 0;  ///< tick in which the pattern's next step begins: where the lowering was to end
  std::size_t lift = 0;      ///< tick in which the other foot is lifted: end of the double support
  double swing_share = 1.0;  ///< of the swing at the contact; 1 when it came after the step's end
};

/// The landings of a walk whose double support ended within it, in their order.
[[nodiscard]] std::vector<Landing> landings_of(const ObservedWalk& walk);

}  // namespace surefoot::floor
