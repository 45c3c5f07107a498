#include "tools/run/two_process_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>
#include <thread>

#include "firmware/can/messages.hpp"
#include "firmware/host/sha256.hpp"
#include "tools/run/bus_watch.hpp"
#include "tools/run/candump_log.hpp"
#include "tools/run/child_process.hpp"
#include "tools/run/histogram_json.hpp"
#include "tools/run/log_judge.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/run/schedule.hpp"

namespace surefoot::run {
namespace {

using WallClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPoll{20};
constexpr std::chrono::seconds kPatienceAtEnd{10};

/// Starts one half and keeps an eye on it.
std::vector<std::string> command_line(const TwoProcessOptions& options, const char* command, int fifo_priority) {
  std::vector<std::string> line{options.program.string(),
                                command,
                                (options.folder / "scenario.toml").string(),
                                "--bus",
                                options.bus,
                                "--clock",
                                options.is_wall_clock ? "wall" : "lockstep",
                                "--once",
                                "--overwrite",
                                "--out",
                                (options.folder / (command == std::string("sim") ? "robot" : "firmware")).string()};
  if (fifo_priority > 0) {
    line.emplace_back("--priority");
    line.push_back(std::to_string(fifo_priority));
  }
  return line;
}

/// Waits until the firmware has ended, or the robot has: then the firmware is asked to end too.
/// @return true when it was `stop` that ended the run
bool wait_for_end(ChildProcess& firmware, ChildProcess& robot, const TwoProcessOptions& options) {
  const WallClock::time_point start = WallClock::now();
  bool was_stopped = false;
  bool was_asked = false;
  WallClock::time_point asked = start;
  int polls = 0;
  while (!firmware.exit_code() || !robot.exit_code()) {
    std::this_thread::sleep_for(kPoll);
    const bool is_stopped = options.stop != nullptr && options.stop->load(std::memory_order_relaxed);
    if (!was_asked && (is_stopped || firmware.exit_code() || robot.exit_code())) {
      was_asked = true;
      was_stopped = is_stopped;
      asked = WallClock::now();
      firmware.ask_to_end();
      robot.ask_to_end();
    }
    if (was_asked && WallClock::now() - asked > kPatienceAtEnd) {
      throw ProcessFailure("firmware or robot do not end within 10 s of being asked to\n  remedy: report it as a bug",
                           static_cast<int>(ExitCode::kBug));
    }
    if (options.on_progress && ++polls % 12 == 0) {
      options.on_progress(std::chrono::duration<double>(WallClock::now() - start).count());
    }
  }
  return was_stopped;
}

/// A child that failed before it could do its work has said why; its exit code becomes ours.
void require_success(const char* name, int exit_code) {
  const bool did_its_work =
      exit_code == static_cast<int>(ExitCode::kVerdictHolds) || exit_code == static_cast<int>(ExitCode::kFault);
  if (did_its_work) return;
  throw ProcessFailure(fmt::format("surefoot {} ended with exit code {}; see its message above", name, exit_code),
                       exit_code > 128 ? static_cast<int>(ExitCode::kBug) : exit_code);
}

nlohmann::json read_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  return nlohmann::json::parse(file);
}

void fill_in_counters(const TwoProcessOptions& options, Verdict& verdict) {
  const nlohmann::json firmware = read_json(options.folder / "firmware" / "firmware.json");
  const nlohmann::json robot = read_json(options.folder / "robot" / "robot.json");
  verdict.allocations_were_counted = !firmware["allocations_in_loop"].is_null();
  if (verdict.allocations_were_counted) verdict.allocations_in_loop = firmware["allocations_in_loop"];
  verdict.tick_us_mean = firmware["tick_us"]["mean"];
  verdict.tick_us_p50 = firmware["tick_us"]["p50"];
  verdict.tick_us_p999 = firmware["tick_us"]["p999"];
  verdict.tick_us_max = firmware["tick_us"]["max"];
  verdict.tick_bins = bins_of(firmware["tick_us"]["histogram"]);
  verdict.real_time_factor = firmware["real_time_factor"];
  verdict.frames_sent = std::uint64_t{firmware["frames"]["sent"]} + std::uint64_t{robot["frames_sent"]};
  std::uint64_t rejected = 0;
  for (const nlohmann::json& count : firmware["frames"]["rejected"]) rejected += std::uint64_t{count};
  verdict.frames_lost = std::uint64_t{firmware["frames"]["lost"]} +
                        std::uint64_t{firmware["frames"]["refused_by_bus"]} + rejected +
                        std::uint64_t{robot["frames_lost"]} + std::uint64_t{robot["frames_refused_by_bus"]} +
                        std::uint64_t{robot["frames_rejected"]};
  verdict.frames_late = std::uint64_t{firmware["frames"]["rejected"][static_cast<std::size_t>(can::Rejection::kLate)]} +
                        std::uint64_t{robot["frames_rejected_late"]};
}

/// Weighs what crossed the bus from the first SYNC on, as a run in one process does beside the loop.
void weigh_bus(const scenario::Scenario& scenario, const std::filesystem::path& bus_log, Verdict& verdict) {
  BusWatch watch(scenario, nullptr);
  CandumpLogReader log(bus_log);
  std::int64_t ticks = 0;
  while (const std::optional<LoggedFrame> logged = log.next()) {
    if (logged->frame.identifier == can::kSyncIdentifier) ++ticks;
    if (ticks > 0) watch.on_frame(logged->frame);
  }
  verdict.bus = watch.finish(ticks);
  verdict.bus_load_percent = watch.load_percent(ticks);
}

std::string sha256_of_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  host::Sha256 hash;
  std::vector<char> block(1 << 16);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0) {
    hash.update(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  return hash.hex();
}

void gather_logs(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::rename(folder / "firmware" / "bus.log", folder / "bus.log", error);
  if (error) throw RecordingFailure(fmt::format("{}: {}", (folder / "bus.log").string(), error.message()));
  merge_telemetry_logs({folder / "robot" / "telemetry.lcmlog", folder / "firmware" / "telemetry.lcmlog"},
                       folder / "telemetry.lcmlog");
}

}  // namespace

Verdict run_two_processes(scenario::Scenario scenario, const TwoProcessOptions& options) {
  scenario = scheduled(std::move(scenario));
  scenario.telemetry.every_ticks = 1;  // the verdict looks at every tick
  create_run_folder(options.folder);
  write_whole_file(options.folder / "scenario.toml", scenario::to_toml(scenario));

  bool was_stopped = false;
  {
    ChildProcess robot(
        command_line(options, "sim", options.fifo_priority > 0 ? std::min(options.fifo_priority + 1, 99) : 0));
    ChildProcess firmware(command_line(options, "firmware", options.fifo_priority));
    was_stopped = wait_for_end(firmware, robot, options);
    require_success("sim", *robot.exit_code());
    require_success("firmware", *firmware.exit_code());
  }
  gather_logs(options.folder);
  Verdict verdict = judge_logs(scenario, read_telemetry_log(options.folder / "firmware" / "telemetry.lcmlog"),
                               read_telemetry_log(options.folder / "robot" / "telemetry.lcmlog"), was_stopped);
  fill_in_counters(options, verdict);
  weigh_bus(scenario, options.folder / "bus.log", verdict);
  verdict.bus_log_sha256 = sha256_of_file(options.folder / "bus.log");
  write_whole_file(options.folder / "verdict.json", to_json(verdict));
  return verdict;
}

}  // namespace surefoot::run
