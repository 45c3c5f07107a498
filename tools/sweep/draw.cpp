#include "tools/sweep/draw.hpp"

#include <algorithm>

#include "sim_hw/faults/fault_random.hpp"

namespace surefoot::sweep {

std::uint64_t draw(std::uint64_t seed, std::string_view key, std::uint64_t number) noexcept {
  std::uint64_t stream = 0xCBF29CE484222325ULL;
  for (const char c : key) stream = (stream ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  using Random = sim_hw::FaultRandom;
  return Random::mixed(Random::mixed(Random::mixed(seed) ^ stream) ^ number);
}

double uniform(std::uint64_t draw, double min, double max) noexcept {
  const double share = sim_hw::FaultRandom::uniform(draw);
  return std::clamp(min + share * (max - min), min, max);  // rounding must not leave the range
}

std::int64_t uniform_integer(std::uint64_t draw, std::int64_t min, std::int64_t max) noexcept {
  const std::uint64_t count = static_cast<std::uint64_t>(max) - static_cast<std::uint64_t>(min) + 1;
  const std::uint64_t offset = count == 0 ? draw : draw % count;  // biased by less than count / 2^64
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(min) + offset);
}

}  // namespace surefoot::sweep
