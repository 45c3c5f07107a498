#include "tools/doctor/examine.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "firmware/host/realtime/realtime_rights.hpp"
#include "tools/doctor/bus_checks.hpp"
#include "tools/doctor/machine.hpp"
#include "tools/doctor/multicast_checks.hpp"
#include "tools/doctor/outcome.hpp"
#include "tools/doctor/realtime_checks.hpp"
#include "tools/doctor/self_tests.hpp"
#include "tools/doctor/tool_checks.hpp"

namespace surefoot::doctor {
namespace {

namespace fs = std::filesystem;
using Tree = std::optional<fs::path>;

void examine_run_space(Checks& checks) {
  std::error_code unreadable;
  const fs::path here = fs::current_path(unreadable);
  const fs::path folder = fs::is_directory(here / "runs", unreadable) ? here / "runs" : here;
  const std::uint64_t free_bytes = fs::space(folder, unreadable).available;
  const bool is_writable = access(folder.c_str(), W_OK | X_OK) == 0;
  checks.push_back({"run folders", Purpose::kLockstepRun,
                    judge_run_space({folder.string(), is_writable, unreadable ? 0 : free_bytes})});
}

/// Makes a vcan in a network that goes with the process.
Outcome try_vcan() {
  std::vector<std::string> command{"unshare", "-n", "ip", "link", "add", "type", "vcan"};
  if (geteuid() != 0) command.insert(command.begin() + 1, "-r");
  return run_program(command);
}

std::optional<std::string> time_travel_program(const Tree& tree) {
  if (!tree) return std::nullopt;
  Outcome printed = run_program({(*tree / "tools" / "build-uml").string(), "--print-path"});
  return printed.is_success() ? std::optional(std::move(printed.output)) : std::nullopt;
}

void examine_two_programs(Checks& checks, const Tree& tree) {
  std::vector<std::string> absent;
  for (const char* program : {"candump", "cansend", "canplayer", "canbusload"}) {
    if (!has_program(program)) absent.emplace_back(program);
  }
  const fs::path modules = fs::path("/lib/modules") / running_kernel().release;
  const Finding vcan = judge_vcan(can_interfaces(), try_vcan(), has_kernel_module(modules, "vcan"));
  const Finding user_mode_linux =
      judge_user_mode_linux({.has_program = has_program("linux.uml"),
                             .has_vcan_module = has_kernel_module("/usr/lib/uml/modules", "vcan"),
                             .has_insmod = has_program("insmod")});
  const bool has_script = tree && access((*tree / "tools" / "with-vcan").c_str(), X_OK) == 0;
  const auto add = [&](const char* name, Finding finding) {
    checks.push_back({name, Purpose::kTwoPrograms, std::move(finding)});
  };
  add("CAN sockets", judge_can_sockets(try_can_socket(), has_kernel_module(modules, "can-raw")));
  add("vcan", vcan);
  add("User Mode Linux", user_mode_linux);
  add("UML with virtual time", judge_time_travel(time_travel_program(tree)));
  add("tools/with-vcan", judge_with_vcan(has_script, vcan, user_mode_linux));
  add("can-utils", judge_can_utils(absent));
}

void examine_telemetry(Checks& checks) {
  constexpr std::uint32_t kLcmGroup = 0xEFFF4C43;  // 239.255.76.67, LCM's default
  const auto add = [&](const char* name, Finding finding) {
    checks.push_back({name, Purpose::kTelemetry, std::move(finding)});
  };
  add("multicast route",
      judge_multicast_route(interface_towards(text_of("/proc/net/route"), kLcmGroup), carries_multicast("lo")));
  add("LCM self test", judge_lcm(test_lcm()));
  add("UDP bus self test", judge_udp_bus(test_udp_bus()));
}

/// Asks for what the loop asks for, in a thread that ends.
host::MissingRights try_rights() {
  host::MissingRights missing_rights;
  std::thread([&] { missing_rights = host::RealtimeRights(host::RealtimeRequest{}).missing(); }).join();
  munlockall();
  return missing_rights;
}

void examine_wall_clock(Checks& checks) {
  const host::MissingRights rights = try_rights();
  const fs::path kernel = "/proc/sys/kernel";
  const fs::path clock = "/sys/devices/system/clocksource/clocksource0";
  const auto add = [&](const char* name, Finding finding) {
    checks.push_back({name, Purpose::kWallClock, std::move(finding)});
  };
  add("SCHED_FIFO, rtprio", judge_right(rights, "SCHED_FIFO", "priority 80 is granted"));
  add("memlock", judge_right(rights, "all memory locked", "all memory can be locked"));
  add("idle states", judge_right(rights, "idle states", "can be kept shallow"));
  add("real-time throttling",
      judge_throttling(text_of(kernel / "sched_rt_runtime_us"), text_of(kernel / "sched_rt_period_us")));
  add("kernel pre-emption",
      judge_preemption(running_kernel().version, text_of("/sys/kernel/debug/sched/preempt"), text_of("/proc/cmdline")));
  add("governor", judge_governor(governors()));
  add("isolated processors",
      judge_isolation(text_of("/sys/devices/system/cpu/isolated"), std::thread::hardware_concurrency()));
  add("clock source",
      judge_clock_source(text_of(clock / "current_clocksource"), text_of(clock / "available_clocksource")));
  add("timers", judge_timers(timer_resolution_ns()));
  add("hardware", judge_hardware(text_of("/proc/cpuinfo")));
}

void examine_pictures(Checks& checks, const Tree& tree) {
  constexpr const char* kFindModules =
      "import importlib.util as u; print(*[m for m in ('can', 'cantools', 'lcm', 'matplotlib', 'numpy', 'pytest') "
      "if u.find_spec(m) is None], sep=', ')";
  const std::string python = tree ? (*tree / ".venv" / "bin" / "python").string() : ".venv/bin/python";
  std::vector<std::string> absent_jars;
  for (const char* jar : {"/usr/share/java/lcm.jar", "/usr/share/java/jchart2d.jar"}) {
    if (access(jar, R_OK) != 0) absent_jars.emplace_back(jar);
  }
  const Finding java = judge_java(run_program({"java", "-version"}));
  const auto add = [&](const char* name, Finding finding) {
    checks.push_back({name, Purpose::kPictures, std::move(finding)});
  };
  add("Python environment", judge_python(run_program({python, "-c", kFindModules})));
  add("Java", java);
  add("lcm-spy", judge_lcm_spy(absent_jars, java));
}

}  // namespace

Checks examine_machine() {
  Checks checks;
  const Tree tree = find_tree();
  examine_run_space(checks);
  examine_two_programs(checks, tree);
  examine_telemetry(checks);
  examine_wall_clock(checks);
  examine_pictures(checks, tree);
  return checks;
}

}  // namespace surefoot::doctor
