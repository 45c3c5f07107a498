#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "tools/batch/finished_trials.hpp"
#include "tools/batch/journal.hpp"
#include "tools/batch/load_trial.hpp"
#include "tools/batch/local_executor.hpp"
#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/sweep/row_ranges.hpp"
#include "tools/sweep/sweep.hpp"

namespace surefoot::cli {
namespace {

struct SweepRowsArguments {
  std::string file;
  std::string rows;
  std::string part;
  unsigned jobs = 1;
};

std::vector<std::size_t> rows_of(const SweepRowsArguments& arguments, const sweep::Sweep& sweep) {
  const std::size_t count = sweep.values.size();
  const std::optional<sweep::RowRange> range = sweep::range_of(arguments.rows);
  if (!range || range->last >= count) {
    throw scenario::ScenarioError(
        {{"--rows " + arguments.rows, fmt::format("is no range of rows; {} has rows 0-{}", arguments.file, count - 1),
          "write first and last row, as in --rows 0-7"}});
  }
  std::vector<std::size_t> rows = batch::all_trials(range->last - range->first + 1);
  for (std::size_t& row : rows) row += range->first;
  return rows;
}

/// To the part, or to standard output; the first line is the header of a journal.
run::ExitCode run_rows(const SweepRowsArguments& arguments, const sweep::Sweep& sweep) {
  batch::FinishedTrials finished(batch::check_trials(sweep.batch, rows_of(arguments, sweep), arguments.jobs));
  std::optional<batch::Journal> part;
  if (arguments.part.empty()) {
    fmt::print("{}\n", batch::journal_header());
  } else {
    part.emplace(arguments.part, finished);
  }
  std::mutex mutex;
  const bool is_complete = batch::run_locally(sweep.batch, finished.hashes(), finished.missing(),
                                              {arguments.jobs, &stop_requested()}, [&](const std::string& line) {
                                                const std::scoped_lock lock(mutex);
                                                if (part) {
                                                  part->append(line);
                                                } else {
                                                  fmt::print("{}\n", line);
                                                  std::fflush(stdout);
                                                }
                                              });
  return is_complete ? run::ExitCode::kVerdictHolds : run::ExitCode::kInterrupted;
}

}  // namespace

void add_sweep_rows(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<SweepRowsArguments>();
  CLI::App* command = app.add_subcommand("sweep-rows", "Run some rows of a sweep: what a worker of a cluster calls.");
  command->add_option("sweep", arguments->file, "Sweep file")->type_name("FILE")->required();
  command->add_option("--rows", arguments->rows, "First and last row, from 0")->type_name("A-B")->required();
  command->add_option("--out", arguments->part, "Part to write or to go on with (default: standard output)")
      ->type_name("FILE");
  command->add_option("--jobs", arguments->jobs, "Threads; default 1")->type_name("N")->check(CLI::Range(1, 1024));
  command->footer(
      "Writes a line of JSON a row, with all digits; surefoot sweep --merge turns parts into results.\n"
      "Exit codes: 0 all rows have run, 64 usage, 65 bad sweep, 69 disk, 130 interrupted; the part keeps its rows.\n"
      "Example:\n"
      "  surefoot sweep-rows tools/sweeps/friction_and_toe.toml --rows 0-7 --out parts/0.jsonl");
  command->callback([arguments, &result] {
    hear_stop_signals();
    result = with_error_messages([&] {
      const sweep::Sweep sweep = sweep::load(arguments->file);
      try {
        return run_rows(*arguments, sweep);
      } catch (const scenario::ScenarioError& error) {
        throw sweep::with_places(sweep, error);
      }
    });
  });
}

}  // namespace surefoot::cli
