#pragma once

#include <cstdint>
#include <optional>

#include "firmware/core/decision/walk_stage.hpp"
#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/four_factor_pattern.hpp"
#include "firmware/core/gait/pendulum_path.hpp"
#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::gait {

/// Everything of the walk that lives between two ticks. The *walking frame* is level and moves with nobody: x forward,
/// y left, z up from the soles, origin between the feet at power-up.
struct FloorWalkState {
  decision::WalkStage stage = decision::WalkStage::kStanding;
  double time_in_stage_s = 0.0;
  Side moving = Side::kLeft;  ///< foot of the step whose clock runs
  double step_time_s = 0.0;   ///< s; negative while the sway grows
  double clock_rate = 1.0;    ///< above 1 when a foot is to land earlier
  double waited_s = 0.0;      ///< for this step's contact
  double since_landing_s = 0.0;
  bool has_landed = true;
  bool stops = false;
  PerSide<geometry::Vector3> foothold_m{geometry::Vector3::Zero(),
                                        geometry::Vector3::Zero()};  ///< where a foot stands or stood
  geometry::Vector3 target_m = geometry::Vector3::Zero();            ///< where the moving foot lands unless adjusted
  geometry::Vector3 lifted_m = geometry::Vector3::Zero();            ///< where it was lifted
  std::optional<double> held_share;                                  ///< u at which the lowering was stopped
  PendulumPath pelvis_x{};
  LateralPendulum com_y{};
  PlannedStride stride{};          ///< of a planned walk
  double stride_origin_x_m = 0.0;  ///< walking frame
  ScalarMotion sway_join_m;        ///< what its sway lacks at the begin of the stride, towards the foot that carries
  double centre_from_y_m = 0.0;    ///< middle of the sway, at the begin of the step and at its end
  double centre_to_y_m = 0.0;
  std::uint32_t steps = 0;  ///< begun so far
  bool is_set_up = false;
};

/// One tick of clock and stages.
///
/// A step ends when its time is over and, where `last` says that it waits for its contact, the moving foot carries; it
/// waits no longer than `longest_wait_s`. In the tick in which the sole carries, the lowering may be held (`last`).
///
/// @param last     what the controllers asked for in the tick before
/// @param stops    the walk shall end: the foot in the air lands, the sway fades, and the robot stands for good
/// @param period_s time since the last call, > 0
[[nodiscard]] stabilizer::WalkView advance(const WalkParameters&, const FourFactorParameters&, FloorWalkState&,
                                           const PerSide<estimation::AnkleLoad>&, const stabilizer::Adjustment& last,
                                           bool stops, double period_s) noexcept;

/// Where the feet shall be, seen from the body, with the adjustments that move feet and pelvis. Remembers where the
/// moving foot is, for it stays there when it lands.
[[nodiscard]] FootReference foot_reference(const WalkParameters&, const FourFactorParameters&, FloorWalkState&,
                                           const stabilizer::Adjustment&) noexcept;

/// Pressure centre of a planned walk as its plan has it, x from the foothold of the foot that landed last, on the
/// floor; 0 where nothing is planned.
/// @param ankle_height_m  of the axes above the soles
[[nodiscard]] double planned_zmp_x_foot_m(const FourFactorParameters&, const FloorWalkState&,
                                          double ankle_height_m) noexcept;

/// From power-up to the first lift of a foot.
[[nodiscard]] double start_up_s(const WalkParameters&, const FourFactorParameters&) noexcept;

}  // namespace surefoot::gait
