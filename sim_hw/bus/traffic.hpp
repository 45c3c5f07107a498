#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "firmware/can/identifiers.hpp"
#include "sim_hw/bus/frame_bits.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// What sends a stream's frames into the tick.
enum class StreamKind : std::uint8_t {
  kSync,       ///< begins the tick
  kState,      ///< a node's answer to SYNC
  kCommand,    ///< torques or angles, when all states are there
  kHeartbeat,  ///< every 100 ticks, each node in a tick of its own
  kEmergency,  ///< seldom: no period, and no part of a healthy tick
};

/// What a robot's healthy tick is made of, beside what every robot has.
struct TrafficOptions {
  bool has_inertial_legs = false;  ///< legs and feet answer with a second frame
  bool commands_angles = false;    ///< the controller commands angles, and torques only to damp
};

/// Which robots have a stream in their healthy ticks.
enum class StreamUse : std::uint8_t { kAlways, kInertialLegs, kTorques, kAngles };

/// One identifier of the walking robots' message set.
struct TrafficStream {
  std::uint16_t identifier = 0;
  const char* name = "";  ///< as in surefoot.dbc
  can::Node sender = can::Node::kController;
  StreamKind kind = StreamKind::kSync;
  std::uint8_t length = 0;         ///< payload bytes
  std::uint32_t period_ticks = 1;  ///< control ticks from frame to frame; 0: none
  StreamUse use = StreamUse::kAlways;
};

/// The streams that a robot sends, by rising identifier. One that is no part of its healthy tick has no period.
[[nodiscard]] std::vector<TrafficStream> streams_of(TrafficOptions options);

/// Every stream of the CAN contract, by rising identifier. Lengths are the codec's.
[[nodiscard]] std::span<const TrafficStream> robot_traffic() noexcept;

/// Place of an identifier in `robot_traffic()`, or `kNoStream` when the contract does not know it.
inline constexpr std::size_t kNoStream = 0xFF;
[[nodiscard]] std::size_t stream_of(std::uint16_t identifier) noexcept;

inline constexpr std::uint32_t kMaxBuses = 2;

/// Whether a frame of this identifier goes over bus `bus` of `count`. What the controller tells everybody
/// (SYNC, heartbeat, emergency) goes over all of them; right leg and foot and the torso IMU, and identifiers
/// that the contract does not know, over the first; left leg and foot over the second.
[[nodiscard]] bool travels_on(std::uint16_t identifier, std::uint32_t bus, std::uint32_t count) noexcept;

/// Bit times, rounded to whole nanoseconds.
[[nodiscard]] BitTiming bit_timing(const BusConfig&) noexcept;

}  // namespace surefoot::sim_hw
