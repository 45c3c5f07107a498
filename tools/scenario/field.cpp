#include "tools/scenario/field.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace surefoot::scenario {
namespace {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

std::string quoted_names(const Choice& choice) {
  std::string text;
  for (const char* name : choice.names) text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
  return text;
}

}  // namespace

std::string range_text(const Field& field) {
  const char* form = field.range.is_open_below ? "more than {}, up to {}" : "{} to {}";
  std::string text = fmt::format(fmt::runtime(form), field.range.min, field.range.max);
  if (!field.unit.empty() && field.unit != "1") text += " " + field.unit;
  if (field.range.may_be_never) text += ", or inf for never";
  return text;
}

std::string expectation(const Field& field) {
  return std::visit(
      Overloaded{
          [&](double*) { return "a number, " + range_text(field); },
          [&](std::uint32_t*) { return "an integer, " + range_text(field); },
          [&](std::uint64_t*) { return "an integer, " + range_text(field); },
          [](bool*) { return std::string("true or false"); },
          [](const Choice& choice) { return (choice.names.size() > 1 ? "one of " : "") + quoted_names(choice); },
          [&](const Numbers& numbers) {
            return fmt::format("an array of {} numbers, each {}", numbers.size(), range_text(field));
          },
      },
      field.target);
}

const char* kind_name(const Field& field) noexcept {
  constexpr const char* kNames[] = {"number", "integer", "integer", "boolean", "choice", "array"};
  static_assert(std::size(kNames) == std::variant_size_v<Target>);
  return kNames[field.target.index()];
}

std::string toml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (std::isfinite(value) && text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string value_text(const Field& field) {
  return std::visit(Overloaded{
                        [](const double* number) { return toml_number(*number); },
                        [](const std::uint32_t* number) { return fmt::format("{}", *number); },
                        [](const std::uint64_t* number) { return fmt::format("{}", *number); },
                        [](const bool* flag) { return std::string(*flag ? "true" : "false"); },
                        [](const Choice& choice) {
                          const std::size_t place = choice.get();
                          return fmt::format("\"{}\"", place < choice.names.size() ? choice.names[place] : "?");
                        },
                        [](const Numbers& numbers) {
                          std::string text;
                          for (const double* number : numbers) {
                            text += (text.empty() ? "" : ", ") + toml_number(*number);
                          }
                          return "[" + text + "]";
                        },
                    },
                    field.target);
}

std::string description(const std::string& key, const Field& field) {
  return fmt::format("  {:<42} {:<8} {}\n{:>53} {}; default {}\n", key, kind_name(field), field.doc, "",
                     expectation(field), value_text(field));
}

bool is_in_range(const Field& field, double value) noexcept {
  if (field.range.may_be_never && value == std::numeric_limits<double>::infinity()) return true;
  const bool above_min = field.range.is_open_below ? value > field.range.min : value >= field.range.min;
  return std::isfinite(value) && above_min && value <= field.range.max;
}

}  // namespace surefoot::scenario
