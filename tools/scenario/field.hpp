#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace surefoot::scenario {

/// A value that is one of a few names: an enumeration, or a string with fixed choices.
struct Choice {
  std::span<const char* const> names;
  std::function<std::size_t()> get;      ///< place in `names`; names.size() when it is none of them
  std::function<void(std::size_t)> set;  ///< takes a place in `names`
  const void* object = nullptr;          ///< the member itself
};

/// Several numbers that form one TOML array.
using Numbers = std::vector<double*>;

/// The member of the scenario that a key sets; its type is the key's kind.
using Target = std::variant<double*, std::uint32_t*, std::uint64_t*, bool*, Choice, Numbers>;

/// Which numbers a key takes.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool is_open_below = false;  ///< `min` itself is not allowed
  bool may_be_never = false;   ///< inf is allowed too: an instant that never comes
};

/// One key of the scenario: the only place where its name, limits and meaning stand. Parsing,
/// checks, the effective scenario and the list of keys all read it.
struct Field {
  std::string key;   ///< "gait.half_step_m"; within a [[payload]]: "mass_kg"
  Target target;     ///< valid as long as the scenario that it was made from
  Range range;       ///< of numbers, and of each element of an array
  std::string unit;  ///< "m"; "1" for ratios; empty where there is none
  std::string doc;   ///< noun phrase without article, e.g. "apex of the swing foot"
};

/// "0 to 60 kg", "more than 0, up to 3600 s"
[[nodiscard]] std::string range_text(const Field& field);

/// What the field takes: "a number from 0 to 60 kg", "one of \"ramp\", \"quintic\"", "true or false",
/// "an array of 6 numbers, each 0 to 1 m".
[[nodiscard]] std::string expectation(const Field& field);

/// The kind in one word: "number", "integer", "boolean", "choice", "array".
[[nodiscard]] const char* kind_name(const Field& field) noexcept;

/// The present value as TOML; doubles in the shortest form that reads back to the same bits.
[[nodiscard]] std::string value_text(const Field& field);

/// The two lines that tell people about a key: kind and meaning, what it takes and its present value.
/// @param key  as it is shown
[[nodiscard]] std::string description(const std::string& key, const Field& field);

/// A double as TOML: always a float, never an integer.
[[nodiscard]] std::string toml_number(double value);

/// Whether a number may stand in this field: finite and in range, or the inf that its range allows.
[[nodiscard]] bool is_in_range(const Field& field, double value) noexcept;

}  // namespace surefoot::scenario
