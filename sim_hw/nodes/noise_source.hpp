#pragma once

#include <cstdint>

namespace surefoot::sim_hw {

/// Seeded sensor noise, the same bits on every machine: PCG32 (O'Neill 2014, XSH-RR) and the sum of
/// twelve uniform numbers, which needs no logarithm. Its tails end at six standard deviations.
class NoiseSource {
 public:
  /// @param stream  different streams of one seed are independent; one for each node
  NoiseSource(std::uint64_t seed, std::uint64_t stream) noexcept : increment_((stream << 1U) | 1U) {
    (void)next();
    state_ += seed;
    (void)next();
  }

  /// Zero mean and the given standard deviation; a deviation of zero draws nothing.
  [[nodiscard]] double sample(double standard_deviation) noexcept {
    if (standard_deviation <= 0.0) return 0.0;
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(next()) * 0x1p-32;
    return standard_deviation * sum;
  }

 private:
  std::uint32_t next() noexcept {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment_;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto rotation = static_cast<std::uint32_t>(old >> 59U);
    return (mixed >> rotation) | (mixed << ((32U - rotation) & 31U));
  }

  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace surefoot::sim_hw
