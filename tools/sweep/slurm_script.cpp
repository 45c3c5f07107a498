#include "tools/sweep/slurm_script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "tools/sweep/results.hpp"
#include "tools/sweep/row_ranges.hpp"

namespace surefoot::sweep {
namespace {

/// A name without what an #SBATCH line would take for its end.
std::string job_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-'; }, '_');
  return "surefoot-" + name;
}

}  // namespace

std::string slurm_script(const Sweep& sweep, const SlurmJob& job) {
  const std::size_t rows = sweep.values.size();
  const std::size_t size = rows_in_a_piece(rows);
  const std::string program = shell_word(job.program.string());
  const std::string file = shell_word(job.sweep_file.string());
  const std::string folder = shell_word(job.folder.string());
  return fmt::format(
      "#!/usr/bin/env bash\n"
      "# {rows} rows of a sweep as a Slurm job array: sbatch THIS_FILE\n"
      "# A task that was killed goes on where it was when it is submitted again.\n"
      "# When all have ended, on any node:\n"
      "#   {program} sweep {file} --out {folder} --merge {folder}/parts\n"
      "#SBATCH --job-name={name}\n"
      "#SBATCH --array=0-{last_task}\n"
      "#SBATCH --cpus-per-task=1\n"
      "#SBATCH --output=/dev/null\n"
      "#SBATCH --requeue\n"
      "set -euo pipefail\n"
      "folder={folder}\n"
      "first=$((SLURM_ARRAY_TASK_ID * {size}))\n"
      "last=$((first + {size} < {rows} ? first + {size} - 1 : {rows} - 1))\n"
      "mkdir -p \"$folder/parts\"\n"
      "exec {program} sweep-rows {file} --rows \"$first-$last\" --jobs \"${{SLURM_CPUS_PER_TASK:-1}}\" \\\n"
      "  --out \"$folder/parts/$SLURM_ARRAY_TASK_ID.jsonl\" 2> \"$folder/parts/$SLURM_ARRAY_TASK_ID.err\"\n",
      fmt::arg("rows", rows), fmt::arg("program", program), fmt::arg("file", file), fmt::arg("folder", folder),
      fmt::arg("name", job_name(sweep.name)), fmt::arg("last_task", (rows + size - 1) / size - 1),
      fmt::arg("size", size));
}

}  // namespace surefoot::sweep
