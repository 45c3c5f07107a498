#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include "tools/scenario/bare_word.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/toml_reader.hpp"

namespace surefoot::scenario {
namespace {

constexpr const char* kPattern = "write it like --set reflex.method=off or --set payload.0.mass_kg=5";

/// Longer ones are mistakes; see the limit on files.
constexpr std::size_t kLongestOverride = 4096;

constexpr std::size_t kLongestShown = 120;

/// Why one override cannot be written; caught where its place is known.
struct Refused {
  std::string statement;
  std::string remedy = kPattern;
};

/// A table with the value under "value".
toml::table parse_value(const std::string& text) {
  try {
    toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return table;
  } catch (const toml::parse_error& error) {
    if (is_bare_word(text)) return toml::table{{"value", text}};
    throw Refused{fmt::format("\"{}\" is not a TOML value: {}", text, error.description())};
  }
  throw Refused{fmt::format("\"{}\" is more than one TOML value", text)};
}

std::vector<std::string> split(std::string_view key) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    parts.emplace_back(key.substr(begin, end - begin));
    if (parts.back().empty()) throw Refused{fmt::format("the key \"{}\" has an empty part", key)};
    begin = end + 1;
  }
  return parts;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

std::optional<std::size_t> parse_index(const std::string& text) {
  std::size_t place = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, place);
  if (error != std::errc{} || rest != end) return std::nullopt;
  return place;
}

/// The element `part` of an array of tables; one past the end appends an empty table.
toml::node& step_into(toml::array& array, const std::string& part, const std::string& shown) {
  const std::optional<std::size_t> place = parse_index(part);
  if (!place) throw Refused{fmt::format("{0} is an array; expected a place in it, as in {0}.0.{1}", shown, part)};
  if (*place > array.size()) {
    throw Refused{fmt::format("{}[{}] does not exist, there are {}", shown, *place, array.size()),
                  fmt::format("the next one is {}.{}", shown, array.size())};
  }
  if (*place == array.size()) array.push_back(toml::table{});
  return array[*place];
}

/// The child `part` of a table; a missing one becomes an empty table, or array where a place follows.
toml::node& step_into(toml::table& table, const std::string& part, bool place_follows) {
  if (!table.contains(part)) {
    if (place_follows) {
      table.insert(part, toml::array{});
    } else {
      table.insert(part, toml::table{});
    }
  }
  return *table.get(part);
}

/// Writes the value; returns the key as messages show it.
std::string write(toml::table& root, const std::vector<std::string>& parts, const toml::node& value) {
  toml::node* node = &root;
  std::string shown;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    if (toml::table* table = node->as_table()) {
      const bool place_follows = is_array_of_tables(parts[i]) && parse_index(parts[i + 1]).has_value();
      node = &step_into(*table, parts[i], place_follows);
      shown += (shown.empty() ? "" : ".") + parts[i];
    } else if (toml::array* array = node->as_array(); array && is_array_of_tables(shown)) {
      node = &step_into(*array, parts[i], shown);
      shown += "[" + parts[i] + "]";
    } else {
      throw Refused{fmt::format("{} is not a table, it has no key {}", shown, parts[i])};
    }
  }
  const std::string& last = parts.back();
  if (toml::table* table = node->as_table()) {
    table->insert_or_assign(last, value);
    return shown + (shown.empty() ? "" : ".") + last;
  }
  if (toml::array* array = node->as_array(); array && is_array_of_tables(shown)) {
    (void)step_into(*array, last, shown);
    array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(*parse_index(last)), value);
    return shown + "[" + last + "]";
  }
  throw Refused{fmt::format("{} is not a table, it has no key {}", shown, last),
                node->is_array() ? fmt::format("set all of it, as in --set {}=[...]", shown) : kPattern};
}

void apply(Document& document, const std::string& text) {
  if (text.size() > kLongestOverride) throw Refused{"is longer than 4096 characters"};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw Refused{"expected key=value"};
  const std::string value_text = text.substr(equals + 1);
  if (value_text.find_first_not_of(" \t") == std::string::npos) throw Refused{"has no value; expected key=value"};
  const std::vector<std::string> parts = split(trimmed(std::string_view(text).substr(0, equals)));
  const toml::table value = parse_value(value_text);
  const std::string shown = write(document.root, parts, *value.get("value"));
  document.overrides[shown] = "--set " + text.substr(0, kLongestShown);
}

}  // namespace

void apply_overrides(Document& document, std::span<const std::string> overrides) {
  std::vector<Problem> problems;
  for (const std::string& text : overrides) {
    try {
      apply(document, text);
    } catch (const Refused& refused) {
      problems.push_back({"--set " + text.substr(0, kLongestShown), refused.statement, refused.remedy});
    }
  }
  if (!problems.empty()) throw ScenarioError(std::move(problems));
}

}  // namespace surefoot::scenario
