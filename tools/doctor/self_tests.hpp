#pragma once

#include "tools/doctor/outcome.hpp"

namespace surefoot::doctor {

/// Publishes one LCM message on this machine's own provider (ttl 0) and waits up to 2 s for it.
[[nodiscard]] Outcome test_lcm();

/// Sends one frame over the UDP bus on loopback, on a port that no bus uses, and waits up to 2 s for it.
[[nodiscard]] Outcome test_udp_bus();

}  // namespace surefoot::doctor
