#include "firmware/core/safety/safe_state.hpp"

#include <algorithm>

namespace surefoot::safety {

Finding followed_by(Finding first, Finding next) noexcept {
  return {.fault = first.fault != Fault::kNone ? first.fault : next.fault, .needs = std::max(first.needs, next.needs)};
}

Finding finding_of(Fault fault) noexcept {
  if (fault == Fault::kNone) return {};
  const bool legs_obey = fault == Fault::kSecondMaster || fault == Fault::kLoopOverrun;
  return {.fault = fault, .needs = legs_obey ? SafeState::kStanceHold : SafeState::kDamp};
}

Finding finding_of_node(Fault fault, bool is_leg_board) noexcept {
  return {.fault = fault, .needs = is_leg_board ? SafeState::kDamp : SafeState::kStanceHold};
}

const char* name(SafeState state) noexcept {
  switch (state) {
    case SafeState::kNone:
      return "none";
    case SafeState::kStanceHold:
      return "stance_hold";
    case SafeState::kDamp:
      return "damp";
  }
  return "unknown";
}

}  // namespace surefoot::safety
