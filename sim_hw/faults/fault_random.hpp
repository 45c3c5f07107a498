#pragma once

#include <cstdint>
#include <span>

#include "sim_hw/faults/fault_config.hpp"

namespace surefoot::sim_hw {

/// Random numbers of one fault, without memory: each is a function of the seed, of the fault and of what it is
/// drawn for. Nothing that other faults do to the traffic moves them.
class FaultRandom {
 public:
  FaultRandom() noexcept = default;
  FaultRandom(std::uint64_t seed, std::uint64_t stream) noexcept : key_(mixed(mixed(seed) ^ stream)) {}

  /// @param period   control period
  /// @param what     identifier and direction of a frame, or a measurement
  /// @param ordinal  how many of those the period has had before
  [[nodiscard]] std::uint64_t draw(std::int64_t period, std::uint32_t what, std::uint32_t ordinal) const noexcept {
    const auto place = (std::uint64_t{what} << 32U) | ordinal;
    return mixed(mixed(key_ ^ static_cast<std::uint64_t>(period)) ^ place);
  }

  /// Finaliser of SplitMix64 (Steele, Lea, Flood 2014) after its increment: every input bit reaches every output bit.
  [[nodiscard]] static constexpr std::uint64_t mixed(std::uint64_t value) noexcept {
    value += 0x9E3779B97F4A7C15ULL;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBULL;
    return value ^ (value >> 31U);
  }

  /// In [0, 1).
  [[nodiscard]] static constexpr double uniform(std::uint64_t draw) noexcept {
    return static_cast<double>(draw >> 11U) * 0x1p-53;
  }

 private:
  std::uint64_t key_ = 0;
};

/// Stream of the fault at `place`: of what it is, and how many equal ones stand before it. Faults of other kinds
/// or times may come and go around it.
[[nodiscard]] std::uint64_t fault_stream(std::span<const FaultConfig> faults, std::size_t place) noexcept;

}  // namespace surefoot::sim_hw
