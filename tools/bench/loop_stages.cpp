#include "tools/bench/loop_stages.hpp"

#include <cstdint>
#include <vector>

#include "tools/bench/relayed_loop.hpp"
#include "tools/bench/stopwatch.hpp"
#include "tools/run/lockstep_loop.hpp"

namespace surefoot::bench {
namespace {

constexpr std::int64_t kTicksPerRound = 1600;

double bus_watch_us(const scenario::Scenario& scenario, const std::vector<TickFrames>& ticks) {
  run::BusWatch watch(scenario, nullptr);
  const double start_us = cpu_us();
  for (const TickFrames& frames : ticks) {
    for (const auto* some : {&frames.sync, &frames.answers, &frames.commands, &frames.later}) {
      for (const can::CanFrame& frame : *some) watch.on_frame(frame);
    }
  }
  keep(watch);
  return cpu_us() - start_us;
}

}  // namespace

LoopStages loop_stages(const scenario::Scenario& scenario, double seconds) {
  const double budget_s = 0.25 * seconds;
  RelayedLoop loop(scenario);
  loop.run_to(run::schedule_of(scenario).zero_tick);
  loop.keep_ticks(kTicksPerRound);
  LoopStages stages;
  stages.sensors = loop.sensors();
  stages.firmware_us = least_us(budget_s, kTicksPerRound, [&] { return loop.firmware_us(); });
  stages.robot_us = least_us(budget_s, kTicksPerRound, [&] { return loop.robot_us(); });
  stages.bus_watch_us = least_us(budget_s, kTicksPerRound, [&] { return bus_watch_us(scenario, loop.kept()); });
  run::EventWatch events;
  run::Judge judge(scenario);
  stages.judge_us = least_us_per_call(
      budget_s, [&] { judge.observe(loop.output(), loop.truth(), events.observe(loop.output(), loop.truth())); });
  return stages;
}

double closed_loop_us(const scenario::Scenario& scenario, double seconds) {
  const std::int64_t zero_tick = run::schedule_of(scenario).zero_tick;
  run::LockstepLoop past(scenario, nullptr, false);
  past.run_to(zero_tick, {});
  return least_us(seconds, kTicksPerRound, [&] {
    run::LockstepLoop loop(past, scenario);
    const double start_us = cpu_us();
    loop.run_to(zero_tick + kTicksPerRound, {});
    return cpu_us() - start_us;
  });
}

}  // namespace surefoot::bench
