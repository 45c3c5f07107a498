#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "firmware/core/joints.hpp"

namespace surefoot::decision {

/// What the floor walk is doing (Kim, Park, Oh 2007, section 3.2, Fig. 21); kStanding and kShifting are ours.
enum class WalkStage : std::uint8_t {
  kStanding,    ///< both feet down, pelvis in the middle; entered at power-up and when a landing has come to rest
  kShifting,    ///< the sway begins, both feet stay down; leaves when the first foot may be lifted
  kLiftLeft,    ///< stage 1: the left foot goes up to its largest height
  kLowerLeft,   ///< stage 2: it comes down, and both feet carry the robot until the next lift
  kLiftRight,   ///< stage 3
  kLowerRight,  ///< stage 4
  kLanding,     ///< stage 5: after stage 2 or 4 of the last step; the sway fades, both feet stay down
};

/// What moves the walk on.
enum class WalkEvent : std::uint8_t {
  kWalkOrdered,  ///< the standing time is over
  kLiftBegins,   ///< the double support is over and the foot that landed carries
  kTopReached,   ///< the swing foot is at its largest height
  kStopOrdered,  ///< the walk shall end: the foot in the air lands, then both stand
  kCameToRest,   ///< the sway has faded out
};

struct WalkEdge {
  WalkStage from;
  WalkEvent on;
  WalkStage to;
};

/// Every legal edge; a pair (stage, event) that is not here is illegal.
inline constexpr std::array kWalkEdges{
    WalkEdge{WalkStage::kStanding, WalkEvent::kWalkOrdered, WalkStage::kShifting},
    WalkEdge{WalkStage::kShifting, WalkEvent::kLiftBegins, WalkStage::kLiftLeft},
    WalkEdge{WalkStage::kLiftLeft, WalkEvent::kTopReached, WalkStage::kLowerLeft},
    WalkEdge{WalkStage::kLowerLeft, WalkEvent::kLiftBegins, WalkStage::kLiftRight},
    WalkEdge{WalkStage::kLiftRight, WalkEvent::kTopReached, WalkStage::kLowerRight},
    WalkEdge{WalkStage::kLowerRight, WalkEvent::kLiftBegins, WalkStage::kLiftLeft},
    WalkEdge{WalkStage::kShifting, WalkEvent::kStopOrdered, WalkStage::kLanding},
    WalkEdge{WalkStage::kLowerLeft, WalkEvent::kStopOrdered, WalkStage::kLanding},
    WalkEdge{WalkStage::kLowerRight, WalkEvent::kStopOrdered, WalkStage::kLanding},
    WalkEdge{WalkStage::kLanding, WalkEvent::kCameToRest, WalkStage::kStanding},
};

inline constexpr std::array kWalkStages{WalkStage::kStanding,  WalkStage::kShifting,  WalkStage::kLiftLeft,
                                        WalkStage::kLowerLeft, WalkStage::kLiftRight, WalkStage::kLowerRight,
                                        WalkStage::kLanding};

inline constexpr std::array kWalkEvents{WalkEvent::kWalkOrdered, WalkEvent::kLiftBegins, WalkEvent::kTopReached,
                                        WalkEvent::kStopOrdered, WalkEvent::kCameToRest};

/// The stage after `event` in `stage`, or nothing when the pair is illegal.
[[nodiscard]] std::optional<WalkStage> next_stage(WalkStage stage, WalkEvent event) noexcept;

/// Names as they appear in logs and tables, e.g. "lower_left", "lift_begins".
[[nodiscard]] const char* name(WalkStage stage) noexcept;
[[nodiscard]] const char* name(WalkEvent event) noexcept;

[[nodiscard]] constexpr bool is_lifting(WalkStage stage) noexcept {
  return stage == WalkStage::kLiftLeft || stage == WalkStage::kLiftRight;
}
[[nodiscard]] constexpr bool is_lowering(WalkStage stage) noexcept {
  return stage == WalkStage::kLowerLeft || stage == WalkStage::kLowerRight;
}

/// The foot that stages 1 to 4 lift and lower.
[[nodiscard]] constexpr Side moving_foot(WalkStage stage) noexcept {
  return stage == WalkStage::kLiftRight || stage == WalkStage::kLowerRight ? Side::kRight : Side::kLeft;
}

}  // namespace surefoot::decision
