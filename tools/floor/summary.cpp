#include "tools/floor/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace surefoot::floor {
namespace {

void include(Amplitude& amplitude, const run::Range& angle_deg, std::size_t walked) noexcept {
  const double largest_deg = angle_deg.largest_magnitude();
  amplitude.mean_deg += (largest_deg - amplitude.mean_deg) / static_cast<double>(walked);
  amplitude.worst_deg = std::max(amplitude.worst_deg, largest_deg);
}

}  // namespace

Summary summary_of(std::span<const run::Verdict> verdicts) {
  Summary summary;
  summary.runs = verdicts.size();
  std::size_t walked = 0;
  for (const run::Verdict& verdict : verdicts) {
    if (verdict.outcome != run::Outcome::kWalked) {
      ++summary.falls;
      continue;
    }
    ++walked;
    include(summary.roll, verdict.torso_roll_deg, walked);
    include(summary.pitch, verdict.torso_pitch_deg, walked);
    summary.shortest_way_m = walked == 1 ? verdict.distance_m : std::min(summary.shortest_way_m, verdict.distance_m);
  }
  return summary;
}

std::string text_of(const Summary& summary, const Amplitude& amplitude) {
  return summary.all_fell() ? "-" : fmt::format("{:.2f} ({:.2f})", amplitude.mean_deg, amplitude.worst_deg);
}

nlohmann::ordered_json json_of(const Summary& summary) {
  nlohmann::ordered_json json{{"runs", summary.runs}, {"falls", summary.falls}};
  const auto add = [&](const char* name, double value) {
    json[name] = summary.all_fell() ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
  };
  add("roll_mean_deg", summary.roll.mean_deg);
  add("roll_worst_deg", summary.roll.worst_deg);
  add("pitch_mean_deg", summary.pitch.mean_deg);
  add("pitch_worst_deg", summary.pitch.worst_deg);
  add("shortest_way_m", summary.shortest_way_m);
  return json;
}

const char* csv_header() noexcept {
  return "falls,runs,roll_mean_deg,roll_worst_deg,pitch_mean_deg,pitch_worst_deg,shortest_way_m";
}

std::string csv_of(const Summary& summary) {
  const std::string counts = fmt::format("{},{},", summary.falls, summary.runs);
  if (summary.all_fell()) return counts + ",,,,";
  return counts + fmt::format("{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", summary.roll.mean_deg, summary.roll.worst_deg,
                              summary.pitch.mean_deg, summary.pitch.worst_deg, summary.shortest_way_m);
}

}  // namespace surefoot::floor
