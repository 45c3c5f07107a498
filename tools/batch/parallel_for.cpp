#include "tools/batch/parallel_for.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace surefoot::batch {

bool parallel_for(std::size_t count, const ParallelOptions& options, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> ends_early{false};
  std::mutex mutex;
  std::exception_ptr failure;
  std::size_t failed = count;
  const auto take_work = [&] {
    while (!ends_early && !(options.stop != nullptr && options.stop->load())) {
      const std::size_t index = next++;
      if (index >= count) return;
      try {
        work(index);
      } catch (...) {
        ends_early = true;
        const std::scoped_lock lock(mutex);
        if (index < failed) {
          failed = index;
          failure = std::current_exception();
        }
      }
    }
  };
  const std::size_t jobs = options.jobs != 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < std::min(jobs, count); ++i) threads.emplace_back(take_work);
  }
  if (failure) std::rethrow_exception(failure);
  return next >= count;
}

}  // namespace surefoot::batch
