#pragma once

#include <toml++/toml.h>

#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tools/scenario/checks.hpp"
#include "tools/scenario/field.hpp"
#include "tools/scenario/scenario_error.hpp"
#include "tools/scenario/toml_reader.hpp"

namespace surefoot::scenario {

/// Reads a document's values into the members that a table of fields names, and collects everything that is wrong with
/// it, each with its place. Scenarios and requests for gaits are read with it.
class FieldReader {
 public:
  /// @param document        outlives the reader
  /// @param unknown_remedy  where every key is shown, e.g. "surefoot keys shows every key"
  FieldReader(const Document& document, std::string unknown_remedy)
      : document_(document), unknown_remedy_(std::move(unknown_remedy)) {}
  FieldReader(const FieldReader&) = delete;
  FieldReader& operator=(const FieldReader&) = delete;
  virtual ~FieldReader() = default;

  /// The keys that may stand in the document: these fields and, at the top, these others.
  void know(std::span<const Field> known, const std::vector<std::string>& others = {});

  /// Reads the keys of one table.
  /// @param prefix    ends with a dot, or is empty at the top
  /// @param defaults  the same fields of what holds without the document
  void read_table(const toml::table& table, const std::string& prefix, const std::vector<Field>& known,
                  const std::vector<Field>& defaults);

  /// Whether the document has a value for the key.
  [[nodiscard]] bool was_given(const std::string& key) const { return places_.contains(key); }

  void report(const Finding& finding);
  /// Leaves out what follows from keys that were reported already.
  void report_unless_known_bad(std::span<const Finding> findings);

  /// @throws ScenarioError with every problem in the order of the lines, if there is any
  void throw_problems();

 protected:
  /// Where something was written; sorts by line.
  struct Place {
    std::string text;
    toml::source_position position{std::numeric_limits<toml::source_index>::max(), 0};
  };

  /// Takes a top-level key that is no field and no table of fields.
  /// @return whether it is known
  virtual bool read_other(const std::string& key, const toml::node& node);

  /// Reads a value where `name` is one of the fields.
  /// @param key  as messages show it
  bool read_field(std::string_view name, const std::string& key, const toml::node& node,
                  const std::vector<Field>& known, const std::vector<Field>& defaults);

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] Place place_of(const std::string& key, const toml::source_position& position) const;
  void report_unknown(const std::string& key, const Place& place, std::span<const std::string> candidates);
  void add(Place place, std::string statement, std::string remedy);

 private:
  void read_known_table(const std::string& key, const toml::node& node, const Place& place,
                        const std::vector<Field>& known, const std::vector<Field>& defaults);
  void assign(const Field& field, const std::string& key, const toml::node& node, const std::string& default_text);
  void assign_array(const Field& field, const Numbers& numbers, const std::string& key, const toml::node& node,
                    const std::string& default_text);

  const Document& document_;
  std::string unknown_remedy_;
  std::vector<std::string> known_keys_;
  std::set<std::string> tables_;
  std::map<std::string, Place> places_;
  std::set<std::string> bad_keys_;
  std::vector<std::pair<Place, Problem>> problems_;
};

/// "-5", "\"abc\"", "a table", "an array of 3"
[[nodiscard]] std::string shown(const toml::node& node);

/// The value with its type, for messages about a wrong one.
[[nodiscard]] std::string shown_with_type(const toml::node& node);

}  // namespace surefoot::scenario
