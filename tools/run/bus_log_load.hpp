#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "sim_hw/bus/frame_bits.hpp"

namespace surefoot::run {

/// What a candump -L log says of one interface, counted bit by bit.
struct LoggedLoad {
  std::uint64_t classic_frames = 0;
  std::uint64_t fd_frames = 0;
  std::uint64_t nominal_bits = 0;  ///< at the nominal bit rate, stuff bits and intermission included
  std::uint64_t data_bits = 0;     ///< at the data bit rate: of FD frames with bit rate switch
  std::int64_t first_us = 0;       ///< stamp of the first frame
  std::int64_t last_us = 0;        ///< stamp of the last

  [[nodiscard]] std::uint64_t busy_ns(sim_hw::BitTiming timing) const noexcept {
    return nominal_bits * timing.nominal_bit_ns + data_bits * timing.data_bit_ns;
  }
  [[nodiscard]] std::int64_t elapsed_ns() const noexcept { return (last_us - first_us) * 1000; }
  /// Over the time from the first frame to the last; 0 where that is none.
  [[nodiscard]] double load_percent(sim_hw::BitTiming timing) const noexcept {
    const std::int64_t elapsed = elapsed_ns();
    return elapsed <= 0 ? 0.0 : 100.0 * static_cast<double>(busy_ns(timing)) / static_cast<double>(elapsed);
  }
};

/// Reads a log with classic, remote and FD frames of 11-bit identifiers, of one or more interfaces. A last line
/// without an end is left out.
///
/// @return by the interface's name
/// @throws CandumpLogError when it cannot be read, or at a line that is none of these frames
[[nodiscard]] std::map<std::string, LoggedLoad> bus_log_load(const std::filesystem::path& log);

}  // namespace surefoot::run
