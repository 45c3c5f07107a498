#pragma once

#include <cstdint>
#include <vector>

#include "firmware/host/memory_bus.hpp"
#include "firmware/host/run_recorder.hpp"
#include "sim_hw/bus/tick_timeline.hpp"
#include "tools/run/verdict.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {

/// Everything that crosses the bus of a lockstep run is weighed and timed, and recorded when there is a recorder.
class BusWatch final : public host::BusTap {
 public:
  /// @param recorder  may be null; outlives the watch
  BusWatch(const scenario::Scenario&, host::RunRecorder* recorder);

  void on_frame(const can::CanFrame& frame) noexcept override {
    timeline_.take(frame);
    ++frames_;
    if (recorder_ != nullptr) recorder_->on_frame(frame);
  }

  /// Load of the fuller bus up to now.
  [[nodiscard]] double load_percent(std::int64_t ticks) const noexcept {
    return timeline_.load_percent(ticks * period_ns_);
  }
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }

  /// Ends the run after so many ticks: every frame that waits is sent. What each bus carried, worst case beside
  /// observed.
  [[nodiscard]] std::vector<BusTraffic> finish(std::int64_t ticks);

 private:
  sim_hw::BusConfig config_;
  sim_hw::TrafficOptions traffic_;
  double period_s_;
  std::int64_t period_ns_;
  host::RunRecorder* recorder_;
  sim_hw::TickTimeline timeline_;
  std::uint64_t frames_ = 0;
};

}  // namespace surefoot::run
