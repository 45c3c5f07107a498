#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "firmware/can/can_frame.hpp"
#include "firmware/can/identifiers.hpp"

namespace surefoot::sim_hw {

/// Whether all answers of the five nodes to this tick's SYNC have left for the controller.
class AnswerWatch {
 public:
  /// @param has_inertial_legs  legs and feet answer with a second frame too
  explicit AnswerWatch(bool has_inertial_legs = false) noexcept : has_inertial_legs_(has_inertial_legs) {}

  /// A new SYNC.
  void begin_tick(std::uint32_t tick) noexcept {
    tick_ = tick;
    state_has_left_.fill(false);
    inertial_has_left_.fill(false);
  }

  /// Tick of that SYNC.
  [[nodiscard]] std::uint32_t tick() const noexcept { return tick_; }

  /// Frames that the bus took, as their nodes sent them in this tick.
  void note(std::span<const can::CanFrame> frames) noexcept {
    for (const can::CanFrame& frame : frames) {
      note(frame.identifier - can::state_identifier(can::Node::kLegRight), state_has_left_);
      note(frame.identifier - can::inertial_identifier(can::Node::kLegRight), inertial_has_left_);
    }
  }

  [[nodiscard]] bool is_complete() const noexcept {
    const auto is_set = [](bool left) { return left; };
    return std::ranges::all_of(state_has_left_, is_set) &&
           (!has_inertial_legs_ || std::ranges::all_of(inertial_has_left_, is_set));
  }

 private:
  /// @param place  of the node; of a frame of another kind: negative, or too large
  static void note(int place, std::span<bool> has_left) noexcept {
    if (place >= 0 && static_cast<std::size_t>(place) < has_left.size())
      has_left[static_cast<std::size_t>(place)] = true;
  }

  std::array<bool, 5> state_has_left_{};     ///< by node, 1 to 5
  std::array<bool, 4> inertial_has_left_{};  ///< 1 to 4
  bool has_inertial_legs_;
  std::uint32_t tick_ = 0;
};

}  // namespace surefoot::sim_hw
