#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim_hw/bus/bus_budget.hpp"
#include "tools/cli/commands.hpp"
#include "tools/run/bus_log_load.hpp"
#include "tools/run/candump_log.hpp"
#include "tools/run/lockstep_run.hpp"
#include "tools/scenario/bus_traffic.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::cli {
namespace {

using Json = nlohmann::ordered_json;

struct BusArguments {
  std::string scenario_file;
  std::vector<std::string> overrides;
  std::string log;
  double bitrate_hz = 1e6;
  double data_bitrate_hz = 5e6;
  bool is_json = false;
};

double us(std::int64_t ns) { return static_cast<double>(ns) / 1000.0; }

/// A stream's places in budget and run are the same: both list the message set by identifier.
Json stream_json(const sim_hw::StreamBudget& entry, const run::StreamTiming& seen) {
  return {{"identifier", fmt::format("0x{:03X}", entry.stream.identifier)},
          {"name", entry.stream.name},
          {"bytes", entry.stream.length},
          {"worst_nominal_bits", entry.worst_bits.nominal},
          {"worst_data_bits", entry.worst_bits.data},
          {"transmission_us", us(entry.transmission_ns)},
          {"period_us", entry.period_ns > 0 ? Json(us(entry.period_ns)) : Json(nullptr)},
          {"worst_case_us", entry.worst_response_ns ? Json(us(*entry.worst_response_ns)) : Json(nullptr)},
          {"observed_us", seen.observed_us},
          {"frames", seen.frames}};
}

Json json_of(const sim_hw::BusBudget& budget, const run::Verdict& verdict) {
  Json buses = Json::array();
  for (std::size_t bus = 0; bus < budget.buses.size(); ++bus) {
    Json streams = Json::array();
    for (std::size_t i = 0; i < budget.buses[bus].streams.size(); ++i) {
      streams.push_back(stream_json(budget.buses[bus].streams[i], verdict.bus[bus].streams[i]));
    }
    buses.push_back({{"worst_load_percent", budget.buses[bus].worst_load_percent},
                     {"load_percent", verdict.bus[bus].load_percent},
                     {"identifiers", streams}});
  }
  const sim_hw::TickChain& chain = budget.chain;
  return {{"control_period_us", us(budget.period_ns)},
          {"tick_us",
           {{"sync_and_states", us(chain.sync_and_states_ns)},
            {"nodes", us(chain.node_ns)},
            {"compute", us(chain.compute_ns)},
            {"commands", us(chain.commands_ns)},
            {"heartbeat", us(chain.heartbeat_ns)},
            {"total", us(chain.total_ns())},
            {"spare", us(budget.spare_ns())}}},
          {"spare_emergencies", budget.spare_emergencies()},
          {"buses", buses}};
}

std::string stream_line(const sim_hw::StreamBudget& entry, const run::StreamTiming& seen) {
  const auto dash = [](bool has_value, double value) {
    return has_value ? fmt::format("{:.1f}", value) : std::string("-");
  };
  const bool has_period = entry.period_ns > 0;
  return fmt::format("  {:03X}  {:<21} {:>5} {:>4}+{:<3} {:>9.1f} {:>10} {:>10} {:>9}\n", entry.stream.identifier,
                     entry.stream.name, entry.stream.length, entry.worst_bits.nominal, entry.worst_bits.data,
                     us(entry.transmission_ns), dash(has_period, us(entry.period_ns)),
                     dash(entry.worst_response_ns.has_value(), us(entry.worst_response_ns.value_or(0))),
                     dash(seen.frames > 0, seen.observed_us));
}

std::string text_of(const sim_hw::BusBudget& budget, const run::Verdict& verdict) {
  std::string text;
  for (std::size_t bus = 0; bus < budget.buses.size(); ++bus) {
    const sim_hw::SingleBusBudget& single = budget.buses[bus];
    text += fmt::format("bus {} of {}: load {:.1f} % at worst, {:.1f} % in this run\n", bus + 1, budget.buses.size(),
                        single.worst_load_percent, verdict.bus[bus].load_percent);
    text += "                                     worst   on wire  period =  ready to end of frame (us)\n";
    text += "  id   name                  bytes     bits        us   deadline      worst  observed\n";
    for (std::size_t i = 0; i < single.streams.size(); ++i) {
      text += stream_line(single.streams[i], verdict.bus[bus].streams[i]);
    }
  }
  const sim_hw::TickChain& chain = budget.chain;
  text += fmt::format(
      "a tick at worst: SYNC and states {:.1f} + nodes {:.1f} + computing {:.1f} + commands {:.1f} + a heartbeat "
      "{:.1f}\n"
      "  = {:.1f} of {:.1f} us; {:.1f} us left, room for {} emergencies\n",
      us(chain.sync_and_states_ns), us(chain.node_ns), us(chain.compute_ns), us(chain.commands_ns),
      us(chain.heartbeat_ns), us(chain.total_ns()), us(budget.period_ns), us(budget.spare_ns()),
      budget.spare_emergencies());
  return text;
}

run::ExitCode show_budget(const BusArguments& arguments) {
  try {
    const scenario::Scenario scenario = arguments.scenario_file.empty()
                                            ? scenario::load_default(arguments.overrides)
                                            : scenario::load(arguments.scenario_file, arguments.overrides);
    const sim_hw::BusBudget budget = sim_hw::bus_budget(scenario.sim.bus, scenario.firmware.period_s, scenario::bus_traffic(scenario));
    const run::Verdict verdict = run::run_lockstep(scenario, run::RunOptions{});
    fmt::print("{}", arguments.is_json ? json_of(budget, verdict).dump(2) + "\n" : text_of(budget, verdict));
    return run::ExitCode::kVerdictHolds;
  } catch (const scenario::ScenarioError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  }
}

run::ExitCode show_log(const BusArguments& arguments) {
  sim_hw::BusConfig config;
  config.nominal_bit_rate_hz = arguments.bitrate_hz;
  config.data_bit_rate_hz = arguments.data_bitrate_hz;
  const sim_hw::BitTiming timing = sim_hw::bit_timing(config);
  try {
    Json interfaces = Json::object();
    for (const auto& [name, load] : run::bus_log_load(arguments.log)) {
      interfaces[name] = {{"classic_frames", load.classic_frames},    {"fd_frames", load.fd_frames},
                          {"nominal_bits", load.nominal_bits},        {"data_bits", load.data_bits},
                          {"busy_ns", load.busy_ns(timing)},          {"elapsed_ns", load.elapsed_ns()},
                          {"load_percent", load.load_percent(timing)}};
      if (arguments.is_json) continue;
      fmt::print(
          "  {:<8} {} classic and {} FD frames, {} nominal and {} data bits, {:.3f} ms busy of {:.3f}: {:.2f} %\n",
          name, load.classic_frames, load.fd_frames, load.nominal_bits, load.data_bits,
          static_cast<double>(load.busy_ns(timing)) * 1e-6, static_cast<double>(load.elapsed_ns()) * 1e-6,
          load.load_percent(timing));
    }
    if (arguments.is_json) fmt::print("{}\n", interfaces.dump(2));
    return run::ExitCode::kVerdictHolds;
  } catch (const run::CandumpLogError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  }
}

/// What is wrong with a bit rate, or nothing: the model counts whole nanoseconds a bit.
std::string refuse_bit_rate(const std::string& text) {
  double rate_hz = 0.0;
  const bool is_number = CLI::detail::lexical_cast(text, rate_hz);
  const double bit_ns = 1e9 / rate_hz;
  if (is_number && rate_hz >= 1e4 && rate_hz <= 8e6 && std::abs(bit_ns - std::round(bit_ns)) < 1e-6) return "";
  return fmt::format("is {}; expected 10000 to 8e6, 1e9 divided by a whole number", text);
}

}  // namespace

