#pragma once

#include <array>
#include <cstdint>

#include "firmware/host/loop/firmware_loop.hpp"
#include "firmware/host/run_recorder.hpp"
#include "tools/run/event_watch.hpp"
#include "tools/run/stabilizer_message.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Puts what the firmware does tick by tick into a recording, and counts the loop's allocations.
class FirmwareRecorder final : public host::TickObserver {
 public:
  /// @param recorder  may be null
  /// @param waits     lockstep: wait between ticks for room, so that nothing is dropped
  FirmwareRecorder(const scenario::Scenario& scenario, host::RunRecorder* recorder, bool waits) noexcept;

  void before_tick(std::int64_t elapsed_us) noexcept override;
  void after_tick(const host::FirmwareNode& node, const TickOutput& output) noexcept override;
  void between_ticks(const host::LoopReport* report) noexcept override;

  [[nodiscard]] std::uint64_t allocations() const noexcept { return allocations_; }

 private:
  host::RunRecorder* recorder_;
  bool waits_;
  double period_s_;
  double time_zero_s_;
  std::uint32_t telemetry_every_;
  StabilizerTelemetry stabilizer_;
  EventWatch events_{};
  std::int64_t utime_us_ = 0;
  std::uint32_t tick_ = 0;
  std::uint64_t allocations_ = 0;
};

}  // namespace surefoot::run
