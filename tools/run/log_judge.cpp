#include "tools/run/log_judge.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <vector>

#include "tools/run/judge.hpp"
#include "tools/run/telemetry_messages.hpp"

namespace surefoot::run {
namespace {

/// A link that was down, or a node that was dead, leaves gaps; a recording that broke off leaves a longer one.
constexpr std::int64_t kLongestGapTicks = 2000;

/// The events of one log, taken tick by tick.
class EventCursor {
 public:
  explicit EventCursor(const std::vector<event_t>& events) : events_(events) {}

  void take(std::int64_t tick, std::vector<RunEvent>& into) {
    for (; next_ < events_.size() && events_[next_].tick <= tick; ++next_) {
      const event_t& event = events_[next_];
      into.push_back({event.code, event_name(event.code, event.value), event.value});
    }
  }

 private:
  const std::vector<event_t>& events_;
  std::size_t next_ = 0;
};

}  // namespace

Verdict judge_logs(const scenario::Scenario& scenario, const TelemetryLog& firmware, const TelemetryLog& robot,
                   bool was_interrupted) {
  Judge judge(scenario);
  EventCursor world(robot.events);
  EventCursor decisions(firmware.events);
  sim_hw::GroundTruth truth{};
  std::size_t next_truth = 0;
  std::int64_t last_truth_tick = firmware.states.empty() ? 0 : firmware.states.front().tick;
  std::vector<RunEvent> events;
  for (const controller_state_t& state : firmware.states) {
    if (judge.is_over()) break;
    for (; next_truth < robot.truths.size() && robot.truths[next_truth].tick <= state.tick; ++next_truth) {
      truth = truth_of(robot.truths[next_truth]);
      last_truth_tick = robot.truths[next_truth].tick;
    }
    if (state.tick - last_truth_tick > kLongestGapTicks) {
      throw TelemetryLogError(
          fmt::format("the robot's log ends at tick {}, the firmware's goes on to {}: no verdict\n"
                      "  remedy: see whether the robot's recording failed, and run again",
                      last_truth_tick, firmware.states.back().tick));
    }
    events.clear();
    world.take(state.tick, events);
    decisions.take(state.tick, events);
    judge.observe(output_of(state), truth, events);
  }
  return judge.verdict(was_interrupted);
}

}  // namespace surefoot::run
