#include "tools/run/open_recorder.hpp"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

#include "firmware/host/live_publisher.hpp"
#include "tools/run/run_folder.hpp"

namespace surefoot::run {

std::unique_ptr<host::RunRecorder> open_recorder(const scenario::Scenario& scenario,
                                                 const std::filesystem::path& folder, bool is_live) {
  if (folder.empty()) return nullptr;
  create_run_folder(folder);
  host::RecorderOptions files;
  files.bus_log = folder / "bus.log";
  files.telemetry_log = folder / "telemetry.lcmlog";
  files.power_up_before_zero_us = std::llround(scenario.sim.time_zero_s * 1e6);
  if (is_live) files.live_provider = host::LivePublisher::kLocalProvider;
  try {
    auto recorder = std::make_unique<host::RunRecorder>(files);
    write_whole_file(folder / "scenario.toml", scenario::to_toml(scenario));
    return recorder;
  } catch (const std::system_error& error) {
    throw RecordingFailure(
        fmt::format("{}\n  remedy: free disk space, or name a folder that you may write with --out", error.what()));
  } catch (const std::runtime_error& error) {  // live telemetry; it says what to do
    throw RecordingFailure(error.what());
  }
}

}  // namespace surefoot::run
