#include "tools/map/map_spec.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "tools/table/small_file.hpp"

namespace surefoot::map {
namespace {

constexpr std::size_t kMostValues = 1000;

/// A number, boolean or text as one would type it; empty for anything else.
std::string text_of(const toml::node& node) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<std::int64_t>()) return fmt::format("{}", *whole);
  if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
  if (const auto flag = node.value_exact<bool>()) return *flag ? "true" : "false";
  return {};
}

/// Reads one file, and names it in what it refuses.
class SpecReader {
 public:
  explicit SpecReader(std::string name) : name_(std::move(name)) {}

  [[noreturn]] void refuse(const toml::node& node, const std::string& what) const {
    const toml::source_position place = node.source().begin;
    throw BadSpec(fmt::format("{}:{}: {}\n  remedy: see the examples of surefoot map --kind mass-time --print", name_,
                              place.line, what));
  }

  void allow_only(const toml::table& table, const std::set<std::string_view>& keys) const {
    for (const auto& [key, value] : table) {
      if (!keys.contains(key.str())) refuse(value, fmt::format("{} is no key of this table", key.str()));
    }
  }

  [[nodiscard]] std::string member(const toml::table& table, const char* key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) refuse(table, fmt::format("{} is missing", key));
    const auto text = node->value_exact<std::string>();
    if (!text || text->empty()) refuse(*node, fmt::format("{} is no text", key));
    return *text;
  }

  /// @return empty where the key is absent
  [[nodiscard]] std::vector<std::string> texts_of(const toml::table& table, const char* key) const {
    std::vector<std::string> texts;
    const toml::node* node = table.get(key);
    if (node == nullptr) return texts;
    if (!node->is_array()) refuse(*node, fmt::format("{} is no array of texts", key));
    for (const toml::node& element : *node->as_array()) {
      const auto text = element.value_exact<std::string>();
      if (!text || text->empty()) refuse(element, fmt::format("{} is no array of texts", key));
      texts.push_back(*text);
    }
    return texts;
  }

  [[nodiscard]] Axis axis_of(const toml::table& root, const char* key) const {
    const toml::node* node = root.get(key);
    if (node == nullptr || !node->is_table()) {
      refuse(node == nullptr ? static_cast<const toml::node&>(root) : *node, fmt::format("[{}] is missing", key));
    }
    const toml::table& table = *node->as_table();
    allow_only(table, {"title", "key", "values"});
    Axis axis{member(table, "title"), {}};
    const toml::node* values = table.get("values");
    if (values == nullptr || !values->is_array() || values->as_array()->empty()) {
      refuse(table, fmt::format("{}.values is no array with at least one value", key));
    }
    if (values->as_array()->size() > kMostValues) {
      refuse(*values, fmt::format("{}.values has more than {} values", key, kMostValues));
    }
    const std::string scenario_key = table.contains("key") ? member(table, "key") : "";
    for (const toml::node& value : *values->as_array()) axis.values.push_back(value_of(value, scenario_key));
    return axis;
  }

 private:
  [[nodiscard]] AxisValue value_of(const toml::node& node, const std::string& key) const {
    if (const toml::table* table = node.as_table()) {
      allow_only(*table, {"label", "set"});
      return {member(*table, "label"), texts_of(*table, "set")};
    }
    const std::string text = text_of(node);
    if (text.empty()) refuse(node, "a value is a number, a boolean or a text");
    AxisValue value{text, {}};
    if (!key.empty()) value.overrides.push_back(key + "=" + text);
    return value;
  }

  std::string name_;
};

}  // namespace

MapSpec parse_spec(const std::string& name, const std::string& text) {
  toml::table root;
  try {
    root = toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw BadSpec(
        fmt::format("{}:{}: {}\n  remedy: write it as TOML 1.0", name, error.source().begin.line, error.description()));
  }
  const SpecReader reader(name);
  reader.allow_only(root, {"title", "methods", "set", "columns", "rows", "repeats"});
  MapSpec spec;
  spec.title = reader.member(root, "title");
  spec.methods = reader.texts_of(root, "methods");
  if (spec.methods.empty()) reader.refuse(root, "methods names none");
  spec.set = reader.texts_of(root, "set");
  spec.columns = reader.axis_of(root, "columns");
  spec.rows = reader.axis_of(root, "rows");
  spec.repeats = root.contains("repeats") ? reader.axis_of(root, "repeats") : Axis{"", {AxisValue{}}};
  return spec;
}

MapSpec load_spec(const std::filesystem::path& file) {
  const std::optional<std::string> text = table::read_small_file(file);
  if (!text) {
    throw BadSpec(
        fmt::format("{}: is no readable file of 1 to {} bytes\n  remedy: give a specification as that of "
                    "surefoot map --kind mass-time --print",
                    file.string(), table::kLargestFile));
  }
  return parse_spec(file.string(), *text);
}

}  // namespace surefoot::map
