#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <vector>

#include "firmware/host/spsc_ring.hpp"

namespace surefoot::host {
namespace {

// Any interleaving of pushes and takes, against a plain queue that does the same by definition.
RC_GTEST_PROP(SpscRing, BehavesAsABoundedQueueThatCountsWhatItRefuses, ()) {
  const std::size_t capacity = std::size_t{1} << *rc::gen::inRange(0, 6);
  // Positive: push that many; else: take at most that many.
  const auto steps = *rc::gen::container<std::vector<int>>(rc::gen::inRange(-40, 41));
  SpscRing<int> ring(capacity);
  std::deque<int> model;
  std::uint64_t refused = 0;
  int next = 0;
  for (const int step : steps) {
    for (int i = 0; i < step; ++i) {
      const bool fits = model.size() < capacity;
      if (fits) model.push_back(next);
      refused += fits ? 0 : 1;
      RC_ASSERT(ring.produce([&](int& slot) { slot = next; }) == fits);
      ++next;
    }
    if (step <= 0) {
      const auto limit = static_cast<std::size_t>(-step);
      const std::size_t expected = std::min(limit, model.size());
      const std::size_t taken = ring.consume(
          [&](int slot) {
            RC_ASSERT(slot == model.front());
            model.pop_front();
          },
          limit);
      RC_ASSERT(taken == expected);
    }
    RC_ASSERT(ring.room() == capacity - model.size());
    RC_ASSERT(ring.drops() == refused);
  }
}

}  // namespace
}  // namespace surefoot::host
