#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace surefoot::bench {

/// What one part of the closed loop needs for a tick.
struct Stage {
  std::string name;
  double us = 0.0;
};

/// A table of 288 cells, each judged until the end: nobody falls.
struct GridEstimate {
  std::size_t cells = 288;
  double simulated_s = 0.0;  ///< all cells, and the walk that they share
  unsigned cores = 1;
  double wall_s = 0.0;
};

/// How fast the closed loop is on one core, and where its time goes. The robot walks without a load.
struct Report {
  double period_s = 0.0;
  double physics_step_s = 0.0;
  double tick_us = 0.0;         ///< closed loop on the bus in memory, unrecorded, judged
  double bare_bullet_us = 0.0;  ///< `btMultiBody` alone, the steps of one tick, the same model
  std::vector<Stage> stages;    ///< add up to `tick_us`; the last one is what no other has
  GridEstimate grid;

  [[nodiscard]] double ticks_per_s() const noexcept { return 1.0e6 / tick_us; }
  [[nodiscard]] double real_time_factor() const noexcept { return 1.0e6 * period_s / tick_us; }
};

/// Measures for about so long, in processor time of the calling thread; every figure is the best of several rounds.
/// Stages are measured one at a time, so that what they share (caches) counts a little differently than in the loop.
[[nodiscard]] Report measure(double seconds);

[[nodiscard]] std::string to_text(const Report& report);
[[nodiscard]] std::string to_json(const Report& report);

}  // namespace surefoot::bench
