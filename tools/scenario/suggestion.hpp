#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace surefoot::scenario {

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment). Cost: a.size() times b.size().
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known key that an unknown one was probably meant to be, or an empty string. A key counts as
/// near when a few characters differ, when the table is missing or wrong before the right name, or
/// when it breaks off early ("servo.kp" for "servo.kp_nm_per_rad").
[[nodiscard]] std::string nearest_key(std::string_view unknown, std::span<const std::string> known);

}  // namespace surefoot::scenario
