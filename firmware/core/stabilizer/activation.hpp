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
  kGroundSeeking,        ///< ours: the leg of a late foot reaches for the floor
};

inline constexpr std::size_t kControllers = 17;

/// Name as it appears in scenarios, tables and logs, e.g. "upright_pose".
[[nodiscard]] const char* name(Controller controller) noexcept;

/// A column of the schedule: stages 1 and 3 are one, 2 and 4 are split where the landing foot begins to carry.
enum class SchedulePhase : std::uint8_t { kStanding, kShifting, kLift, kLowerSwing, kLowerDouble, kLanding };

inline constexpr std::size_t kSchedulePhases = 6;

/// Name as it appears in tables, e.g. "lower_swing".
[[nodiscard]] const char* name(SchedulePhase phase) noexcept;

/// Where the walk is on the schedule. In stages 2 and 4 contact decides, not the plan: a foot that landed early
/// carries, one that the clock waits for does not.
[[nodiscard]] SchedulePhase schedule_phase(const WalkView& walk) noexcept;

/// One row of the schedule: the phases in which a controller acts.
struct ActivationRow {
  Controller controller = Controller::kUprightPose;
  std::array<bool, kSchedulePhases> acts_in{};  ///< in the order of `SchedulePhase`
};

/// The schedule, in the order of `Controller` (Kim, Park, Oh 2007, Fig. 21, tables 4 and 5; the last four are ours).
/// The paper's stage 5, landing and standing, is our standing, shifting and landing.
inline constexpr std::array<ActivationRow, kControllers> kActivation{{
    // standing, shifting, lift, lower_swing, lower_double, landing
    {Controller::kUprightPose, {true, true, true, true, true, true}},
    {Controller::kLandingMomentum, {false, false, false, false, true, false}},
    {Controller::kShockAbsorber, {false, false, false, false, true, false}},
    {Controller::kLandingTiming, {false, false, false, true, true, false}},
    {Controller::kLandingPosition, {false, false, false, true, true, false}},
    {Controller::kVibrationReduction, {false, false, true, false, false, false}},
    {Controller::kDamping, {false, false, true, true, false, false}},
    {Controller::kZmpCompensator, {false, false, true, true, false, false}},
    {Controller::kSoftLanding, {false, false, false, false, true, false}},
    {Controller::kSwayAmplitude, {false, false, false, false, true, false}},
    {Controller::kTorsoTilt, {false, false, false, false, true, false}},
    {Controller::kTiltOver, {false, false, true, false, false, false}},
    {Controller::kTiltLandingPosition, {false, false, false, true, true, false}},
    {Controller::kAttitudeFeedback, {true, true, true, true, true, false}},
    {Controller::kFootTilt, {false, true, true, true, true, false}},
    {Controller::kStepAdjustment, {false, false, true, true, true, false}},
    {Controller::kGroundSeeking, {false, false, true, true, true, false}},
}};

/// Whether the schedule lets a controller act here (Kim, Park, Oh 2007, Fig. 21). One that may not act lets its output
/// fade; it is stepped all the same.
[[nodiscard]] bool is_active(Controller controller, const WalkView& walk) noexcept;

}  // namespace surefoot::stabilizer
