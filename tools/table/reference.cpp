#include "tools/table/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>
#include <utility>

#include "tools/table/embedded_reference.hpp"
#include "tools/table/small_file.hpp"

namespace surefoot::table {
namespace {

constexpr std::size_t kLongestShown = 40;

[[noreturn]] void refuse(const std::string& name, std::size_t line, const std::string& what) {
  throw BadReference(
      fmt::format("{}:{}: {}\n  remedy: write a head \"load_time_s,2.5,5\" and rows like \"0.1,1,0\": "
                  "1 survives, 0 falls, empty is unknown; see tools/table/reference/",
                  name, line, what));
}

/// What a terminal may be shown of a field.
std::string shown(std::string_view field) {
  std::string text(field.substr(0, kLongestShown));
  std::ranges::replace_if(
      text, [](char c) { return c < 0x20 || c > 0x7E; }, '?');
  return text;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

/// Numbers stand in ascending order, so that no cell is given twice.
void add_number(std::string_view field, const char* what, const std::string& name, std::size_t line,
                std::vector<double>& numbers) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (field.empty() || error != std::errc{} || rest != field.data() + field.size() || !std::isfinite(value) ||
      value < 0.0) {
    refuse(name, line, fmt::format("the {} \"{}\" is no number of 0 or more", what, shown(field)));
  }
  if (!numbers.empty() && value <= numbers.back() + 1e-9) {
    refuse(name, line, fmt::format("the {} {} does not come after {}", what, value, numbers.back()));
  }
  numbers.push_back(value);
}

std::optional<bool> cell_of(std::string_view field, const std::string& name, std::size_t line) {
  if (field.empty()) return std::nullopt;
  if (field != "0" && field != "1") {
    refuse(name, line, fmt::format("the cell \"{}\" is neither 0 nor 1 nor empty", shown(field)));
  }
  return field == "1";
}

}  // namespace

std::optional<bool> Reference::at(double time_s, double mass_kg) const noexcept {
  const auto place = [](const std::vector<double>& values, double wanted) {
    return static_cast<std::size_t>(std::ranges::find_if(values, [&](double value) { return is_same(value, wanted); }) -
                                    values.begin());
  };
  const std::size_t time = place(grid.times_s, time_s);
  const std::size_t mass = place(grid.masses_kg, mass_kg);
  if (time == grid.times_s.size() || mass == grid.masses_kg.size()) return std::nullopt;
  return survives[grid.index(time, mass)];
}

Reference parse_reference(const std::string& name, const std::string& text) {
  Reference reference;
  reference.name = name;
  std::istringstream lines(text);
  std::string line;
  std::size_t number = 0;
  while (std::getline(lines, line)) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = fields_of(line);
    if (reference.grid.masses_kg.empty()) {
      if (fields[0] != "load_time_s") {
        refuse(name, number, fmt::format("the head begins with \"{}\", not load_time_s", shown(fields[0])));
      }
      if (fields.size() < 2) refuse(name, number, "the head names no load");
      for (std::size_t i = 1; i < fields.size(); ++i) {
        add_number(fields[i], "load", name, number, reference.grid.masses_kg);
      }
      continue;
    }
    if (fields.size() != reference.grid.masses_kg.size() + 1) {
      refuse(name, number,
             fmt::format("{} fields; the head has {}", fields.size(), reference.grid.masses_kg.size() + 1));
    }
    add_number(fields[0], "instant", name, number, reference.grid.times_s);
    for (std::size_t i = 1; i < fields.size(); ++i) reference.survives.push_back(cell_of(fields[i], name, number));
  }
  if (reference.survives.empty()) refuse(name, std::max<std::size_t>(number, 1), "there is no row of results");
  return reference;
}

Reference load_reference(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_small_file(file);
  if (!text) {
    throw BadReference(
        fmt::format("{}: is no readable file of 1 to {} bytes\n  remedy: give a table like those in "
                    "tools/table/reference/",
                    file.string(), kLargestFile));
  }
  return parse_reference(file.string(), *text);
}

std::optional<Reference> thesis_table(const std::string& method) {
  if (method == "off") return parse_reference("thesis, table 4.1", kTableOff);
  if (method == "original") return parse_reference("thesis, table 4.2", kTableOriginal);
  if (method == "modified") return parse_reference("thesis, table 4.3", kTableModified);
  return std::nullopt;
}

}  // namespace surefoot::table
