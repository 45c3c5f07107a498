#include "tools/sweep/sweep_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "tools/sweep/sweep.hpp"
#include "tools/sweep/toml_value.hpp"

namespace surefoot::sweep {
namespace {

/// Also of integers that a double rounds, which toml++ gives no double for.
double number_of(const toml::node& node) {
  return node.is_integer() ? static_cast<double>(node.as_integer()->get()) : node.as_floating_point()->get();
}

constexpr std::array<std::string_view, 7> kKeys{"scenario", "draws", "draw_seed", "set", "grid", "list", "random"};

/// A key with what stands behind it.
struct Leaf {
  std::string key;
  KeyKind kind;
  const toml::node* node;
};

bool is_a_range(const toml::node& node) {
  const toml::table* table = node.as_table();
  return table != nullptr && (table->contains("min") || table->contains("max"));
}

bool is_no_table(const toml::node& node) { return !node.is_table(); }

class Reader {
 public:
  Reader(const std::string& name, const toml::table& root) : name_(name), root_(root) {}

  SweepFile read() {
    for (const auto& [key, node] : root_) {
      if (std::ranges::find(kKeys, key.str()) == kKeys.end()) {
        add(key.source(), fmt::format("{} is no key of a sweep", key.str()),
            "keys are scenario, draws, draw_seed, [set], [grid], [list], [random]; those of the scenario stand in a "
            "table");
      }
    }
    SweepFile file;
    if (const toml::node* node = root_.get("scenario")) read_scenario(*node, file);
    for (const Leaf& leaf : leaves("set", is_no_table)) {
      file.set.push_back({leaf.key, {value_of(*leaf.node, leaf.kind)}});
    }
    for (const Leaf& leaf : leaves("grid", is_no_table)) read_values(leaf, file.grid);
    for (const Leaf& leaf : leaves("list", is_no_table)) read_values(leaf, file.list);
    for (const Leaf& leaf : leaves("random", is_a_range)) read_range(leaf, file.random);
    check_list(file.list);
    read_draws(file);
    if (!problems_.empty()) throw_problems();
    return file;
  }

 private:
  void read_scenario(const toml::node& node, SweepFile& file) {
    if (!node.is_string() || node.as_string()->get().empty()) {
      return add(node.source(), "scenario is not the name of a file", "write it in quotes: scenario = \"main.toml\"");
    }
    file.scenario = node.as_string()->get();
  }

  void read_draws(SweepFile& file) {
    if (const toml::node* node = root_.get("draw_seed")) {
      file.draw_seed = integer(*node, "draw_seed", 0, std::numeric_limits<std::int64_t>::max());
    }
    const toml::node* node = root_.get("draws");
    if (node != nullptr) file.draws = integer(*node, "draws", 1, static_cast<std::int64_t>(kMaxRows));
    if (node != nullptr && !root_.contains("random")) {
      add(node->source(), "draws has nothing to draw",
          "say what in [random], as in floor.friction = {min = 0.1, max = 1}");
    }
    if (node == nullptr && !file.random.empty()) {
      problems_.emplace_back(toml::source_position{},
                             scenario::Problem{file.random.front().place, "[random] needs a number of draws",
                                               "write draws = 100 above the first table"});
    }
  }

  std::uint64_t integer(const toml::node& node, const char* key, std::int64_t min, std::int64_t max) {
    const auto* value = node.as_integer();
    if (value != nullptr && value->get() >= min && value->get() <= max) return static_cast<std::uint64_t>(value->get());
    add(node.source(), fmt::format("{} is {}; expected an integer, {} to {}", key, shown(node), min, max),
        "correct this value");
    return 1;
  }

  /// Every key of a scenario in one table of the file, in the order of the file.
  std::vector<Leaf> leaves(const char* name, bool (*is_leaf)(const toml::node&)) {
    const toml::node* node = root_.get(name);
    if (node == nullptr) return {};
    std::vector<std::pair<toml::source_position, Leaf>> found;
    if (const toml::table* table = node->as_table()) {
      collect(*table, "", is_leaf, found);
    } else {
      add(node->source(), fmt::format("{} is {}; expected a table", name, shown(*node)),
          fmt::format("write [{}] on a line of its own and keys of the scenario below", name));
    }
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Leaf> sorted;
    for (auto& [position, leaf] : found) sorted.push_back(std::move(leaf));
    return sorted;
  }

