#pragma once

#include <string>
#include <string_view>

#include "tools/doctor/check.hpp"
#include "tools/doctor/outcome.hpp"

namespace surefoot::doctor {

/// The interface that an IPv4 packet leaves by: longest prefix, then lowest metric.
///
/// @param route_table  text of /proc/net/route
/// @param destination  in host byte order
/// @return empty when there is no route
[[nodiscard]] std::string interface_towards(std::string_view route_table, std::uint32_t destination);

/// @param interface    that multicast leaves by, empty: none
/// @param is_lo_ready  lo is up and carries multicast
[[nodiscard]] Finding judge_multicast_route(const std::string& interface, bool is_lo_ready);

/// @param self_test  one message published and received over LCM
[[nodiscard]] Finding judge_lcm(const Outcome& self_test);

/// @param self_test  one frame sent and received over the UDP bus
[[nodiscard]] Finding judge_udp_bus(const Outcome& self_test);

}  // namespace surefoot::doctor
