#pragma once

#include <filesystem>
#include <string>

#include "tools/sweep/sweep.hpp"

namespace surefoot::sweep {

/// What a Slurm job array needs to know; all paths as every node of the cluster sees them.
struct SlurmJob {
  std::filesystem::path program;
  std::filesystem::path sweep_file;
  std::filesystem::path folder;  ///< of the results; the parts come into parts/ in it
};

/// A job array for sbatch that runs the rows of a sweep, and the command that merges them. A task that is killed
/// or requeued goes on with the first row that its part lacks.
[[nodiscard]] std::string slurm_script(const Sweep& sweep, const SlurmJob& job);

}  // namespace surefoot::sweep
