#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/batch/merge_parts.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/run/run_folder.hpp"
#include "tools/sweep/dask_executor.hpp"
#include "tools/sweep/results.hpp"
#include "tools/sweep/slurm_script.hpp"
#include "tools/sweep/sweep.hpp"

namespace surefoot::cli {
namespace {

struct SweepArguments {
  std::string file;
  std::string folder;
  std::string csv;
  std::string executor = "local";
  std::string scheduler;
  std::string parts;
  unsigned jobs = 0;
  bool is_json = false;
};

std::filesystem::path folder_of(const SweepArguments& arguments, const sweep::Sweep& sweep) {
  const std::filesystem::path folder = arguments.folder.empty() ? "runs/sweep-" + sweep.name : arguments.folder;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw run::RecordingFailure(fmt::format("{}: cannot be made: {}\n  remedy: name another folder with --out",
                                            folder.string(), error.message()));
  }
  return folder;
}

batch::BatchOptions options_of(const SweepArguments& arguments, const std::filesystem::path& folder) {
  batch::BatchOptions options;
  options.jobs = arguments.jobs;
  options.journal = folder / "journal.jsonl";
  options.stop = &stop_requested();
  if (arguments.executor == "dask") {
    options.executor = sweep::dask_executor({arguments.scheduler, arguments.file, options.stop});
  }
  if (!arguments.parts.empty()) {
    options.executor = [](const auto&, const auto&) { return false; };  // what the parts lack is not run here
  }
  if (isatty(STDERR_FILENO) == 1) {
    options.on_progress = [](const batch::Progress& progress) {
      const bool is_last = progress.done == progress.all;
      fmt::print(stderr, "\r{} of {} rows  ETA {:.0f} s\033[K{}", progress.done, progress.all,
                 progress.remaining_wall_s, is_last ? "\r\033[K" : "");
      std::fflush(stderr);
    };
  }
  return options;
}

run::ExitCode say_unfinished(const SweepArguments& arguments, const batch::Interrupted& interrupted) {
  if (isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\n");
  if (arguments.parts.empty()) {
    fmt::print(stderr,
               "surefoot sweep: stopped; {} of {} rows are kept\n  remedy: repeat the command, it goes on from there\n",
               interrupted.done, interrupted.all);
    return run::ExitCode::kInterrupted;
  }
  fmt::print(stderr,
             "{}: holds {} of {} rows\n  remedy: submit the job array again, it runs what is missing; or repeat the "
             "command without --merge\n",
             arguments.parts, interrupted.done, interrupted.all);
  return run::ExitCode::kBadInput;
}

void print_summary(const std::vector<run::Verdict>& verdicts, const std::string& csv) {
  std::string counts;
  for (const run::Outcome outcome :
       {run::Outcome::kWalked, run::Outcome::kFell, run::Outcome::kLimit, run::Outcome::kFault}) {
    const auto count =
        std::ranges::count_if(verdicts, [&](const run::Verdict& verdict) { return verdict.outcome == outcome; });
    if (count > 0) counts += fmt::format("{}{} {}", counts.empty() ? "" : ", ", count, run::name(outcome));
  }
  fmt::print("  rows         {}: {}\n  results      {}\n", verdicts.size(), counts, csv);
}

run::ExitCode print_slurm_script(const SweepArguments& arguments, const sweep::Sweep& sweep) {
  fmt::print("{}", sweep::slurm_script(sweep, {std::filesystem::read_symlink("/proc/self/exe"),
                                               std::filesystem::absolute(arguments.file),
                                               std::filesystem::absolute(folder_of(arguments, sweep))}));
  return run::ExitCode::kVerdictHolds;
}

run::ExitCode run_sweep(const SweepArguments& arguments, const sweep::Sweep& sweep) {
  if (arguments.executor == "slurm") return print_slurm_script(arguments, sweep);
  const std::filesystem::path folder = folder_of(arguments, sweep);
  const batch::BatchOptions options = options_of(arguments, folder);
  try {
    if (!arguments.parts.empty()) batch::merge_parts(sweep.batch, options.journal, arguments.parts);
    const std::vector<run::Verdict> verdicts = batch::run_batch(sweep.batch, options);
    const sweep::Results results = sweep::results_of(sweep, verdicts);
    const std::string csv = arguments.csv.empty() ? (folder / "results.csv").string() : arguments.csv;
    if (csv != "-") run::write_whole_file(csv, sweep::to_csv(results));
    if (arguments.is_json) {
      fmt::print("{}", sweep::to_json(results));
    } else if (csv == "-") {
      fmt::print("{}", sweep::to_csv(results));
    } else {
      print_summary(verdicts, csv);
    }
    return run::ExitCode::kVerdictHolds;
  } catch (const batch::Interrupted& interrupted) {
    return say_unfinished(arguments, interrupted);
  }
}

run::ExitCode sweep_with_messages(const SweepArguments& arguments) {
  hear_stop_signals();
  return with_error_messages([&] {
    const sweep::Sweep sweep = sweep::load(arguments.file);
    try {
      return run_sweep(arguments, sweep);
    } catch (const scenario::ScenarioError& error) {
      throw sweep::with_places(sweep, error);
    }
  });
}

constexpr const char* kFooter =
    "A sweep file (examples: tools/sweeps):\n"
    "  scenario = \"../scenarios/main.toml\"     # from this file on; without it the main job\n"
    "  draws = 100                             # of [random]; draw_seed = 1 begins another series\n"
    "  [set]                                   # for every row\n"
    "  limits.ends_when_recovered = true\n"
    "  [grid]                                  # every combination\n"
    "  payload.0.mass_kg = [5, 10, 15]\n"
    "  [list]                                  # row by row: the first of each, the second of each, ..\n"
    "  [random]                                # draw k is the same however many there are\n"
    "  floor.friction = {min = 0.1, max = 0.7}\n"
    "Rows: each draw with each combination with each row of the list. Columns: what is varied, how it went, and last\n"
    "the command that repeats the row. The folder keeps every row that has ended: a sweep that was interrupted goes\n"
    "on when the command is repeated. Same rows to the last bit on any number of threads, Dask workers or Slurm tasks\n"
    "(these need sweep, scenario and this program under the same path).\n"
    "Parquet: python -c 'import pandas; pandas.read_csv(\"results.csv\").to_parquet(\"results.parquet\")'\n"
    "Exit codes: 0 all rows have run, whatever came of them, 64 usage, 65 bad sweep or scenario, or a folder with\n"
    "rows of another one or of another build, 69 disk or cluster, 130 interrupted.\n"
    "Examples:\n"
    "  surefoot sweep tools/sweeps/friction_and_toe.toml --csv -\n"
    "  surefoot sweep tools/sweeps/off_the_grid.toml --out runs/off_the_grid --json\n"
    "  surefoot sweep tools/sweeps/off_the_grid.toml --executor dask --scheduler tcp://127.0.0.1:8786\n"
    "  surefoot sweep tools/sweeps/off_the_grid.toml --executor slurm > job.sh && sbatch job.sh";

}  // namespace

void add_sweep(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<SweepArguments>();
  CLI::App* command =
      app.add_subcommand("sweep", "Run a scenario over grids, lists and random draws of its parameters; a row a run.");
  command->add_option("sweep", arguments->file, "Sweep file")->type_name("FILE")->required();
  command->add_option("--out", arguments->folder, "Folder of rows and results (default: runs/sweep-<name>)")
      ->type_name("DIR");
  command->add_option("--jobs", arguments->jobs, "Threads; default: one for each core")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_option("--csv", arguments->csv, "Write the results here, - for standard output (default: results.csv)")
      ->type_name("FILE");
  command->add_flag("--json", arguments->is_json, "Print the results as a JSON array");
  command
      ->add_option("--executor", arguments->executor,
                   "local (default), dask, or slurm: print a job array for sbatch instead of running")
      ->check(CLI::IsMember({"local", "dask", "slurm"}));
  command->add_option("--scheduler", arguments->scheduler, "With --executor dask: the scheduler")->type_name("ADDRESS");
  command->add_option("--merge", arguments->parts, "Take the rows that a job array left in this folder")
      ->type_name("DIR");
  command->footer(kFooter);
  command->callback([arguments, &result] {
    if ((arguments->executor == "dask") == arguments->scheduler.empty()) {
      throw CLI::ValidationError("--executor dask and --scheduler ADDRESS belong together");
    }
    if (arguments->is_json && arguments->csv == "-") {
      throw CLI::ValidationError("--json and --csv - both want standard output");
    }
    result = sweep_with_messages(*arguments);
  });
}

}  // namespace surefoot::cli
