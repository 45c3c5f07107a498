#include "tools/sweep/dask_executor.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "tools/batch/journal.hpp"
#include "tools/run/child_process.hpp"
#include "tools/run/exit_code.hpp"
#include "tools/sweep/line_pipe.hpp"
#include "tools/sweep/row_ranges.hpp"

namespace surefoot::sweep {
namespace {

bool run_on_dask(const DaskOptions& options, const std::vector<std::size_t>& missing,
                 const std::function<void(const std::string&)>& take) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  std::vector<std::string> command{SUREFOOT_SOURCE_DIR "/.venv/bin/python",
                                   SUREFOOT_SOURCE_DIR "/tools/sweep/dask_rows.py", options.scheduler, program.string(),
                                   std::filesystem::absolute(options.sweep_file).string()};
  for (const RowRange& range : ranges_of(missing, rows_in_a_piece(missing.size()))) {
    command.push_back(to_text(range));
  }
  LinePipe lines(command);
  while (const std::optional<std::string> line = lines.next(options.stop)) {
    if (line->starts_with(R"({"journal")")) {
      batch::check_journal_header("a worker's program", *line);
    } else {
      take(*line);
    }
  }
  if (options.stop != nullptr && options.stop->load()) return false;
  if (lines.exit_code() == 0) return true;
  throw run::ProcessFailure(
      "surefoot sweep: the cluster did not run all rows; those that have ended are kept\n"
      "  remedy: mend what Dask says above, then repeat the command",
      static_cast<int>(run::ExitCode::kMachineLacks));
}

}  // namespace

batch::Executor dask_executor(DaskOptions options) {
  return [options = std::move(options)](const std::vector<std::size_t>& missing,
                                        const std::function<void(const std::string&)>& take) {
    return run_on_dask(options, missing, take);
  };
}

}  // namespace surefoot::sweep
