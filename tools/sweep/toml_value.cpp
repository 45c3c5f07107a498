#include "tools/sweep/toml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "tools/scenario/bare_word.hpp"
#include "tools/scenario/field.hpp"

namespace surefoot::sweep {
namespace {

/// Whether `--set` reads the word as a string without quotes.
bool needs_no_quotes(std::string_view text) {
  constexpr std::array<std::string_view, 4> kNoStrings{"true", "false", "inf", "nan"};
  return scenario::is_bare_word(text) && std::ranges::find(kNoStrings, text) == kNoStrings.end();
}

std::string quoted(std::string_view text) {
  std::string shown = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') shown += '\\';
    shown += byte < 0x20 || byte == 0x7F ? fmt::format("\\u{:04X}", byte) : std::string(1, c);
  }
  return shown + '"';
}

std::string text_within(const toml::node& node, bool is_number) {
  const toml::value<std::string>* string = node.as_string();
  return string != nullptr ? quoted(string->get()) : value_text(node, is_number);
}

}  // namespace

std::string value_text(const toml::node& node, bool is_number) {
  if (const auto* number = node.as_floating_point()) return scenario::toml_number(number->get());
  if (const auto* integer = node.as_integer()) {
    return is_number ? scenario::toml_number(static_cast<double>(integer->get())) : fmt::format("{}", integer->get());
  }
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (const auto* string = node.as_string()) {
    return needs_no_quotes(string->get()) ? string->get() : quoted(string->get());
  }
  std::string text;
  if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) text += (text.empty() ? "" : ", ") + text_within(element, is_number);
    return "[" + text + "]";
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, member] : *table) {
      text += (text.empty() ? "" : ", ") + quoted(key.str()) + " = " + text_within(member, is_number);
    }
    return "{" + text + "}";
  }
  std::ostringstream date;
  date << toml::toml_formatter(node, toml::format_flags::none);
  return date.str();
}

}  // namespace surefoot::sweep
