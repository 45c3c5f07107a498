#pragma once

#include <cstdint>

#include "firmware/core/gait/lateral_pendulum.hpp"
#include "firmware/core/gait/planned_stride.hpp"
#include "firmware/core/gait/walk_parameters.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::gait {

/// How the pelvis sways from foot to foot.
enum class SwayProfile : std::uint8_t {
  kSine,      ///< as printed; the pressure centre swings past the foot's middle and back
  kPendulum,  ///< `LateralPendulum`: the pressure centre rests under the foot
};

/// The walking pattern of KHR-2 beyond what every walk has (`WalkParameters`): one step lasts `step_s()`, the double
/// support comes first. Source: Kim, Park, Oh 2007, section 3 and Table 3; start, stop and the pelvis' path along x are
/// ours.
struct FourFactorParameters {
  double step_length_m = 0.0;  ///< d: distance of two successive footholds along x; 0 walks on the spot
  double com_height_m = 0.67;  ///< of the pendulum that carries the pelvis along x, above the soles, > 0
  SwayProfile sway_profile = SwayProfile::kSine;
  double com_share = 0.8;          ///< of the pelvis' sway, that the centre of mass follows; in (0, 1]
  double transfer_s = 0.25;        ///< of the profile pendulum: in which the pressure centre goes from foot to foot
  double pelvis_x_m = 0.0;         ///< pelvis ahead of the middle of the feet
  double shift_steps = 2.0;        ///< steps' time in which the sway grows before the first foot is lifted, >= 1
  double standing_s = 3.0;         ///< from power-up to the begin of the shift, > 0
  double longest_wait_s = 1.0;     ///< a step waits no longer for its contact
  double height_settling_s = 0.3;  ///< time constant with which a foot that landed high or low comes back to level
  PlannedGaits gaits{};            ///< if there are any they are walked instead, with a pendulum's sway
};

/// Where the pelvis' sway is: y of the pelvis over the middle of the feet, positive to the left.
///
/// y = -+A sin(pi (s - T_dsp / 2) / T_step), minus while the left foot is the moving one: the body is over the other.
/// @param step_time_s  s: since the double support before the lift began
[[nodiscard]] double sway_y_m(const WalkParameters&, double amplitude_m, Side moving, double step_time_s) noexcept;

/// Height of a swing foot over the line between its footholds, H / 2 (1 - cos 2 pi u), and how far along it is,
/// (1 - cos pi u) / 2.
/// @param swing_share  u, in [0, 1]
[[nodiscard]] double swing_height_m(const WalkParameters&, double swing_share) noexcept;
[[nodiscard]] double swing_progress(double swing_share) noexcept;

/// u of a step at a time: 0 through the double support, then growing to 1.
[[nodiscard]] double swing_share(const WalkParameters&, double step_time_s) noexcept;

}  // namespace surefoot::gait