void add_bus(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<BusArguments>();
  CLI::App* command = app.add_subcommand(
      "bus", "Load and worst-case response times of the CAN bus, beside those of a run; or of a log.");
  CLI::Option* scenario =
      command->add_option("scenario", arguments->scenario_file, "Scenario file (default: main job)");
  scenario->type_name("FILE");
  CLI::Option* set =
      command->add_option("--set", arguments->overrides, "Override one key, e.g. bus.count=2; repeatable");
  set->type_name("KEY=VALUE")->allow_extra_args(false);
  CLI::Option* log = command->add_option("--log", arguments->log, "Weigh a candump -L log instead, classic and FD");
  log->type_name("FILE")->excludes(scenario)->excludes(set);
  command->add_option("--bitrate", arguments->bitrate_hz, "Nominal bit rate of the log's bus (default: 1e6)")
      ->type_name("HZ")
      ->check(refuse_bit_rate)
      ->needs(log);
  command->add_option("--dbitrate", arguments->data_bitrate_hz, "Its data bit rate (default: 5e6)")
      ->type_name("HZ")
      ->check(refuse_bit_rate)
      ->needs(log);
  command->add_flag("--json", arguments->is_json, "Print JSON instead of text");
  command->footer(
      "The scenario is run once, unrecorded, for the observed times: the largest from a frame being ready to its end.\n"
      "The worst case is that of a healthy tick, after Davis et al. 2007; emergencies: all of them in one tick.\n"
      "A log's load counts from its first frame to its last.\n"
      "Exit codes: 0, 64 usage, 65 bad scenario (also: its bus cannot carry the traffic) or bad log.\n"
      "Examples:\n"
      "  surefoot bus\n"
      "  surefoot bus --set bus.count=2 --set control_period_s=0.0005 --set bus.command_latency_s=0.0005\n"
      "  surefoot bus --log runs/demo/bus.log --json");
  command->callback(
      [arguments, &result] { result = arguments->log.empty() ? show_budget(*arguments) : show_log(*arguments); });
}

}  // namespace surefoot::cli
