#include "tools/run/verdict.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/run/histogram_json.hpp"

namespace surefoot::run {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, double step) { return std::round(value / step) * step; }

Json json_of(const Range& range) { return {{"min", range.min}, {"max", range.max}}; }

Json json_of(const BusTraffic& bus) {
  Json streams = Json::array();
  for (const StreamTiming& stream : bus.streams) {
    streams.push_back({{"identifier", fmt::format("0x{:03X}", stream.identifier)},
                       {"name", stream.name},
                       {"frames", stream.frames},
                       {"worst_case_us", stream.worst_case_us ? Json(*stream.worst_case_us) : Json(nullptr)},
                       {"observed_us", stream.observed_us}});
  }
  return {{"load_percent", bus.load_percent},
          {"frames", bus.frames},
          {"nominal_bits", bus.nominal_bits},
          {"data_bits", bus.data_bits},
          {"busy_ns", bus.busy_ns},
          {"elapsed_ns", bus.elapsed_ns},
          {"identifiers", streams}};
}

std::string event_time_line(const Verdict& verdict) {
  std::string lines;
  for (std::size_t i = 0; i < verdict.events.size(); ++i) {
    const TimedEvent& event = verdict.events[i];
    const double since_last_s = i == 0 ? 0.0 : event.time_s - verdict.events[i - 1].time_s;
    lines += fmt::format("    {:>9.4f} s  {:+9.4f}  {}\n", event.time_s, since_last_s, event.name);
  }
  return lines;
}

}  // namespace

const char* name(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::kWalked:
      return "walked";
    case Outcome::kFell:
      return "fell";
    case Outcome::kLimit:
      return "limit";
    case Outcome::kFault:
      return "fault";
    case Outcome::kInterrupted:
      return "interrupted";
  }
  return "unknown";
}

ExitCode exit_code(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::kWalked:
      return ExitCode::kVerdictHolds;
    case Outcome::kFell:
    case Outcome::kLimit:
      return ExitCode::kFellOrLimit;
    case Outcome::kFault:
      return ExitCode::kFault;
    case Outcome::kInterrupted:
      return ExitCode::kInterrupted;
  }
  return ExitCode::kBug;
}

std::string to_json(const Verdict& verdict) {
  Json events = Json::array();
  for (const TimedEvent& event : verdict.events) {
    events.push_back({{"name", event.name}, {"time_s", rounded(event.time_s, 1e-6)}});
  }
  Json peaks = Json::object();
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    peaks[kLegJointNames[joint]] = rounded(verdict.peak_torque_nm[joint], 1e-3);
  }
  Json buses = Json::array();
  for (const BusTraffic& bus : verdict.bus) buses.push_back(json_of(bus));
  const Json json{
      {"verdict", name(verdict.outcome)},
      {"reason", verdict.reason},
      {"ended_at_s", rounded(verdict.ended_at_s, 1e-6)},
      {"torso_pitch_deg", json_of(verdict.torso_pitch_deg)},
      {"torso_roll_deg", json_of(verdict.torso_roll_deg)},
      {"start_up_pitch_deg", json_of(verdict.start_up_pitch_deg)},
      {"start_up_roll_deg", json_of(verdict.start_up_roll_deg)},
      {"distance_m", verdict.distance_m},
      {"steps_walked", verdict.steps_walked},
      {"cycles_after_recovery", rounded(verdict.cycles_after_recovery, 1e-4)},
      {"events", events},
      {"payloads_attached", verdict.payloads_attached},
      {"payloads_detected", verdict.payloads_detected},
      {"payloads_removed", verdict.payloads_removed},
      {"pushes", verdict.pushes},
      {"disturbance_triggers", verdict.disturbance_triggers},
      {"false_alarms", verdict.false_alarms},
      {"peak_torque_nm", peaks},
      {"torque_ripple_nm", verdict.torque_ripple_nm},
      {"time_at_torque_limit_percent", verdict.time_at_torque_limit_percent},
      {"foot_slip_mm", verdict.foot_slip_mm},
      {"standing_zmp_x_body_m", verdict.standing_zmp_x_body_m},
      {"payload_threshold_n", verdict.threshold_n},
      {"unloaded_margin_n", json_of(verdict.unloaded_margin_n)},
      {"unreachable_ticks", verdict.unreachable_ticks},
      {"bus_log_sha256", verdict.bus_log_sha256},
      {"allocations_in_loop", verdict.allocations_were_counted ? Json(verdict.allocations_in_loop) : Json(nullptr)},
      {"tick_us",
       {{"mean", verdict.tick_us_mean},
        {"p50", verdict.tick_us_p50},
        {"p999", verdict.tick_us_p999},
        {"max", verdict.tick_us_max},
        {"histogram", histogram_json(verdict.tick_bins)}}},
      {"real_time_factor", verdict.real_time_factor},
      {"frames_sent", verdict.frames_sent},
      {"frames_lost", verdict.frames_lost},
      {"frames_late", verdict.frames_late},
      {"bus_load_percent", verdict.bus_load_percent},
      {"bus", buses},
  };
  return json.dump(2) + "\n";
}

std::string to_text(const Verdict& verdict) {
  std::string text = fmt::format("  verdict      {}: {}\n", name(verdict.outcome), verdict.reason);
  const bool was_scored = !verdict.torso_pitch_deg.is_empty;
  const Range& pitch = was_scored ? verdict.torso_pitch_deg : verdict.start_up_pitch_deg;
  const Range& roll = was_scored ? verdict.torso_roll_deg : verdict.start_up_roll_deg;
  text += fmt::format("  torso        pitch {:+.2f} to {:+.2f} deg, roll {:+.2f} to {:+.2f} deg{}\n", pitch.min,
                      pitch.max, roll.min, roll.max, was_scored ? "" : " (start-up: the run ended before time zero)");
  text += fmt::format("  walk         {} steps, {:.2f} m, {:.2f} cycles since recovery or start\n",
                      verdict.steps_walked, verdict.distance_m, verdict.cycles_after_recovery);
  if (!verdict.events.empty()) text += "  events\n" + event_time_line(verdict);
  text += "  peak torque ";
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    text += fmt::format(" {} {:.0f}{}", kLegJointNames[joint], verdict.peak_torque_nm[joint],
                        joint + 1 < kJointsPerLeg ? "," : " N m\n");
  }
  text += fmt::format("  chatter      ripple {:.3f} N m a tick, {:.3f} % of the time at the torque limit\n",
                      verdict.torque_ripple_nm, verdict.time_at_torque_limit_percent);
  text += fmt::format("  feet         slip {:.2f} mm a step, standing ZMP {:+.1f} mm\n", verdict.foot_slip_mm,
                      1e3 * verdict.standing_zmp_x_body_m);
  text += fmt::format("  bus          {} frames, {} lost, {} late, load {:.1f} %\n", verdict.frames_sent,
                      verdict.frames_lost, verdict.frames_late, verdict.bus_load_percent);
  text += fmt::format(
      "  tick         p50 {:.2f}, p99.9 {:.2f}, max {:.1f} us; {} allocations in the loop; {:.1f} x real time\n",
      verdict.tick_us_p50, verdict.tick_us_p999, verdict.tick_us_max,
      verdict.allocations_were_counted ? fmt::format("{}", verdict.allocations_in_loop) : "uncounted",
      verdict.real_time_factor);
  return text;
}

}  // namespace surefoot::run
