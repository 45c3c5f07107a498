#include "firmware/host/loop/firmware_loop.hpp"

#include <algorithm>
#include <array>

#include "firmware/host/realtime/monotonic_clock.hpp"
#include "firmware/host/realtime/silence_watch.hpp"

namespace surefoot::host {
namespace {

constexpr std::int64_t kStopCheck_ns = 50'000'000;  // a stop is heard within this time
constexpr std::int64_t kReportPeriod_ns = 1'000'000'000;

/// Keeps what is sent until `flush`: torques of one tick and SYNC of the next cross the kernel together.
class HeldBus final : public can::CanBus {
 public:
  explicit HeldBus(can::CanBus& bus) noexcept : bus_(bus) {}

  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    std::size_t taken = 0;
    while (taken < frames.size() && count_ < held_.size()) held_[count_++] = frames[taken++];
    return taken;
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override { return bus_.receive(frames); }

  void flush() noexcept {
    // What the bus refuses is lost and shows as a gap: the tick does not wait.
    refused_ += count_ - bus_.send({held_.data(), count_});
    count_ = 0;
  }

  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }

 private:
  can::CanBus& bus_;
  std::array<can::CanFrame, 8> held_{};
  std::size_t count_ = 0;
  std::uint64_t refused_ = 0;
};

class Loop {
 public:
  Loop(FirmwareNode& node, HostBus& bus, const FirmwareLoopConfig& config, TickObserver& observer,
       const std::atomic<bool>& stop) noexcept
      : node_(node), bus_(bus), config_(config), observer_(observer), stop_(stop), clock_(stop) {}

  FirmwareLoopResult run() noexcept {
    usage_before_ = thread_resource_usage();
    if (config_.clock == LoopClock::kLockstep) {
      run_lockstep();
    } else {
      run_on_wall_clock();
    }
    result_.report = report();
    result_.ticks = tick_;
    return result_;
  }

 private:
  [[nodiscard]] bool is_over() const noexcept {
    if (stop_.load(std::memory_order_relaxed)) return true;
    if (config_.ticks > 0 && tick_ >= config_.ticks) return true;
    if (result_.fault == safety::Fault::kNone) return false;
    return config_.ends_at_fault || (config_.ends_when_robot_returns && node_.has_robot_restarted());
  }

  void run_lockstep() noexcept {
    HeldBus held(bus_);
    std::int64_t reported_ns = MonotonicClock::now_ns();
    for (; !is_over(); ++tick_) {
      observer_.before_tick(tick_ * config_.period_ns / 1000);
      const std::int64_t begin_ns = MonotonicClock::now_ns();
      node_.begin_tick(held);
      held.flush();
      const std::int64_t sent_ns = MonotonicClock::now_ns();
      if (!await_answers(held, sent_ns)) ++result_.silent_ticks;
      const std::int64_t answered_ns = MonotonicClock::now_ns();
      finish(held);
      const std::int64_t end_ns = MonotonicClock::now_ns();
      compute_.add((sent_ns - begin_ns) + (end_ns - answered_ns));
      frame_.add(answered_ns - sent_ns);
      report_now_and_then(end_ns, reported_ns);
    }
    held.flush();
    result_.refused_by_bus = held.refused();
  }

  /// @return false when the robot did not answer in time
  [[nodiscard]] bool await_answers(can::CanBus& bus, std::int64_t sent_ns) noexcept {
    const std::int64_t patience_ns = is_silent_ ? config_.silent_period_ns : config_.silence_ns;
    SilenceWatch silence(2 * kStopCheck_ns);
    silence.restart(sent_ns);
    while (!node_.collect(bus)) {
      const std::int64_t now_ns = MonotonicClock::now_ns();
      const std::int64_t silent_ns = silence.look(now_ns);
      is_silent_ = silent_ns >= patience_ns;
      if (is_silent_ || stop_.load(std::memory_order_relaxed)) return false;
      static_cast<void>(bus_.wait_readable(now_ns + std::min(kStopCheck_ns, patience_ns - silent_ns)));
    }
    is_silent_ = false;
    return true;
  }

