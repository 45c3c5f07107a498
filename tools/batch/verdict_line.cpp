#include "tools/batch/verdict_line.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

namespace surefoot::batch {
namespace {

using Json = nlohmann::ordered_json;

/// Calls `visit(name, member)` for each member that is kept: the one list for writing and reading.
template <typename AnyVerdict, typename Visit>
void for_each_member(AnyVerdict& verdict, const Visit& visit) {
  visit("outcome", verdict.outcome);
  visit("reason", verdict.reason);
  visit("ended_at_s", verdict.ended_at_s);
  visit("torso_pitch_deg", verdict.torso_pitch_deg);
  visit("torso_roll_deg", verdict.torso_roll_deg);
  visit("start_up_pitch_deg", verdict.start_up_pitch_deg);
  visit("start_up_roll_deg", verdict.start_up_roll_deg);
  visit("distance_m", verdict.distance_m);
  visit("steps_walked", verdict.steps_walked);
  visit("cycles_after_recovery", verdict.cycles_after_recovery);
  visit("events", verdict.events);
  visit("payloads_attached", verdict.payloads_attached);
  visit("payloads_detected", verdict.payloads_detected);
  visit("payloads_removed", verdict.payloads_removed);
  visit("pushes", verdict.pushes);
  visit("disturbance_triggers", verdict.disturbance_triggers);
  visit("false_alarms", verdict.false_alarms);
  visit("peak_torque_nm", verdict.peak_torque_nm);
  visit("torque_ripple_nm", verdict.torque_ripple_nm);
  visit("time_at_torque_limit_percent", verdict.time_at_torque_limit_percent);
  visit("foot_slip_mm", verdict.foot_slip_mm);
  visit("standing_zmp_x_body_m", verdict.standing_zmp_x_body_m);
  visit("threshold_n", verdict.threshold_n);
  visit("unloaded_margin_n", verdict.unloaded_margin_n);
  visit("unreachable_ticks", verdict.unreachable_ticks);
  visit("frames_sent", verdict.frames_sent);
  visit("frames_lost", verdict.frames_lost);
  visit("frames_late", verdict.frames_late);
  visit("bus_load_percent", verdict.bus_load_percent);
}

/// A verdict's event names live as long as the program.
const char* kept_name(const std::string& name) {
  static std::mutex mutex;
  static std::set<std::string> names;
  const std::scoped_lock lock(mutex);
  return names.insert(name).first->c_str();
}

Json json_of(double value) {
  if (std::isfinite(value)) return value;  // in the shortest form that reads back to the same bits
  return std::isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf";
}

double number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  const auto& text = json.get_ref<const std::string&>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return std::numeric_limits<double>::infinity();
  if (text == "-inf") return -std::numeric_limits<double>::infinity();
  throw std::invalid_argument(text);
}

struct Writer {
  Json& json;

  void operator()(const char* name, double value) const { json[name] = json_of(value); }
  void operator()(const char* name, int value) const { json[name] = value; }
  void operator()(const char* name, std::uint64_t value) const { json[name] = value; }
  void operator()(const char* name, const std::string& value) const { json[name] = value; }
  void operator()(const char* name, run::Outcome value) const { json[name] = static_cast<int>(value); }
  void operator()(const char* name, const run::Range& value) const {
    json[name] = value.is_empty ? Json::array() : Json{json_of(value.min), json_of(value.max)};
  }
  void operator()(const char* name, const std::array<double, kJointsPerLeg>& values) const {
    json[name] = Json::array();
    for (const double value : values) json[name].push_back(json_of(value));
  }
  void operator()(const char* name, const std::vector<run::TimedEvent>& events) const {
    json[name] = Json::array();
    for (const run::TimedEvent& event : events) json[name].push_back({event.name, json_of(event.time_s)});
  }
};

/// Every call throws when the member is missing or of another kind.
struct Reader {
  const Json& json;

  void operator()(const char* name, double& value) const { value = number_of(json.at(name)); }
  void operator()(const char* name, int& value) const { json.at(name).get_to(value); }
  void operator()(const char* name, std::uint64_t& value) const { json.at(name).get_to(value); }
  void operator()(const char* name, std::string& value) const { json.at(name).get_to(value); }
  void operator()(const char* name, run::Outcome& value) const {
    const int number = json.at(name).get<int>();
    if (number < 0 || number > static_cast<int>(run::Outcome::kInterrupted)) throw std::invalid_argument(name);
    value = static_cast<run::Outcome>(number);
  }
  void operator()(const char* name, run::Range& value) const {
    const Json& range = json.at(name);
    if (!range.empty()) value = {number_of(range.at(0)), number_of(range.at(1)), false};
  }
  void operator()(const char* name, std::array<double, kJointsPerLeg>& values) const {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) values[joint] = number_of(json.at(name).at(joint));
  }
  void operator()(const char* name, std::vector<run::TimedEvent>& events) const {
    for (const Json& event : json.at(name)) {
      events.push_back({kept_name(event.at(0).get<std::string>()), number_of(event.at(1))});
    }
  }
};

}  // namespace

std::string line_of(const FinishedTrial& finished) {
  Json verdict = Json::object();
  for_each_member(finished.verdict, Writer{verdict});
  return Json{{"trial", finished.trial}, {"scenario", finished.hash}, {"verdict", verdict}}.dump();
}

std::optional<FinishedTrial> read_line(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    FinishedTrial finished{json.at("trial").get<std::size_t>(), json.at("scenario").get<std::string>(), {}};
    for_each_member(finished.verdict, Reader{json.at("verdict")});
    return finished;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace surefoot::batch
