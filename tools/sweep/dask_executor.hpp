#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "tools/batch/batch.hpp"

namespace surefoot::sweep {

/// Where the rows of a sweep run on a Dask cluster; paths as every worker sees them.
struct DaskOptions {
  std::string scheduler;  ///< "tcp://127.0.0.1:8786"
  std::filesystem::path sweep_file;
  const std::atomic<bool>* stop = nullptr;
};

/// Hands ranges of rows to a Dask scheduler through `dask_rows.py`. Each is a call of this program on a worker
/// (`sweep-rows`) and gives the same lines however often it runs, so Dask repeats what a killed worker had begun.
///
/// The executor throws run::ProcessFailure when the cluster cannot be reached, has no worker, or gives up on a range,
/// and scenario::ScenarioError when a worker has another build of this program.
[[nodiscard]] batch::Executor dask_executor(DaskOptions options);

}  // namespace surefoot::sweep