  void collect(const toml::table& table, const std::string& prefix, bool (*is_leaf)(const toml::node&),
               std::vector<std::pair<toml::source_position, Leaf>>& found) {
    for (const auto& [name, node] : table) {
      const std::string key = prefix + std::string(name.str());
      if (node.is_table() && !is_leaf(node)) {
        collect(*node.as_table(), key + ".", is_leaf, found);
      } else if (const std::optional<KeyKind> kind = kind_of(key); !kind) {
        const std::string nearest = nearest_known_key(key);
        add(name.source(),
            fmt::format("{} is unknown{}", key, nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
            "correct or remove it; surefoot keys shows every key");
      } else if (!keys_.insert(key).second) {
        add(name.source(), fmt::format("{} stands in two tables", key), "leave it in one of them");
      } else {
        found.emplace_back(name.source().begin, Leaf{key, *kind, &node});
      }
    }
  }

  void read_values(const Leaf& leaf, std::vector<Varied>& into) {
    const toml::array* array = leaf.node->as_array();
    if (array == nullptr || array->empty()) {
      return add(leaf.node->source(),
                 fmt::format("{} is {}; expected an array of values", leaf.key,
                             array == nullptr ? shown(*leaf.node) : "an empty array"),
                 fmt::format("write {} = [...] with one value or more, or give it in [set]", leaf.key));
    }
    Varied varied{leaf.key, {}};
    for (const toml::node& node : *array) varied.values.push_back(value_of(node, leaf.kind));
    into.push_back(std::move(varied));
  }

  void read_range(const Leaf& leaf, std::vector<RandomKey>& into) {
    const bool is_integer = leaf.kind == KeyKind::kInteger;
    const auto refuse = [&](const std::string& why) {
      add(leaf.node->source(), fmt::format("{} {}", leaf.key, why),
          is_integer
              ? fmt::format("write {} = {{min = 1, max = 1000}}", leaf.key)
              : fmt::format("write {} = {{min = 0.1, max = 1.0}}, or give its values in [grid] or [list]", leaf.key));
    };
    if (leaf.kind != KeyKind::kNumber && !is_integer) return refuse("is no number and cannot be drawn");
    const toml::table* range = leaf.node->as_table();
    if (range == nullptr)
      return refuse(fmt::format("is {}; expected its smallest and largest value", shown(*leaf.node)));
    const toml::node* min = range->get("min");
    const toml::node* max = range->get("max");
    if (min == nullptr || max == nullptr || range->size() != 2) return refuse("needs min and max and nothing else");
    if (is_integer && !(min->is_integer() && max->is_integer())) return refuse("needs integers for min and max");
    if (!min->is_number() || !max->is_number()) return refuse("needs numbers for min and max");
    RandomKey random{leaf.key,
                     place_of(leaf.node->source()),
                     is_integer,
                     number_of(*min),
                     number_of(*max),
                     is_integer ? min->as_integer()->get() : 0,
                     is_integer ? max->as_integer()->get() : 0};
    if (!std::isfinite(random.max - random.min)) return refuse("needs finite numbers for min and max");
    if (random.min > random.max || random.min_integer > random.max_integer) return refuse("has a min above its max");
    into.push_back(std::move(random));
  }

  void check_list(const std::vector<Varied>& list) {
    for (const Varied& varied : list) {
      if (varied.values.size() == list.front().values.size()) continue;
      problems_.emplace_back(
          toml::source_position{},
          scenario::Problem{varied.values.front().place,
                            fmt::format("{} has {} values, {} has {}", varied.key, varied.values.size(),
                                        list.front().key, list.front().values.size()),
                            "give all keys of [list] as many: row k takes the k-th of each"});
    }
  }

  Value value_of(const toml::node& node, KeyKind kind) {
    return {value_text(node, kind == KeyKind::kNumber), place_of(node.source())};
  }

  static std::string shown(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array()) return "an array";
    constexpr std::size_t kLongest = 60;
    const std::string text = value_text(node, false);
    return text.size() > kLongest ? text.substr(0, kLongest) + "..." : text;
  }

  [[nodiscard]] std::string place_of(const toml::source_region& source) const {
    return fmt::format("{}:{}:{}", name_, source.begin.line, source.begin.column);
  }

  void add(const toml::source_region& source, std::string statement, std::string remedy) {
    problems_.emplace_back(source.begin, scenario::Problem{place_of(source), std::move(statement), std::move(remedy)});
  }

  [[noreturn]] void throw_problems() {
    std::ranges::stable_sort(problems_, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<scenario::Problem> problems;
    for (auto& [position, problem] : problems_) problems.push_back(std::move(problem));
    throw scenario::ScenarioError(std::move(problems));
  }

  const std::string& name_;
  const toml::table& root_;
  std::set<std::string> keys_;
  std::vector<std::pair<toml::source_position, scenario::Problem>> problems_;
};

}  // namespace

SweepFile read_sweep_file(const std::string& name, const toml::table& root) { return Reader(name, root).read(); }

}  // namespace surefoot::sweep
