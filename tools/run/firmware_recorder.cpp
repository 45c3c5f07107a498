#include "tools/run/firmware_recorder.hpp"

#include <cmath>

#include "firmware/host/allocation_guard.hpp"
#include "tools/run/telemetry_messages.hpp"

namespace surefoot::run {
namespace {

constexpr std::uint32_t kBusStatisticsTicks = 100;

}  // namespace

FirmwareRecorder::FirmwareRecorder(const scenario::Scenario& scenario, host::RunRecorder* recorder, bool waits) noexcept
    : recorder_(recorder),
      waits_(waits),
      period_s_(scenario.firmware.period_s),
      time_zero_s_(scenario.sim.time_zero_s),
      telemetry_every_(scenario.telemetry.every_ticks),
      stabilizer_(scenario.firmware) {}

void FirmwareRecorder::before_tick(std::int64_t elapsed_us) noexcept {
  if (recorder_ != nullptr) {
    if (waits_) recorder_->wait_for_room();
    recorder_->set_elapsed(elapsed_us);
  }
  host::allocation_guard::arm();
}

void FirmwareRecorder::after_tick(const host::FirmwareNode& node, const TickOutput& output) noexcept {
  tick_ = output.tick;
  utime_us_ = std::llround((output.tick * period_s_ - time_zero_s_) * 1e6);
  const std::span<const RunEvent> events = events_.observe_firmware(output);
  if (recorder_ == nullptr) return;
  for (const RunEvent& event : events) {
    recorder_->push(host::Channel::kEvent, utime_us_,
                    event_message(utime_us_, output.tick, event.code, event.name, event.value));
  }
  if (output.tick % telemetry_every_ == 0) {
    recorder_->push(host::Channel::kControllerState, utime_us_, state_message(utime_us_, output, node.snapshot()));
    stabilizer_.push(*recorder_, utime_us_, output);
  }
  if (output.tick % kBusStatisticsTicks == kBusStatisticsTicks - 1) {
    recorder_->push(host::Channel::kBusStatistics, utime_us_,
                    bus_message(utime_us_, output.tick, node.counters(), 0.0));
  }
}

void FirmwareRecorder::between_ticks(const host::LoopReport* report) noexcept {
  allocations_ += host::allocation_guard::disarm().allocations;
  if (report == nullptr || recorder_ == nullptr) return;
  recorder_->push(host::Channel::kTimingStatistics, utime_us_, timing_message(utime_us_, tick_, *report));
}

}  // namespace surefoot::run
