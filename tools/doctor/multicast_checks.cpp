#include "tools/doctor/multicast_checks.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <iomanip>
#include <sstream>

namespace surefoot::doctor {
namespace {

constexpr const char* kOverLoopback = "sudo sh -c 'ip link set lo up multicast on && ip route add 224.0.0.0/4 dev lo'";

constexpr unsigned kRouteIsUp = 0x1;       // RTF_UP
constexpr unsigned kRouteRejects = 0x200;  // RTF_REJECT

/// The table gives addresses as the hexadecimal number that their four bytes are in memory.
std::uint32_t host_order(std::uint32_t from_table) {
  return std::endian::native == std::endian::little ? __builtin_bswap32(from_table) : from_table;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

std::string interface_towards(std::string_view route_table, std::uint32_t destination) {
  std::istringstream lines{std::string(route_table)};
  std::string line;
  std::string best;
  std::uint32_t best_mask = 0;
  std::uint32_t best_metric = 0;
  while (std::getline(lines, line)) {
    std::istringstream columns(line);
    std::string interface;
    std::uint32_t network = 0, gateway = 0, flags = 0, references = 0, uses = 0, metric = 0, mask = 0;
    columns >> interface >> std::hex >> network >> gateway >> flags >> std::dec >> references >> uses >> metric >>
        std::hex >> mask;
    if (!columns || (flags & kRouteIsUp) == 0) continue;  // the head, too
    mask = host_order(mask);
    if ((destination & mask) != host_order(network)) continue;
    if (!best.empty() && (mask < best_mask || (mask == best_mask && metric >= best_metric))) continue;
    best = (flags & kRouteRejects) != 0 ? "" : interface;
    best_mask = mask;
    best_metric = metric;
  }
  return best;
}

Finding judge_multicast_route(const std::string& interface, bool is_lo_ready) {
  if (interface == "lo" && is_lo_ready) return ok("over lo");
  if (interface == "lo") return warning("over lo, which is down or carries no multicast", kOverLoopback);
  if (interface.empty()) return missing("there is none", kOverLoopback);
  return warning(
      fmt::format("over {}: python-can does not reach the UDP bus on lo, and LCM ends with that link", interface),
      kOverLoopback);
}

Finding judge_lcm(const Outcome& self_test) {
  if (self_test.is_success()) return ok("a message was published and received (udpm, ttl 0)");
  const std::string said = first_line(self_test.output);
  return missing(fmt::format("a message was published and not received{}{}", said.empty() ? "" : ": ", said),
                 kOverLoopback);
}

Finding judge_udp_bus(const Outcome& self_test) {
  if (self_test.is_success()) return ok("a frame was sent and received (udp multicast on lo)");
  const std::string said = first_line(self_test.output);
  return missing(fmt::format("a frame was sent and not received{}{}", said.empty() ? "" : ": ", said),
                 "sudo ip link set lo up");
}

}  // namespace surefoot::doctor
