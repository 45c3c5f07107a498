#include "tools/scenario/field_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <utility>

#include "tools/scenario/suggestion.hpp"

namespace surefoot::scenario {
namespace {

constexpr std::size_t kLongestShownValue = 60;

}  // namespace

std::string shown(const toml::node& node) {
  if (node.is_table()) return "a table";
  if (const toml::array* array = node.as_array()) return fmt::format("an array of {}", array->size());
  if (node.is_floating_point()) return toml_number(node.as_floating_point()->get());
  std::ostringstream stream;
  stream << toml::toml_formatter(node, toml::format_flags::none);
  std::string text = stream.str();
  if (text.size() > kLongestShownValue) text = text.substr(0, kLongestShownValue) + "...";
  return text;
}

std::string shown_with_type(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return "the string " + shown(node);
    case toml::node_type::integer:
      return "the integer " + shown(node);
    case toml::node_type::floating_point:
      return "the float " + shown(node);
    case toml::node_type::boolean:
      return "the boolean " + shown(node);
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time:
      return "the date or time " + shown(node);
    default:
      return shown(node);
  }
}

void FieldReader::know(std::span<const Field> known, const std::vector<std::string>& others) {
  for (const Field& field : known) {
    known_keys_.push_back(field.key);
    if (const std::size_t dot = field.key.find('.'); dot != std::string::npos) tables_.insert(field.key.substr(0, dot));
  }
  known_keys_.insert(known_keys_.end(), others.begin(), others.end());
  known_keys_.insert(known_keys_.end(), tables_.begin(), tables_.end());
}

bool FieldReader::read_other(const std::string&, const toml::node&) { return false; }

bool FieldReader::read_field(std::string_view name, const std::string& key, const toml::node& node,
                             const std::vector<Field>& known, const std::vector<Field>& defaults) {
  const auto field = std::find_if(known.begin(), known.end(), [&](const Field& f) { return f.key == name; });
  if (field == known.end()) return false;
  places_[key] = place_of(key, node.source().begin);
  assign(*field, key, node, value_text(defaults[static_cast<std::size_t>(field - known.begin())]));
  return true;
}

void FieldReader::read_table(const toml::table& table, const std::string& prefix, const std::vector<Field>& known,
                             const std::vector<Field>& defaults) {
  for (const auto& [name, node] : table) {
    const std::string key = prefix + std::string(name.str());
    if (read_field(key, key, node, known, defaults)) continue;
    const Place place = place_of(key, node.source().begin);
    if (prefix.empty() && read_other(key, node)) {
      places_[key] = place;
    } else if (prefix.empty() && tables_.contains(key)) {
      read_known_table(key, node, place, known, defaults);
    } else {
      report_unknown(key, place_of(key, name.source().begin), known_keys_);
    }
  }
}

void FieldReader::read_known_table(const std::string& key, const toml::node& node, const Place& place,
                                   const std::vector<Field>& known, const std::vector<Field>& defaults) {
  if (const toml::table* inner = node.as_table()) {
    read_table(*inner, key + ".", known, defaults);
  } else {
    add(place, fmt::format("{} is {}; expected a table", key, shown_with_type(node)),
        fmt::format("write [{}] on a line of its own and its keys below", key));
  }
}

void FieldReader::report_unless_known_bad(std::span<const Finding> findings) {
  for (const Finding& finding : findings) {
    const auto is_bad = [this](const std::string& key) { return bad_keys_.contains(key); };
    if (std::none_of(finding.keys.begin(), finding.keys.end(), is_bad)) report(finding);
  }
}