  void run_on_wall_clock() noexcept {
    const auto window_ns = static_cast<std::int64_t>(config_.receive_window * static_cast<double>(config_.period_ns));
    if (!clock_.sleep_until_ns(MonotonicClock::now_ns() + 2 * config_.period_ns)) return;
    // The grid begins with its first tick, however late that is: a robot meets its master at tick 0.
    const std::int64_t start_ns = MonotonicClock::now_ns();
    grid_ = PeriodGrid(start_ns, config_.period_ns, config_.overruns);
    std::int64_t reported_ns = start_ns;
    while (!is_over() && clock_.sleep_until_ns(grid_.due_ns())) {
      const std::int64_t due_ns = grid_.due_ns();
      const std::int64_t begin_ns = MonotonicClock::now_ns();
      wake_up_.add(begin_ns - due_ns);
      if (begin_ns - due_ns >= config_.period_ns) {
        go_on(begin_ns, 1);
        continue;
      }
      observer_.before_tick((begin_ns - start_ns) / 1000);
      node_.begin_tick(bus_);
      const std::int64_t sent_ns = MonotonicClock::now_ns();
      bool is_complete = node_.collect(bus_);
      // From SYNC on, not from the instant: a tick that began late needs its answers just as much, and the grid
      // keeps the phase.
      while (!is_complete && bus_.wait_readable(sent_ns + window_ns)) {
        is_complete = node_.collect(bus_);
        if (MonotonicClock::now_ns() >= sent_ns + window_ns) break;  // a flooded bus is always readable
      }
      const std::int64_t answered_ns = MonotonicClock::now_ns();
      finish(bus_);
      const std::int64_t end_ns = MonotonicClock::now_ns();
      compute_.add((sent_ns - begin_ns) + (end_ns - answered_ns));
      if (is_complete) frame_.add(answered_ns - sent_ns);
      ++ran_;
      go_on(end_ns, 0);
      report_now_and_then(end_ns, reported_ns);
    }
  }

  void finish(can::CanBus& bus) noexcept {
    const TickOutput& output = node_.finish_tick(bus);
    result_.fault = output.fault;
    observer_.after_tick(node_, output);
  }

  /// To the next instant that can still be met.
  /// @param unsent  1 when the tick at work was not sent, for it came too late itself
  void go_on(std::int64_t now_ns, std::int64_t unsent) noexcept {
    const Wake wake = grid_.advance(now_ns);
    const std::int64_t missed = wake.missed + unsent;
    const std::int64_t made_up_for = std::min(missed, config_.most_missed_at_once);
    if (missed > made_up_for) node_.request_stop({safety::Fault::kLoopOverrun, safety::SafeState::kDamp});
    for (std::int64_t tick = 0; tick < made_up_for; ++tick) node_.miss_tick();
    node_.skip_ticks(static_cast<std::uint32_t>(missed - made_up_for));
    tick_ = wake.tick;
    unsent_ += unsent;
    if (grid_.is_degraded()) node_.request_stop(finding_of(safety::Fault::kLoopOverrun));
  }

  void report_now_and_then(std::int64_t now_ns, std::int64_t& reported_ns) noexcept {
    if (now_ns - reported_ns < kReportPeriod_ns) return observer_.between_ticks(nullptr);
    reported_ns = now_ns;
    const LoopReport now = report();
    observer_.between_ticks(&now);
  }

  [[nodiscard]] LoopReport report() const noexcept {
    const std::int64_t ran = config_.clock == LoopClock::kLockstep ? tick_ : ran_;
    LoopReport report = report_of(ran, grid_, wake_up_, compute_, frame_, thread_resource_usage() - usage_before_);
    report.missed_ticks += unsent_;
    return report;
  }

  FirmwareNode& node_;
  HostBus& bus_;
  const FirmwareLoopConfig& config_;
  TickObserver& observer_;
  const std::atomic<bool>& stop_;
  MonotonicClock clock_;
  PeriodGrid grid_{0, 1};
  TickHistogram wake_up_;
  TickHistogram compute_;
  TickHistogram frame_;
  FirmwareLoopResult result_;
  ResourceUsage usage_before_{};
  std::int64_t tick_ = 0;
  std::int64_t ran_ = 0;
  std::int64_t unsent_ = 0;  ///< ticks that were due, and too late when they began
  bool is_silent_ = false;
};

}  // namespace

FirmwareLoopResult run_firmware_loop(FirmwareNode& node, HostBus& bus, const FirmwareLoopConfig& config,
                                     TickObserver& observer, const std::atomic<bool>& stop) noexcept {
  return Loop(node, bus, config, observer, stop).run();
}

}  // namespace surefoot::host
