#include "firmware/core/stabilizer/activation.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr std::array<const char*, kControllers> kNames{
    "upright_pose",        "landing_momentum", "shock_absorber",        "landing_timing",    "landing_position",
    "vibration_reduction", "damping",          "zmp_compensator",       "soft_landing",      "sway_amplitude",
    "torso_tilt",          "tilt_over",        "tilt_landing_position", "attitude_feedback", "foot_tilt",
    "step_adjustment",     "ground_seeking"};

constexpr std::array<const char*, kSchedulePhases> kPhaseNames{"standing",    "shifting",     "lift",
                                                               "lower_swing", "lower_double", "landing"};

}  // namespace

const char* name(Controller controller) noexcept {
  const auto place = static_cast<std::size_t>(controller);
  return place < kNames.size() ? kNames[place] : "unknown";
}

const char* name(SchedulePhase phase) noexcept {
  const auto place = static_cast<std::size_t>(phase);
  return place < kPhaseNames.size() ? kPhaseNames[place] : "unknown";
}

SchedulePhase schedule_phase(const WalkView& walk) noexcept {
  switch (walk.stage) {
    case decision::WalkStage::kStanding:
      return SchedulePhase::kStanding;
    case decision::WalkStage::kShifting:
      return SchedulePhase::kShifting;
    case decision::WalkStage::kLiftLeft:
    case decision::WalkStage::kLiftRight:
      return SchedulePhase::kLift;
    case decision::WalkStage::kLowerLeft:
    case decision::WalkStage::kLowerRight: {
      const bool both_carry = walk.has_landed || (walk.is_double_support && !walk.is_waiting);
      return both_carry ? SchedulePhase::kLowerDouble : SchedulePhase::kLowerSwing;
    }
    case decision::WalkStage::kLanding:
      return SchedulePhase::kLanding;
  }
  return SchedulePhase::kStanding;
}

bool is_active(Controller controller, const WalkView& walk) noexcept {
  const auto row = static_cast<std::size_t>(controller);
  return row < kControllers && kActivation[row].acts_in[static_cast<std::size_t>(schedule_phase(walk))];
}

}  // namespace surefoot::stabilizer
