#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/core/controller.hpp"
#include "sim_hw/faults/fault_config.hpp"
#include "sim_hw/ground_truth.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::run {

/// Something that happened in one tick; codes and meaning of the value: lcm_types/event_t.lcm.
struct RunEvent {
  std::int8_t code = 0;
  const char* name = "";
  double value = 0.0;
};

/// The name that belongs to a recorded event; "unknown" for a code of another version.
[[nodiscard]] const char* event_name(std::int8_t code, double value) noexcept;

/// Turns what changes from tick to tick into events, for telemetry and verdict alike. Firmware and robot may
/// live in two processes: each then watches its own half.
class EventWatch {
 public:
  /// Both halves, the world's first.
  /// @return the events of this tick, valid until the next call; mostly none
  [[nodiscard]] std::span<const RunEvent> observe(const TickOutput& output, const sim_hw::GroundTruth& truth) noexcept;

  /// What happened in the world.
  [[nodiscard]] std::span<const RunEvent> observe_world(const sim_hw::GroundTruth& truth) noexcept;

  /// What the firmware did.
  [[nodiscard]] std::span<const RunEvent> observe_firmware(const TickOutput& output) noexcept;

 private:
  void watch(const sim_hw::GroundTruth& truth) noexcept;
  void watch(const TickOutput& output) noexcept;
  void watch_faults(std::uint32_t active) noexcept;
  void watch_payloads(const sim_hw::GroundTruth& truth) noexcept;
  void watch_pushes(const sim_hw::GroundTruth& truth) noexcept;
  void add(std::int8_t code, const char* name, double value) noexcept { events_[count_++] = {code, name, value}; }

  /// At most one of each kind in a tick, or of each fault, begin and end of each push.
  std::array<RunEvent, 7 + sim_hw::kMaxFaults + 2 * sim_hw::kMaxPushes> events_{};
  std::size_t count_ = 0;
  int payloads_hung_ = 0;
  double payload_kg_ = 0.0;
  int payloads_removed_ = 0;
  double removed_kg_ = 0.0;
  std::uint32_t pushes_begun_ = 0;
  std::uint32_t pushes_ended_ = 0;
  bool has_fallen_ = false;
  std::uint32_t faults_active_ = 0;
  bool is_reachable_ = true;
  safety::Fault fault_ = safety::Fault::kNone;
};

}  // namespace surefoot::run
