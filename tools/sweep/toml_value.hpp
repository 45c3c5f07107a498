#pragma once

#include <toml++/toml.h>

#include <string>

namespace surefoot::sweep {

/// A value as `--set` takes it, in one line; doubles in the shortest form that reads back to the same bits.
///
/// @param is_number  integers become floats: a column of a table holds one type
[[nodiscard]] std::string value_text(const toml::node& node, bool is_number);

}  // namespace surefoot::sweep
