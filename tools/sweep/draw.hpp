#pragma once

#include <cstdint>
#include <string_view>

namespace surefoot::sweep {

/// A random number without memory: a function of seed, key and number of the draw, so that draw k is the same
/// however many there are and whatever else is drawn.
///
/// SplitMix64's finaliser (Steele, Lea, Flood 2014) over FNV-1a of the key.
[[nodiscard]] std::uint64_t draw(std::uint64_t seed, std::string_view key, std::uint64_t number) noexcept;

/// Uniform in [min, max), or `min` when both are equal.
[[nodiscard]] double uniform(std::uint64_t draw, double min, double max) noexcept;

/// Uniform over min, min + 1, .. max; min <= max.
[[nodiscard]] std::int64_t uniform_integer(std::uint64_t draw, std::int64_t min, std::int64_t max) noexcept;

}  // namespace surefoot::sweep
