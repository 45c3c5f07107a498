// Lockstep of two processes over a bus: 8 frames of 48 bytes there, 8 back, and again. A figure, no pass or fail.
//
// Usage: bus_ping_pong ADDRESS [EXCHANGES], e.g.
//   tools/with-vcan build/release/tests/bench/bus_ping_pong socketcan:vcan0
//   tools/with-vcan chrt -f 20 build/release/tests/bench/bus_ping_pong socketcan:vcan0
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <span>

#include "firmware/host/bus/bus_address.hpp"

namespace {

using surefoot::can::CanFrame;
using surefoot::host::HostBus;

constexpr std::size_t kFrames = 8;
constexpr std::int64_t kGiveUpNs = 5'000'000'000;

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

bool send(HostBus& bus) {
  std::array<CanFrame, kFrames> frames{};
  for (std::size_t i = 0; i < kFrames; ++i)
    frames[i] = {.identifier = static_cast<std::uint16_t>(0x181 + i), .length = 48};
  return bus.send(frames) == kFrames;
}

bool receive(HostBus& bus) {
  std::array<CanFrame, kFrames> frames{};
  std::size_t count = 0;
  const std::int64_t give_up_ns = now_ns() + kGiveUpNs;
  while (count < kFrames) {
    if (!bus.wait_readable(give_up_ns)) return false;
    count += bus.receive(std::span(frames).subspan(count));
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) return 64;
  const long exchanges = count > 2 ? std::atol(arguments[2]) : 20'000;
  const auto ping = surefoot::host::open_bus(arguments[1], surefoot::host::BusRole::kEverything);
  const auto pong = surefoot::host::open_bus(arguments[1], surefoot::host::BusRole::kEverything);
  const pid_t child = ::fork();
  bool is_whole = true;
  const std::int64_t start_ns = now_ns();
  for (long i = 0; i < exchanges && is_whole; ++i) {
    is_whole = child == 0 ? receive(*pong) && send(*pong) : send(*ping) && receive(*ping);
  }
  const double seconds = static_cast<double>(now_ns() - start_ns) * 1e-9;
  if (child == 0) ::_exit(is_whole ? 0 : 70);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!is_whole || status != 0) {
    fmt::print(stderr, "{}: frames were lost\n", arguments[1]);
    return 70;
  }
  fmt::print("{}: {:.0f} exchanges/s ({} of {} x 48 bytes each way)\n", arguments[1],
             static_cast<double>(exchanges) / seconds, exchanges, kFrames);
  return 0;
} catch (const surefoot::host::BusError& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 69;
}
