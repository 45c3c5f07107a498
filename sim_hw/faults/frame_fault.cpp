#include "sim_hw/faults/frame_fault.hpp"

#include <algorithm>
#include <array>

#include "firmware/can/end_to_end.hpp"
#include "firmware/can/messages.hpp"
#include "sim_hw/faults/fault_random.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr unsigned kIdentifierBits = 11;
constexpr std::uint16_t kFunctionMask = 0x780;
constexpr std::uint16_t kNodeMask = 0x07F;
constexpr std::array<std::uint8_t, 16> kLengths{0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64};

/// Successive numbers below a bound, from one draw.
class Sequence {
 public:
  explicit Sequence(std::uint64_t draw) noexcept : state_(draw) {}
  unsigned below(unsigned bound) noexcept {
    state_ = FaultRandom::mixed(state_);
    return static_cast<unsigned>(((state_ >> 32U) * bound) >> 32U);
  }

 private:
  std::uint64_t state_;
};

void flip(can::CanFrame& frame, unsigned bit) noexcept {
  if (bit < kIdentifierBits) {
    frame.identifier = static_cast<std::uint16_t>(frame.identifier ^ (1U << bit));
  } else {
    const unsigned place = bit - kIdentifierBits;
    frame.payload[place / 8] = static_cast<std::uint8_t>(frame.payload[place / 8] ^ (1U << (place % 8)));
  }
}

void change_length(can::CanFrame& frame, Sequence& random) noexcept {
  std::uint8_t length = frame.length;
  while (length == frame.length) length = kLengths[random.below(kLengths.size())];
  for (std::size_t byte = frame.length; byte < length; ++byte) frame.payload[byte] = 0;
  frame.length = length;
}

/// Identifiers that a board owns: emergency, states, commands, heartbeat.
bool is_owned_by_a_board(std::uint16_t function) noexcept {
  return function == can::emergency_identifier(can::Node{0}) || function == can::state_identifier(can::Node{0}) ||
         function == can::inertial_identifier(can::Node{0}) || function == can::command_identifier(can::Node{0}) ||
         function == can::position_identifier(can::Node{0}) || function == can::heartbeat_identifier(can::Node{0});
}

}  // namespace

can::CanFrame corrupted(can::CanFrame frame, unsigned bits, std::uint64_t draw) noexcept {
  Sequence random(draw);
  if (random.below(8) == 0) {
    change_length(frame, random);
    return frame;
  }
  const unsigned available = kIdentifierBits + 8U * frame.length;
  const unsigned wanted = std::min({bits, available, 64U});
  std::array<unsigned, 64> flipped{};
  for (unsigned count = 0; count < wanted;) {
    const unsigned bit = random.below(available);
    const auto end = flipped.begin() + count;
    if (std::find(flipped.begin(), end, bit) != end) continue;
    flipped[count++] = bit;
    flip(frame, bit);
  }
  return frame;
}

bool is_acceptable(const can::CanFrame& frame) noexcept {
  can::FrameStamp stamp;
  LegCommand command;
  LegSensors leg;
  can::LegStatus status;
  FootSensors foot;
  ImuSensors imu;
  LegInertialSensors leg_inertial;
  FootInertialSensors foot_inertial;
  can::Heartbeat heartbeat;
  can::Emergency emergency;
  constexpr auto kNone = can::Rejection::kNone;
  return can::decode_sync(frame, stamp) == kNone || can::decode_leg_command(frame, stamp, command) == kNone ||
         can::decode_leg_state(frame, stamp, leg, status) == kNone ||
         can::decode_foot_force(frame, stamp, foot) == kNone || can::decode_imu(frame, stamp, imu) == kNone ||
         can::decode_leg_inertial(frame, stamp, leg_inertial) == kNone ||
         can::decode_foot_inertial(frame, stamp, foot_inertial) == kNone ||
         can::decode_heartbeat(frame, stamp, heartbeat) == kNone ||
         can::decode_emergency(frame, stamp, emergency) == kNone;
}

bool is_answer(const can::CanFrame& frame, std::uint32_t tick) noexcept {
  can::FrameStamp stamp;
  LegSensors leg;
  can::LegStatus status;
  FootSensors foot;
  ImuSensors imu;
  LegInertialSensors leg_inertial;
  FootInertialSensors foot_inertial;
  constexpr auto kNone = can::Rejection::kNone;
  const bool is_state = can::decode_leg_state(frame, stamp, leg, status) == kNone ||
                        can::decode_foot_force(frame, stamp, foot) == kNone ||
                        can::decode_imu(frame, stamp, imu) == kNone ||
                        can::decode_leg_inertial(frame, stamp, leg_inertial) == kNone ||
                        can::decode_foot_inertial(frame, stamp, foot_inertial) == kNone;
  return is_state && stamp.tick == (tick & 0xFFFFU);
}

can::Node twin_of(can::Node node) noexcept {
  switch (node) {
    case can::Node::kLegRight:
      return can::Node::kLegLeft;
    case can::Node::kLegLeft:
      return can::Node::kLegRight;
    case can::Node::kFootRight:
      return can::Node::kFootLeft;
    case can::Node::kFootLeft:
      return can::Node::kFootRight;
    default:
      return node;
  }
}

can::CanFrame swapped(can::CanFrame frame, bool is_sealed) noexcept {
  const auto function = static_cast<std::uint16_t>(frame.identifier & kFunctionMask);
  const auto node = static_cast<can::Node>(frame.identifier & kNodeMask);
  if (!is_owned_by_a_board(function) || twin_of(node) == node) return frame;
  frame.identifier = static_cast<std::uint16_t>(function | static_cast<std::uint16_t>(twin_of(node)));
  if (!is_sealed) return frame;
  // As in the contract: the CRC comes first, but last where CiA 301 gives byte 0 a meaning.
  const bool is_service =
      function == can::emergency_identifier(can::Node{0}) || function == can::heartbeat_identifier(can::Node{0});
  const std::size_t crc_offset = is_service ? 6 : 0;
  if (frame.length >= crc_offset + 2) can::protect(frame, crc_offset);
  return frame;
}

}  // namespace surefoot::sim_hw
