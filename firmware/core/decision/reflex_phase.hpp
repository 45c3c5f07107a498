#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace surefoot::decision {

/// What the robot is doing (El-Kahlout 2003, section 3.3; the first two phases are ours).
enum class ReflexPhase : std::uint8_t {
  kStanding,   ///< entered at power-up, feet side by side; leaves when the standing time is over
  kWalking,    ///< nominal gait; leaves when the payload detector fires or balance is lost
  kReflex,     ///< both feet move to the reflex stance, t_refl; leaves when the movement ends
  kSettling,   ///< stands while the ZMP filter settles, t_set; leaves after that time
  kShifting,   ///< moves both feet by the ZMP error, t_x; leaves when the movement ends
  kRestoring,  ///< one step back to the nominal step length; also the first step after kStanding;
               ///< leaves when the sway of that step ends
  kResting,    ///< stands for half the settling time; leaves to kWalking, detector re-armed
  kStopped,    ///< after a latched fault: both feet down in a short move, then stands; never left
};

/// What moves the sequence on.
enum class ReflexEvent : std::uint8_t {
  kStandingDone,
  kPayloadDetected,
  kReflexDone,
  kSettled,
  kShifted,
  kRestored,
  kRested,
  kStopOrdered = 8,  ///< a fault latched; 7 is no event of the sequence in the recorded logs
  kBalanceLost = 9,  ///< the body tips faster than the unloaded walk did; the capture method alone
};

struct Edge {
  ReflexPhase from;
  ReflexEvent on;
  ReflexPhase to;
};

/// Every legal edge; a pair (phase, event) that is not here is illegal.
inline constexpr std::array kReflexEdges{
    Edge{ReflexPhase::kStanding, ReflexEvent::kStandingDone, ReflexPhase::kRestoring},
    Edge{ReflexPhase::kWalking, ReflexEvent::kPayloadDetected, ReflexPhase::kReflex},
    Edge{ReflexPhase::kWalking, ReflexEvent::kBalanceLost, ReflexPhase::kReflex},
    Edge{ReflexPhase::kReflex, ReflexEvent::kReflexDone, ReflexPhase::kSettling},
    Edge{ReflexPhase::kSettling, ReflexEvent::kSettled, ReflexPhase::kShifting},
    Edge{ReflexPhase::kShifting, ReflexEvent::kShifted, ReflexPhase::kRestoring},
    Edge{ReflexPhase::kRestoring, ReflexEvent::kRestored, ReflexPhase::kResting},
    Edge{ReflexPhase::kResting, ReflexEvent::kRested, ReflexPhase::kWalking},
    Edge{ReflexPhase::kStanding, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kWalking, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kReflex, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kSettling, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kShifting, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kRestoring, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
    Edge{ReflexPhase::kResting, ReflexEvent::kStopOrdered, ReflexPhase::kStopped},
};

inline constexpr std::array kReflexPhases{ReflexPhase::kStanding, ReflexPhase::kWalking,  ReflexPhase::kReflex,
                                          ReflexPhase::kSettling, ReflexPhase::kShifting, ReflexPhase::kRestoring,
                                          ReflexPhase::kResting,  ReflexPhase::kStopped};

inline constexpr std::array kReflexEvents{
    ReflexEvent::kStandingDone, ReflexEvent::kPayloadDetected, ReflexEvent::kReflexDone,
    ReflexEvent::kSettled,      ReflexEvent::kShifted,         ReflexEvent::kRestored,
    ReflexEvent::kRested,       ReflexEvent::kStopOrdered,     ReflexEvent::kBalanceLost};

/// The phase after `event` in `phase`, or nothing when the pair is illegal.
[[nodiscard]] std::optional<ReflexPhase> next_phase(ReflexPhase phase, ReflexEvent event) noexcept;

/// Names as they appear in logs and pictures, e.g. "settling", "payload_detected".
[[nodiscard]] const char* name(ReflexPhase phase) noexcept;
[[nodiscard]] const char* name(ReflexEvent event) noexcept;

}  // namespace surefoot::decision
