#include "tools/sweep/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "tools/scenario/field.hpp"
#include "tools/sweep/key_kind.hpp"

namespace surefoot::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// First and last instant at which a payload, or what it does to the balance, was noticed.
run::Range detections_s(const run::Verdict& verdict) {
  run::Range range;
  for (const run::TimedEvent& event : verdict.events) {
    for (const char* const name : {"payload_detected", "payload_seen", "balance_lost"}) {
      if (std::strcmp(event.name, name) == 0) range.include(event.time_s);
    }
  }
  return range;
}

/// Takes the figures of one run, and on the way the columns' names.
class RowWriter {
 public:
  RowWriter(std::vector<Column>& columns, std::vector<std::string>& row) : columns_(columns), row_(row) {}

  void text(const char* name, std::string value) { add(name, ColumnType::kText, std::move(value)); }
  void integer(const char* name, std::int64_t value) { add(name, ColumnType::kInteger, fmt::format("{}", value)); }
  void number(const char* name, double value) {
    add(name, ColumnType::kNumber, std::isnan(value) ? "nan" : scenario::toml_number(value));
  }
  void range(const char* first_name, const char* last_name, const run::Range& range) {
    number(first_name, range.is_empty ? kNone : range.min);
    number(last_name, range.is_empty ? kNone : range.max);
  }
  void add(std::string name, ColumnType type, std::string value) {
    columns_.push_back({std::move(name), type});
    row_.push_back(std::move(value));
  }

 private:
  std::vector<Column>& columns_;
  std::vector<std::string>& row_;
};

void write_verdict(RowWriter& writer, const run::Verdict& verdict) {
  writer.text("outcome", run::name(verdict.outcome));
  writer.text("reason", verdict.reason);
  writer.number("ended_at_s", verdict.ended_at_s);
  writer.range("pitch_min_deg", "pitch_max_deg", verdict.torso_pitch_deg);
  writer.range("roll_min_deg", "roll_max_deg", verdict.torso_roll_deg);
  writer.number("distance_m", verdict.distance_m);
  writer.integer("steps_walked", verdict.steps_walked);
  writer.number("cycles_after_recovery", verdict.cycles_after_recovery);
  writer.integer("payloads_attached", verdict.payloads_attached);
  writer.integer("payloads_detected", verdict.payloads_detected);
  writer.range("first_detection_s", "last_detection_s", detections_s(verdict));
  writer.integer("disturbance_triggers", verdict.disturbance_triggers);
  writer.integer("false_alarms", verdict.false_alarms);
  writer.number("peak_torque_nm", *std::ranges::max_element(verdict.peak_torque_nm));
  writer.number("torque_ripple_nm", verdict.torque_ripple_nm);
  writer.number("time_at_torque_limit_percent", verdict.time_at_torque_limit_percent);
  writer.number("foot_slip_mm", verdict.foot_slip_mm);
  writer.integer("frames_lost", static_cast<std::int64_t>(verdict.frames_lost));
}

ColumnType type_of(const std::string& key) {
  const std::optional<KeyKind> kind = kind_of(key);
  if (kind == KeyKind::kNumber) return ColumnType::kNumber;
  return kind == KeyKind::kInteger ? ColumnType::kInteger : ColumnType::kText;
}

/// One field of CSV.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

Json json_of(const std::string& text, ColumnType type) {
  if (type == ColumnType::kText) return text;
  if (type == ColumnType::kInteger) return std::stoll(text);
  return std::stod(text);  // nlohmann writes what is no number as null
}

template <typename Texts, typename Project>
std::string csv_line(const Texts& texts, const Project& project) {
  std::string line;
  for (const auto& text : texts) line += (&text == &texts.front() ? "" : ",") + field(project(text));
  return line + "\r\n";
}

}  // namespace

std::string shell_word(const std::string& text) {
  constexpr const char* kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=+:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return quoted + "'";
}

std::string command_of(const Sweep& sweep, std::size_t row) {
  std::string command = "surefoot run";
  const std::string file = sweep.batch.scenario_file.string();
  if (!file.empty()) command += " " + shell_word(file.starts_with('-') ? "./" + file : file);
  for (const auto* overrides : {&sweep.batch.common, &sweep.batch.trials.at(row).overrides}) {
    for (const std::string& text : *overrides) command += " --set " + shell_word(text);
  }
  return command;
}

Results results_of(const Sweep& sweep, const std::vector<run::Verdict>& verdicts) {
  Results results;
  for (std::size_t row = 0; row < verdicts.size(); ++row) {
    results.columns.clear();
    RowWriter writer(results.columns, results.rows.emplace_back());
    writer.integer("row", static_cast<std::int64_t>(row));
    for (std::size_t key = 0; key < sweep.keys.size(); ++key) {
      writer.add(sweep.keys[key], type_of(sweep.keys[key]), sweep.values.at(row).at(key));
    }
    write_verdict(writer, verdicts[row]);
    writer.text("command", command_of(sweep, row));
  }
  return results;
}

std::string to_csv(const Results& results) {
  std::string csv = csv_line(results.columns, [](const Column& column) { return column.name; });
  for (const auto& row : results.rows) csv += csv_line(row, [](const std::string& text) { return text; });
  return csv;
}

std::string to_json(const Results& results) {
  std::string json;
  for (const std::vector<std::string>& row : results.rows) {
    Json object = Json::object();
    for (std::size_t column = 0; column < row.size(); ++column) {
      object[results.columns[column].name] = json_of(row[column], results.columns[column].type);
    }
    json += (json.empty() ? "[\n" : ",\n") + object.dump();
  }
  return json + "\n]\n";
}

}  // namespace surefoot::sweep
