#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace surefoot::scenario {

/// Whether a value is a string that `--set` takes without quotes where it is no TOML: "off", "step-2".
[[nodiscard]] inline bool is_bare_word(std::string_view text) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto belongs = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; };
  return !text.empty() && is_letter(text.front()) && std::all_of(text.begin(), text.end(), belongs);
}

}  // namespace surefoot::scenario
