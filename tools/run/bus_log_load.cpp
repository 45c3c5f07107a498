#include "tools/run/bus_log_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>

#include "sim_hw/bus/classic_bits.hpp"
#include "tools/run/candump_log.hpp"

namespace surefoot::run {
namespace {

constexpr std::size_t kIdentifierDigits = 3;  // 8 stand for 29 bits
constexpr unsigned kBitRateSwitch = 1;        // CANFD_BRS, in the digit after "##"

struct CountedFrame {
  std::string interface;
  std::int64_t stamp_us = 0;
  bool is_fd = false;
  sim_hw::FrameBits bits;
};

/// The length that "R8" asks for, or nothing where it is no remote frame.
std::optional<std::uint8_t> remote_length(const std::string& payload) {
  if (payload == "R") return std::uint8_t{0};
  if (payload.size() == 2 && payload[0] == 'R' && payload[1] >= '0' && payload[1] <= '8') {
    return static_cast<std::uint8_t>(payload[1] - '0');
  }
  return std::nullopt;
}

/// Whether the hexadecimal digit after "##" has the switch.
bool has_bit_rate_switch(char flags) { return (std::stoul(std::string(1, flags), nullptr, 16) & kBitRateSwitch) != 0; }

/// Nothing for a line that is no frame this model knows. A classic frame is read as candump would write an FD one.
std::optional<CountedFrame> count_line(const std::string& line) {
  const std::size_t interface_begin = line.find(") ");
  const std::size_t separator = line.find('#');
  if (interface_begin == std::string::npos || separator == std::string::npos || interface_begin > separator) {
    return std::nullopt;
  }
  if (separator - line.rfind(' ', separator) - 1 != kIdentifierDigits) return std::nullopt;
  CountedFrame counted;
  counted.is_fd = line.compare(separator, 2, "##") == 0;
  const std::string payload = line.substr(std::min(line.size(), separator + (counted.is_fd ? 3 : 1)));
  const std::optional<std::uint8_t> asked = counted.is_fd ? std::nullopt : remote_length(payload);
  const std::string as_fd = line.substr(0, separator) + "##0" + (asked ? "" : payload);
  std::optional<LoggedFrame> logged = parse_candump_line(as_fd);
  if (!logged || (!counted.is_fd && logged->frame.length > 8)) return std::nullopt;

  const std::size_t name_begin = interface_begin + 2;
  counted.interface = line.substr(name_begin, line.find(' ', name_begin) - name_begin);
  counted.stamp_us = logged->elapsed_us;
  if (counted.is_fd) {
    if (!std::isxdigit(static_cast<unsigned char>(line[separator + 2]))) return std::nullopt;
    counted.bits = sim_hw::frame_bits(logged->frame);
    if (!has_bit_rate_switch(line[separator + 2])) {
      counted.bits = {.nominal = counted.bits.nominal + counted.bits.data, .data = 0};
    }
  } else {
    logged->frame.length = asked.value_or(logged->frame.length);
    const auto kind = asked ? sim_hw::ClassicKind::kRemote : sim_hw::ClassicKind::kData;
    counted.bits.nominal = sim_hw::classic_frame_bits(logged->frame, kind);
  }
  return counted;
}

}  // namespace

std::map<std::string, LoggedLoad> bus_log_load(const std::filesystem::path& log) {
  std::ifstream file(log);
  if (!file || std::filesystem::is_directory(log)) {
    throw CandumpLogError(
        fmt::format("{}: cannot be read\n  remedy: give a log that candump -L or surefoot run wrote", log.string()));
  }
  std::map<std::string, LoggedLoad> loads;
  std::string line;
  for (std::uint64_t number = 1; std::getline(file, line) && !file.eof(); ++number) {
    const std::optional<CountedFrame> counted = count_line(line);
    if (!counted) {
      throw CandumpLogError(fmt::format(
          "{}:{}: is no frame with an 11-bit identifier in the format of candump -L\n"
          "  remedy: leave such lines out; frames with 29-bit identifiers and error frames are not modelled",
          log.string(), number));
    }
    const auto [place, is_new] = loads.try_emplace(counted->interface);
    LoggedLoad& load = place->second;
    if (is_new) load.first_us = load.last_us = counted->stamp_us;
    load.first_us = std::min(load.first_us, counted->stamp_us);
    load.last_us = std::max(load.last_us, counted->stamp_us);
    ++(counted->is_fd ? load.fd_frames : load.classic_frames);
    load.nominal_bits += counted->bits.nominal;
    load.data_bits += counted->bits.data;
  }
  if (loads.empty()) {
    throw CandumpLogError(
        fmt::format("{}: holds no frame\n  remedy: give a log that candump -L or surefoot run wrote", log.string()));
  }
  return loads;
}

}  // namespace surefoot::run
