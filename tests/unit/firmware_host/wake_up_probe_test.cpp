#include "firmware/host/realtime/wake_up_probe.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "firmware/host/realtime/monotonic_clock.hpp"

namespace surefoot::host {
namespace {

/// Asks for no right: what is tested is the counting, and the machine's scheduling stays as it is.
WakeUpProbe humble_probe() {
  WakeUpProbe probe;
  probe.period_ns = 100'000;
  probe.ticks = 50;
  probe.rights = {.fifo_priority = 0,
                  .cpu = RealtimeRequest::kAnyCpu,
                  .keep_cpu_awake = false,
                  .memory = {.lock_all = false, .stack_prefault_bytes = 0, .heap_reserve_bytes = 0}};
  return probe;
}

TEST(WakeUpProbe, EveryInstantOfTheGridIsMetOrMissed) {
  const std::atomic<bool> stop{false};
  const std::int64_t begin_ns = MonotonicClock::now_ns();
  const std::vector<WakeUpMeasurement> measured = measure(humble_probe(), stop);
  const std::int64_t elapsed_ns = MonotonicClock::now_ns() - begin_ns;
  ASSERT_EQ(measured.size(), 1U);
  const auto met = static_cast<std::int64_t>(measured[0].wake_up.count());
  EXPECT_GE(met, 1);
  EXPECT_LE(met, 50);
  EXPECT_GE(met + measured[0].missed_ticks, 50);
  EXPECT_GE(elapsed_ns, 50 * 100'000);
  EXPECT_TRUE(measured[0].missing.empty());
  EXPECT_GE(measured[0].usage.voluntary_switches, 1);
}

TEST(WakeUpProbe, MeasuresWithOneThreadForEachProcessorAndSaysWhatEachWasDenied) {
  WakeUpProbe probe = humble_probe();
  probe.ticks = 3;
  probe.cpus = {RealtimeRequest::kAnyCpu, 100'000};
  const std::atomic<bool> stop{false};
  const std::vector<WakeUpMeasurement> measured = measure(probe, stop);
  ASSERT_EQ(measured.size(), 2U);
  EXPECT_TRUE(measured[0].missing.empty());
  EXPECT_EQ(measured[1].cpu, 100'000);
  EXPECT_EQ(measured[1].missing.size(), 1U);
  EXPECT_GE(measured[1].wake_up.count(), 1U);
}

TEST(WakeUpProbe, EndsWhenStopped) {
  WakeUpProbe probe = humble_probe();
  probe.period_ns = 3'600'000'000'000;
  const std::atomic<bool> stop{true};
  EXPECT_EQ(measure(probe, stop)[0].wake_up.count(), 0U);
}

TEST(WakeUpProbe, RefusesAPeriodThatIsNone) {
  WakeUpProbe probe = humble_probe();
  probe.period_ns = 0;
  const std::atomic<bool> stop{false};
  EXPECT_THROW((void)measure(probe, stop), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::host
