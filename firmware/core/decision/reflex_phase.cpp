#include "firmware/core/decision/reflex_phase.hpp"

namespace surefoot::decision {

std::optional<ReflexPhase> next_phase(ReflexPhase phase, ReflexEvent event) noexcept {
  for (const Edge& edge : kReflexEdges) {
    if (edge.from == phase && edge.on == event) return edge.to;
  }
  return std::nullopt;
}

const char* name(ReflexPhase phase) noexcept {
  switch (phase) {
    case ReflexPhase::kStanding:
      return "standing";
    case ReflexPhase::kWalking:
      return "walking";
    case ReflexPhase::kReflex:
      return "reflex";
    case ReflexPhase::kSettling:
      return "settling";
    case ReflexPhase::kShifting:
      return "shifting";
    case ReflexPhase::kRestoring:
      return "restoring";
    case ReflexPhase::kResting:
      return "resting";
    case ReflexPhase::kStopped:
      return "stopped";
  }
  return "unknown";
}

const char* name(ReflexEvent event) noexcept {
  switch (event) {
    case ReflexEvent::kStandingDone:
      return "standing_done";
    case ReflexEvent::kPayloadDetected:
      return "payload_detected";
    case ReflexEvent::kReflexDone:
      return "reflex_done";
    case ReflexEvent::kSettled:
      return "settled";
    case ReflexEvent::kShifted:
      return "shifted";
    case ReflexEvent::kRestored:
      return "restored";
    case ReflexEvent::kRested:
      return "rested";
    case ReflexEvent::kStopOrdered:
      return "stop_ordered";
    case ReflexEvent::kBalanceLost:
      return "balance_lost";
  }
  return "unknown";
}

}  // namespace surefoot::decision
