#pragma once

#include <string>
#include <vector>

#include "tools/run/verdict.hpp"
#include "tools/sweep/sweep.hpp"

namespace surefoot::sweep {

/// What a column of results holds: one type from top to bottom, and never nothing.
enum class ColumnType {
  kInteger,
  kNumber,  ///< always with point or exponent; `nan` where there is no value
  kText,
};

struct Column {
  std::string name;
  ColumnType type = ColumnType::kText;
};

/// One row a run: what was varied, how it went, and the command that repeats it.
struct Results {
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< one text a column
};

/// @param verdicts  of the sweep's rows, in order
[[nodiscard]] Results results_of(const Sweep& sweep, const std::vector<run::Verdict>& verdicts);

/// As RFC 4180 has it: one header line, lines end with CR LF, quotes where they are needed.
[[nodiscard]] std::string to_csv(const Results& results);

/// An array of objects; `nan` becomes null.
[[nodiscard]] std::string to_json(const Results& results);

/// `surefoot run FILE --set ...`, quoted for a shell: that row alone, to the last bit.
[[nodiscard]] std::string command_of(const Sweep& sweep, std::size_t row);

/// Text as one word of a POSIX shell.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace surefoot::sweep
