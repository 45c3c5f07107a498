#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "tools/run/verdict.hpp"

namespace surefoot::floor {

/// Largest magnitude of an angle in each run, over the runs that did not fall.
struct Amplitude {
  double mean_deg = 0.0;
  double worst_deg = 0.0;
};

/// What several runs came to. A latched fault counts as a fall.
struct Summary {
  std::size_t runs = 0;
  std::size_t falls = 0;
  Amplitude roll;  ///< of the torso against the vertical; 0 when all fell
  Amplitude pitch;
  double shortest_way_m = 0.0;  ///< of the runs that did not fall

  [[nodiscard]] bool all_fell() const noexcept { return falls == runs; }
};

[[nodiscard]] Summary summary_of(std::span<const run::Verdict> verdicts);

/// "1.23 (2.34)": mean and worst, "-" when all fell.
[[nodiscard]] std::string text_of(const Summary& summary, const Amplitude& amplitude);

/// runs, falls, and both angles; null when all fell.
[[nodiscard]] nlohmann::ordered_json json_of(const Summary& summary);

/// "falls,runs,roll_mean_deg,roll_worst_deg,pitch_mean_deg,pitch_worst_deg,shortest_way_m", and such a row; the angles
/// are empty when all fell.
[[nodiscard]] const char* csv_header() noexcept;
[[nodiscard]] std::string csv_of(const Summary& summary);

}  // namespace surefoot::floor
