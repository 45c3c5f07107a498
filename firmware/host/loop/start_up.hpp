#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "firmware/host/bus/host_bus.hpp"
#include "firmware/host/loop/firmware_loop.hpp"

namespace surefoot::host {

/// The firmware may not start on this bus; the message says what stands there and the remedy.
class StartUpError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct StartUpConfig {
  LoopClock clock = LoopClock::kLockstep;     ///< a robot that keeps another one is refused
  std::int64_t listen_ns = 300'000'000;       ///< silence of another master before the first frame is sent
  std::int64_t patience_ns = 30'000'000'000;  ///< how long nodes are awaited
};

/// Before tick 0: listens whether another master drives this bus, then announces the controller
/// (heartbeat, pre-operational, ten times a second) until all five nodes have announced themselves in
/// the right protocol version. No joint can move meanwhile: there is no SYNC and no torque.
///
/// @param on_waiting  called once a second with the nodes that are still missing
/// @return false when `stop` was set
/// @throws StartUpError on another master, a foreign version, a robot with another clock, or nodes that do not come
[[nodiscard]] bool await_robot(FirmwareNode&, HostBus&, const StartUpConfig&, const std::atomic<bool>& stop,
                               const std::function<void(const std::string& missing)>& on_waiting);

}  // namespace surefoot::host
