#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/plan/walked.hpp"

namespace surefoot::plan {
namespace {

using Json = nlohmann::ordered_json;

std::string millimetres(const std::optional<double>& length_m) {
  return length_m ? fmt::format("{:.1f}", 1e3 * *length_m) : "-";
}

Json known(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json samples_of(const std::vector<ZmpSample>& samples) {
  Json columns = {{"time_s", Json::array()},
                  {"planned_m", Json::array()},
                  {"measured_m", Json::array()},
                  {"rear_m", Json::array()},
                  {"front_m", Json::array()}};
  for (const ZmpSample& sample : samples) {
    columns["time_s"].push_back(sample.time_s);
    columns["planned_m"].push_back(sample.planned_m);
    columns["measured_m"].push_back(sample.measured_m);
    columns["rear_m"].push_back(sample.rear_m);
    columns["front_m"].push_back(sample.front_m);
  }
  return columns;
}

}  // namespace

std::string walked_text(std::span<const Walked> walks) {
  std::size_t width = 4;
  for (const Walked& walked : walks) width = std::max(width, walked.file.size());
  std::string text = fmt::format(
      "{0:{1}}  {2:9}  {3:15}  {4:7}  {5:>5}  {6:>6}  {7:>6}  {8:>27}  {9:>15}\n"
      "{10:{1}}  {10:9}  {10:15}  {10:7}  {10:5}  {11:>6}  {11:>6}  {12:>9} {13:>8} {14:>8}  {15:>7} {16:>7}\n",
      "file", width, "robot", "pattern", "verdict", "steps", "|roll|", "|pitch|", "ZMP margin, mm", "ZMP off, mm", "",
      "deg", "planned", "least", "5 %", "RMS", "most");
  for (const Walked& walked : walks) {
    text += fmt::format("{:{}}  {:9}  {:15}  {:7}  {:>5}  {:>6.2f}  {:>6.2f}  {:>9} {:>8} {:>8}  {:>7} {:>7}\n",
                        walked.file, width, walked.robot, walked.pattern, walked.verdict(), walked.steps,
                        walked.greatest_roll_deg, walked.greatest_pitch_deg, millimetres(walked.planned_margin_m),
                        millimetres(walked.least_margin_m), millimetres(walked.fifth_margin_m),
                        millimetres(walked.rms_difference_m), millimetres(walked.most_difference_m));
  }
  return text;
}

std::string walked_json(std::span<const Walked> walks, bool with_samples) {
  Json lines = Json::array();
  for (const Walked& walked : walks) {
    Json line = {{"file", walked.file},
                 {"robot", walked.robot},
                 {"pattern", walked.pattern},
                 {"verdict", walked.verdict()},
                 {"steps", walked.steps},
                 {"greatest_roll_deg", walked.greatest_roll_deg},
                 {"greatest_pitch_deg", walked.greatest_pitch_deg},
                 {"planned_margin_m", known(walked.planned_margin_m)},
                 {"least_margin_m", known(walked.least_margin_m)},
                 {"fifth_percentile_margin_m", known(walked.fifth_margin_m)},
                 {"rms_difference_m", known(walked.rms_difference_m)},
                 {"largest_difference_m", known(walked.most_difference_m)}};
    if (with_samples) line["samples"] = samples_of(walked.picture);
    lines.push_back(line);
  }
  return (with_samples ? Json{{"picture", "planned_zmp"}, {"walks", lines}} : lines).dump(2) + "\n";
}

}  // namespace surefoot::plan
