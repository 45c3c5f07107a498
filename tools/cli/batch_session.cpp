#include "tools/cli/batch_session.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "firmware/host/sha256.hpp"
#include "tools/batch/journal.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/picture.hpp"
#include "tools/floor/floor_table.hpp"
#include "tools/map/map_spec.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/table/grid.hpp"
#include "tools/table/reference.hpp"

namespace surefoot::cli {
namespace {

namespace fs = std::filesystem;

fs::path cache_folder() {
  for (const auto& [variable, below] : {std::pair{"XDG_CACHE_HOME", ""}, std::pair{"HOME", ".cache"}}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && fs::path(folder).is_absolute()) return fs::path(folder) / below / "surefoot";
  }
  return fs::temp_directory_path() / "surefoot";
}

/// Another batch, scenario file or program has another name.
fs::path journal_of(const std::string& name, const batch::Batch& batch) {
  std::string whole = batch::journal_header() + batch.scenario_file.string();
  std::ifstream scenario(batch.scenario_file, std::ios::binary);
  whole.append(std::istreambuf_iterator<char>(scenario), {});
  const auto add = [&](const std::vector<std::string>& overrides) {
    for (const std::string& text : overrides) whole += '\n' + text;
    whole += '\0';
  };
  add(batch.common);
  for (const batch::Trial& trial : batch.trials) add(trial.overrides);
  host::Sha256 digest;
  digest.update(whole.data(), whole.size());
  return cache_folder() / fmt::format("{}-{}.journal", name, digest.hex().substr(0, 16));
}

}  // namespace

void add_batch_options(CLI::App& command, BatchArguments& arguments) {
  command
      .add_option("--scenario", arguments.scenario_file, "Scenario that the runs start from (default: the main job)")
      ->type_name("FILE");
  command.add_option("--set", arguments.overrides, "Override one key in every run; repeatable")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--plant", arguments.plant, "thesis or nominal (default: that of the scenario)");
  command.add_option("--jobs", arguments.jobs, "Runs at a time (default: one for each core)")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--fresh", arguments.is_fresh, "Forget what an interrupted call of the same command has finished");
  CLI::Option* csv = command.add_flag("--csv", arguments.is_csv, "Print comma-separated values");
  command.add_flag("--json", arguments.is_json, "Print JSON")->excludes(csv);
  command.add_option("--png", arguments.png, "Draw a picture too")
      ->type_name("FILE")
      ->check([](const std::string& name) {
        return name.ends_with(".png") ? std::string() : fmt::format("{} does not end in .png", name);
      });
}

BatchSession::BatchSession(std::string name, const BatchArguments& arguments)
    : name_(std::move(name)), arguments_(arguments) {
  if (!arguments.png.empty()) check_picture(arguments.png);
}

std::vector<run::Verdict> BatchSession::run(const batch::Batch& batch) {
  journal_ = journal_of(name_, batch);
  std::error_code ignored;  // the journal says what is wrong when it is opened
  fs::create_directories(journal_.parent_path(), ignored);
  if (arguments_.is_fresh) fs::remove(journal_, ignored);

  batch::BatchOptions options;
  options.jobs = arguments_.jobs;
  options.journal = journal_;
  options.stop = &stop_requested();
  const bool is_interactive = isatty(STDERR_FILENO) == 1;
  if (is_interactive) {
    options.on_progress = [](const batch::Progress& progress) {
      fmt::print(stderr, "\r{} of {} runs, ETA {:.0f} s\033[K", progress.done, progress.all, progress.remaining_wall_s);
    };
  }
  hear_stop_signals();
  std::vector<run::Verdict> verdicts = batch::run_batch(batch, options);
  if (is_interactive) fmt::print(stderr, "\r\033[K");
  return verdicts;
}

void BatchSession::forget() noexcept {
  std::error_code ignored;
  fs::remove(journal_, ignored);
}

void deliver(const Output& output, const BatchArguments& arguments) {
  fmt::print("{}", arguments.is_json ? output.json() : arguments.is_csv ? output.csv() : output.text());
  // What was worked out is forgotten next: it must have arrived.
  if (std::fflush(stdout) != 0) {
    throw run::RecordingFailure(
        "standard output: cannot be written\n  remedy: free disk space, or send the output elsewhere; the same command "
        "goes on from what is finished");
  }
  if (!arguments.png.empty()) draw_picture(output.json(), arguments.png);
}

run::ExitCode with_batch_messages(const std::string& name, const std::function<run::ExitCode()>& work) {
  const auto usage = [&](const char* message) {
    fmt::print(stderr, "surefoot {0}: {1}\n  remedy: see surefoot {0} --help\n", name, message);
    return run::ExitCode::kUsage;
  };
  try {
    return with_error_messages(work);
  } catch (const batch::Interrupted& interrupted) {
    fmt::print(stderr,
               "\rsurefoot {}: stopped after {} of {} runs\033[K\n  remedy: the same command goes on from there\n",
               name, interrupted.done, interrupted.all);
    return run::ExitCode::kInterrupted;
  } catch (const table::BadReference& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  } catch (const map::BadSpec& error) {
    fmt::print(stderr, "{}\n", error.what());
    return run::ExitCode::kBadInput;
  } catch (const table::BadList& error) {
    return usage(error.what());
  } catch (const floor::BadSeeds& error) {
    return usage(error.what());
  } catch (const UsageError& error) {
    return usage(error.what());
  }
}

}  // namespace surefoot::cli
