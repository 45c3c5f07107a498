#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "tools/plan/planned_gait.hpp"

namespace surefoot::plan {

inline constexpr double kSlowest_m_s = 0.001;
inline constexpr double kFastest_m_s = 5.0;

/// Speeds that cannot be read; the message says why.
class BadSpeeds : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "0.1:0.25:0.05" as 0.1, 0.15, 0.2, 0.25 m/s; downwards where the second is the smaller one.
/// @throws BadSpeeds  also for more than 100, and for speeds outside of `kSlowest_m_s` to `kFastest_m_s`
[[nodiscard]] std::vector<double> parse_speeds(const std::string& text);

/// A gait for each speed, all from one request.
[[nodiscard]] std::vector<PlanResult> library(const PlanRequest& request, const std::vector<double>& speeds_m_s,
                                              bool chooses_step);

}  // namespace surefoot::plan
