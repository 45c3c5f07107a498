#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/map/survival_map.hpp"

namespace surefoot::map {
namespace {

using Json = nlohmann::ordered_json;

std::size_t widest(const Axis& axis) {
  std::size_t width = 0;
  for (const AxisValue& value : axis.values) width = std::max(width, value.label.size());
  return width;
}

Json labels_of(const Axis& axis) {
  Json labels = Json::array();
  for (const AxisValue& value : axis.values) labels.push_back(value.label);
  return {{"title", axis.title}, {"labels", labels}};
}

/// A field of comma-separated values; labels are free text.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string map_text(const SurvivalMap& map) {
  const MapSpec& spec = map.spec;
  const std::size_t row_width = std::max(widest(spec.rows), spec.rows.title.size());
  const std::size_t width = std::max<std::size_t>(widest(spec.columns), 3);
  std::string text =
      fmt::format("{}, plant {}; survivors of {} in each cell\n", spec.title, map.plant, spec.repeats.values.size());
  for (std::size_t method = 0; method < spec.methods.size(); ++method) {
    text += fmt::format("\n  {} {}: {} of {} survive\n  {:>{}}   {}\n  {:{}} ", spec.method_title, spec.methods[method],
                        map.total(method), map.runs(), spec.rows.title, row_width, spec.columns.title, "", row_width);
    for (const AxisValue& column : spec.columns.values) text += fmt::format("  {:>{}}", column.label, width);
    for (std::size_t row = 0; row < spec.rows.values.size(); ++row) {
      text += fmt::format("\n  {:>{}} ", spec.rows.values[row].label, row_width);
      for (std::size_t column = 0; column < spec.columns.values.size(); ++column) {
        text += fmt::format("  {:>{}}", map.at(method, row, column), width);
      }
    }
    text += "\n";
  }
  return text;
}

std::string map_csv(const SurvivalMap& map) {
  const MapSpec& spec = map.spec;
  std::string text = "method,row,column,survive,of\n";
  for (std::size_t method = 0; method < spec.methods.size(); ++method) {
    for (std::size_t row = 0; row < spec.rows.values.size(); ++row) {
      for (std::size_t column = 0; column < spec.columns.values.size(); ++column) {
        text += fmt::format("{},{},{},{},{}\n", csv_field(spec.methods[method]), csv_field(spec.rows.values[row].label),
                            csv_field(spec.columns.values[column].label), map.at(method, row, column),
                            spec.repeats.values.size());
      }
    }
  }
  return text;
}

std::string to_json(const SurvivalMap& map) {
  const MapSpec& spec = map.spec;
  Json panels = Json::array();
  for (std::size_t method = 0; method < spec.methods.size(); ++method) {
    Json rows = Json::array();
    for (std::size_t row = 0; row < spec.rows.values.size(); ++row) {
      Json cells = Json::array();
      for (std::size_t column = 0; column < spec.columns.values.size(); ++column) {
        cells.push_back(map.at(method, row, column));
      }
      rows.push_back(cells);
    }
    panels.push_back({{"method", spec.methods[method]}, {"survive", map.total(method)}, {"cells", rows}});
  }
  return Json{{"picture", "map"},
              {"title", spec.title},
              {"plant", map.plant},
              {"columns", labels_of(spec.columns)},
              {"rows", labels_of(spec.rows)},
              {"repeats", labels_of(spec.repeats)},
              {"of_each_cell", spec.repeats.values.size()},
              {"of_each_method", map.runs()},
              {"method_title", spec.method_title},
              {"methods", panels}}
             .dump(2) +
         "\n";
}

}  // namespace surefoot::map