/// Writes one value into the scenario, or reports why it cannot be.
void FieldReader::assign(const Field& field, const std::string& key, const toml::node& node,
                         const std::string& default_text) {
  const auto refuse = [&](const std::string& value, const std::string& expected) {
    report(refusal(field, key, value, expected, default_text));
  };
  if (auto* const* number = std::get_if<double*>(&field.target)) {
    if (!node.is_number()) return refuse(shown_with_type(node), expectation(field));
    const double value = *node.value<double>();
    if (!is_in_range(field, value)) return refuse(shown(node), range_text(field));
    **number = value;
  } else if (auto* const* flag = std::get_if<bool*>(&field.target)) {
    if (!node.is_boolean()) return refuse(shown_with_type(node), expectation(field));
    **flag = node.as_boolean()->get();
  } else if (const auto* choice = std::get_if<Choice>(&field.target)) {
    if (!node.is_string()) return refuse(shown_with_type(node), expectation(field));
    const auto name = std::find(choice->names.begin(), choice->names.end(), node.as_string()->get());
    if (name == choice->names.end()) return refuse(shown(node), expectation(field));
    choice->set(static_cast<std::size_t>(name - choice->names.begin()));
  } else if (const auto* numbers = std::get_if<Numbers>(&field.target)) {
    assign_array(field, *numbers, key, node, default_text);
  } else {
    if (!node.is_integer()) return refuse(shown_with_type(node), expectation(field));
    const std::int64_t value = node.as_integer()->get();
    if (!is_in_range(field, static_cast<double>(value))) return refuse(shown(node), range_text(field));
    if (auto* const* small = std::get_if<std::uint32_t*>(&field.target)) **small = static_cast<std::uint32_t>(value);
    if (auto* const* large = std::get_if<std::uint64_t*>(&field.target)) **large = static_cast<std::uint64_t>(value);
  }
}

void FieldReader::assign_array(const Field& field, const Numbers& numbers, const std::string& key,
                               const toml::node& node, const std::string& default_text) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != numbers.size()) {
    return report(refusal(field, key, shown_with_type(node), expectation(field), default_text));
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const toml::node& element = (*array)[i];
    const std::string element_key = fmt::format("{}[{}]", key, i);
    if (!element.is_number()) {
      report(refusal(field, element_key, shown_with_type(element), "a number, " + range_text(field), default_text));
    } else if (!is_in_range(field, *element.value<double>())) {
      report(refusal(field, element_key, shown(element), range_text(field), default_text));
    } else {
      *numbers[i] = *element.value<double>();
      continue;
    }
    bad_keys_.insert(key);
    problems_.back().first = place_of(key, element.source().begin);
  }
}

void FieldReader::report_unknown(const std::string& key, const Place& place, std::span<const std::string> candidates) {
  const std::string nearest = nearest_key(key, candidates);
  add(place, fmt::format("{} is unknown{}", key, nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
      "correct or remove it; " + unknown_remedy_);
}

void FieldReader::report(const Finding& finding) {
  Place place{document_.name, {}};
  for (const std::string& key : finding.keys) {
    if (const auto found = places_.find(key); found != places_.end()) {
      place = found->second;
      break;
    }
  }
  bad_keys_.insert(finding.keys.begin(), finding.keys.end());
  add(place, finding.statement, finding.remedy);
}

/// The position in the file; what an override brought has none, its place is the override that set
/// this key, a table around it or a key below it.
FieldReader::Place FieldReader::place_of(const std::string& key, const toml::source_position& position) const {
  if (position) return {fmt::format("{}:{}:{}", document_.name, position.line, position.column), position};
  for (std::string ancestor = key; !ancestor.empty();) {
    if (const auto found = document_.overrides.find(ancestor); found != document_.overrides.end()) {
      return {found->second};
    }
    const std::size_t cut = ancestor.find_last_of(".[");
    ancestor.resize(cut == std::string::npos ? 0 : cut);
  }
  const auto below = document_.overrides.lower_bound(key);
  return {below != document_.overrides.end() && below->first.starts_with(key) ? below->second : document_.name};
}

void FieldReader::add(Place place, std::string statement, std::string remedy) {
  Problem problem{place.text, std::move(statement), std::move(remedy)};
  problems_.emplace_back(std::move(place), std::move(problem));
}

void FieldReader::throw_problems() {
  if (problems_.empty()) return;
  std::stable_sort(problems_.begin(), problems_.end(),
                   [](const auto& a, const auto& b) { return a.first.position < b.first.position; });
  std::vector<Problem> problems;
  for (auto& [place, problem] : problems_) {
    problem.place = place.text;
    problems.push_back(std::move(problem));
  }
  throw ScenarioError(std::move(problems));
}

}  // namespace surefoot::scenario
