#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace surefoot::batch {

/// How a loop over many pieces of work is spread over threads.
struct ParallelOptions {
  unsigned jobs = 0;                        ///< threads; 0: one for each core
  const std::atomic<bool>* stop = nullptr;  ///< set from outside: begun pieces end, no further one begins
};

/// Calls `work(0)` to `work(count - 1)`, begun in this order, each once, from several threads.
///
/// When a piece throws no further one begins; of several exceptions that with the smallest index is passed
/// on, which is the same one whatever the number of threads.
///
/// @return false when it was stopped before the last piece began
bool parallel_for(std::size_t count, const ParallelOptions& options, const std::function<void(std::size_t)>& work);

}  // namespace surefoot::batch
