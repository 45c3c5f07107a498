#include "firmware/core/decision/walk_stage.hpp"

#include <algorithm>

namespace surefoot::decision {

std::optional<WalkStage> next_stage(WalkStage stage, WalkEvent event) noexcept {
  const auto* const edge =
      std::ranges::find_if(kWalkEdges, [&](const WalkEdge& one) { return one.from == stage && one.on == event; });
  if (edge == kWalkEdges.end()) return std::nullopt;
  return edge->to;
}

const char* name(WalkStage stage) noexcept {
  switch (stage) {
    case WalkStage::kStanding:
      return "standing";
    case WalkStage::kShifting:
      return "shifting";
    case WalkStage::kLiftLeft:
      return "lift_left";
    case WalkStage::kLowerLeft:
      return "lower_left";
    case WalkStage::kLiftRight:
      return "lift_right";
    case WalkStage::kLowerRight:
      return "lower_right";
    case WalkStage::kLanding:
      return "landing";
  }
  return "unknown";
}

const char* name(WalkEvent event) noexcept {
  switch (event) {
    case WalkEvent::kWalkOrdered:
      return "walk_ordered";
    case WalkEvent::kLiftBegins:
      return "lift_begins";
    case WalkEvent::kTopReached:
      return "top_reached";
    case WalkEvent::kStopOrdered:
      return "stop_ordered";
    case WalkEvent::kCameToRest:
      return "came_to_rest";
  }
  return "unknown";
}

}  // namespace surefoot::decision
