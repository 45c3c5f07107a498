#include "tools/plan/speeds.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>

namespace surefoot::plan {

std::vector<double> parse_speeds(const std::string& text) {
  constexpr double kMost = 100.0;
  std::array<double, 3> part{};
  const char* place = text.data();
  const char* const end = place + text.size();
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto [rest, error] = std::from_chars(place, end, part[i]);
    const bool is_last = i + 1 == part.size();
    if (error != std::errc{} || (is_last ? rest != end : rest == end || *rest != ':')) {
      throw BadSpeeds(fmt::format("--speeds is {}; expected three numbers", text));
    }
    place = rest + (is_last ? 0 : 1);
  }
  const auto [from, to, step] = part;
  for (const double speed_m_s : {from, to}) {
    if (!(speed_m_s >= kSlowest_m_s && speed_m_s <= kFastest_m_s)) {
      throw BadSpeeds(fmt::format("--speeds {}: {} is no speed; expected {} to {} m/s", text, speed_m_s, kSlowest_m_s,
                                  kFastest_m_s));
    }
  }
  const double steps = std::abs(to - from) / step;
  if (!(step > 0.0 && steps < kMost)) {
    throw BadSpeeds(
        fmt::format("--speeds {}: the step is {}; expected more than 0, and at most 100 speeds", text, step));
  }
  std::vector<double> speeds_m_s;
  const int count = static_cast<int>(std::floor(steps + 1e-9)) + 1;
  for (int i = 0; i < count; ++i) speeds_m_s.push_back(from + (to < from ? -i : i) * step);
  return speeds_m_s;
}

std::vector<PlanResult> library(const PlanRequest& request, const std::vector<double>& speeds_m_s, bool chooses_step) {
  std::vector<PlanResult> gaits;
  for (const double speed_m_s : speeds_m_s) {
    gaits.push_back(plan_gait(request, {.compensates = true, .speed_m_s = speed_m_s, .chooses_step = chooses_step}));
  }
  return gaits;
}

}  // namespace surefoot::plan
