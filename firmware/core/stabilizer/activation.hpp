#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// The online controllers: thirteen of Kim, Park, Oh 2007 (six new, seven earlier), then ours.
enum class Controller : std::uint8_t {
  kUprightPose,          ///< new: torso inclination to ankles and leg lengths
  kLandingMomentum,      ///< new: landing angular momentum
  kShockAbsorber,        ///< new: landing shock
  kLandingTiming,        ///< new
  kLandingPosition,      ///< new: lateral, by the hip gyro
  kVibrationReduction,   ///< new: swing leg
  kDamping,              ///< earlier
  kZmpCompensator,       ///< earlier
  kSoftLanding,          ///< earlier
  kSwayAmplitude,        ///< earlier: pelvis swing amplitude
  kTorsoTilt,            ///< earlier: torso pitch and roll, once a step
  kTiltOver,             ///< earlier
  kTiltLandingPosition,  ///< earlier: landing position by the torso's tilt
  kAttitudeFeedback,     ///< ours: torso attitude at the loaded ankles
  kFootTilt,             ///< ours: inclination of the sole, fed forward to its ankle
  kStepAdjustment,       ///< ours: landing point by the capture point
};

inline constexpr std::size_t kControllers = 16;

/// Name as it appears in scenarios, tables and logs, e.g. "upright_pose".
[[nodiscard]] const char* name(Controller controller) noexcept;

/// Whether the schedule lets a controller act here (Kim, Park, Oh 2007, Fig. 21). One that may not act lets its output
/// fade; it is stepped all the same.
[[nodiscard]] bool is_active(Controller controller, const WalkView& walk) noexcept;

}  // namespace surefoot::stabilizer
