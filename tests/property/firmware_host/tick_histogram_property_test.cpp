#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/host/tick_histogram.hpp"

namespace surefoot::host {
namespace {

/// Durations of all sizes: as many around 100 ns as around 10 s.
rc::Gen<std::int64_t> duration_ns() {
  return rc::gen::mapcat(rc::gen::inRange(1, 36), [](int bits) {
    return rc::gen::inRange<std::int64_t>(std::int64_t{1} << (bits - 1), std::int64_t{1} << bits);
  });
}

RC_GTEST_PROP(TickHistogram, PercentilesAreTheSortedDatasOwnUpToOnePartIn128, ()) {
  auto durations_ns = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::int64_t>>(duration_ns()));
  TickHistogram histogram;
  for (const std::int64_t duration : durations_ns) histogram.add(duration);
  std::sort(durations_ns.begin(), durations_ns.end());
  for (const double fraction : {0.0, 0.01, 0.5, 0.9, 0.999, 1.0}) {
    const double rank = std::max(1.0, std::ceil(fraction * static_cast<double>(durations_ns.size())));
    const double exact_us = 1.0e-3 * static_cast<double>(durations_ns[static_cast<std::size_t>(rank) - 1]);
    const double percentile_us = histogram.percentile_us(fraction);
    RC_ASSERT(percentile_us >= exact_us * (1.0 - 1.0e-12));
    RC_ASSERT(percentile_us <= exact_us * (1.0 + 1.0 / 128.0));
  }
  RC_ASSERT(histogram.max_us() == 1.0e-3 * static_cast<double>(durations_ns.back()));
  RC_ASSERT(histogram.count() == durations_ns.size());
}

}  // namespace
}  // namespace surefoot::host
