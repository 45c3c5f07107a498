#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "tools/scenario/checks.hpp"
#include "tools/scenario/scenario.hpp"
#include "tools/scenario/toml_reader.hpp"

namespace surefoot::scenario {
namespace {

/// More than the longest effective scenario, all payloads, pushes, patches and faults in it; keeps out /dev/zero and
/// mistaken logs.
constexpr std::size_t kLargestFile = 128 * 1024;

/// Of one line. A key of some ten thousand parts would overflow the stack in the parser's recursion.
constexpr std::ptrdiff_t kMostDots = 1000;

/// tools/scenarios/main.toml without its comments.
constexpr std::string_view kMainJob = R"(plant = "thesis"
duration_s = 20.0

[reflex]
method = "original"

[limits]
max_abs_pitch_deg = 2.5

[[payload]]
mass_kg = 5.0
at_s = 1.2
)";

[[noreturn]] void fail(std::string place, std::string statement, std::string remedy) {
  throw ScenarioError({{std::move(place), std::move(statement), std::move(remedy)}});
}

}  // namespace

std::string read_text(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    fail(name, "there is no such file", "check the path; scenarios to start from are in tools/scenarios");
  }
  if (status.type() == std::filesystem::file_type::directory) {
    fail(name, "is a directory; expected a scenario file", "name a .toml file in it");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  if (stream) {
    text.resize(kLargestFile + 1);
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream && !stream.eof()) {
    fail(name, fmt::format("cannot be read: {}", std::strerror(errno)), "check the permissions of the file");
  }
  if (text.size() > kLargestFile) {
    fail(name, "is larger than 128 KiB; expected a scenario file", "name the scenario, not a log");
  }
  return text;
}

namespace {

void refuse_deep_keys(const std::string& name, std::string_view text) {
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (std::ranges::count(text.substr(0, end), '.') > kMostDots) {
      fail(fmt::format("{}:{}", name, line), "has more than 1000 dots on a line; expected a scenario",
           "name the scenario; surefoot keys shows every key");
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

Document parse(const std::string& name, std::string_view text) {
  refuse_deep_keys(name, text);
  try {
    return {name, toml::parse(text), {}};
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    fail(fmt::format("{}:{}:{}", name, at.line, at.column), fmt::format("is not TOML: {}", error.description()),
         "correct this line; the file must be UTF-8 text, strings in it stand in quotes");
  }
}

Scenario load(const std::filesystem::path& file, std::span<const std::string> overrides) {
  return load_text(file.string(), read_text(file), overrides);
}

Scenario load_text(const std::string& name, std::string_view text, std::span<const std::string> overrides) {
  Document document = parse(name, text);
  if (document.root.empty()) {
    fail(name, "is empty; expected a scenario",
         "start from tools/scenarios/main.toml, or run without a file for the main job");
  }
  apply_overrides(document, overrides);
  return read_scenario(document);
}

Scenario load_default(std::span<const std::string> overrides) { return load_text("main job", kMainJob, overrides); }

bool walks_over_floors(const Scenario& scenario) { return scenario.robot == "khr2" || !scenario.gaits.empty(); }

namespace {

/// The firmware's walk has the durations of the first gait, and the sizes of the largest one.
void share_gaits(Scenario& scenario) {
  ControllerConfig& firmware = scenario.firmware;
  gait::PlannedGaits& gaits = firmware.floor.pattern.gaits;
  gaits = {};
  for (const PlannedGaitConfig& config : scenario.gaits) {
    if (gaits.count == gaits.gait.size()) break;  // one too many is kept for the check of their number
    gaits.gait[gaits.count++] = planned_gait(config, firmware.geometry);
  }
  if (gaits.is_empty()) return;
  const planning::GaitFactors& first = gaits.gait[0].plan.gait;
  firmware.walk.single_support_s = first.single_support_s;
  firmware.walk.double_support_s = first.double_support_s;
  firmware.floor.nominal = {};
}

}  // namespace

void share_numbers(Scenario& scenario) {
  scenario.sim.geometry = scenario.firmware.geometry;
  scenario.sim.control_period_s = scenario.firmware.period_s;
  scenario.firmware.servo.torque_limit_nm = scenario.firmware.gate.torque_limit_nm;
  ControllerConfig& firmware = scenario.firmware;
  firmware.method = walks_over_floors(scenario) ? WalkMethod::kFloorWalk : WalkMethod::kPayloadWalk;
  firmware.floor.stabilizer.sway_amplitude.pattern_sway_m = firmware.walk.sway_m;
  firmware.floor.stabilizer.step_adjustment.com_height_m = firmware.floor.pattern.com_height_m;
  firmware.floor.nominal =
      stabilizer::recorded_table(firmware.floor.pattern.sway_profile, firmware.floor.pattern.step_length_m);
  share_gaits(scenario);
}

void validate(const Scenario& scenario) {
  std::vector<Problem> problems;
  const auto add = [&](const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) problems.push_back({"scenario", finding.statement, finding.remedy});
  };
  add(check_ranges(scenario));
  if (problems.empty()) add(check_relations(scenario));
  if (!problems.empty()) throw ScenarioError(std::move(problems));
}

}  // namespace surefoot::scenario
