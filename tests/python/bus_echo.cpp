// Opens a bus as the firmware does and answers each frame with its mirror image, for tests in other languages:
// identifier + 1, payload backwards. Says "ready" once it listens; ends with standard input, and prints its totals.
//
// Usage: bus_echo ADDRESS
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <span>

#include "firmware/host/bus/bus_address.hpp"

namespace {

using surefoot::host::BusReport;
using surefoot::host::HostBus;

constexpr std::int64_t kStepNs = 10'000'000;

std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

bool input_has_ended() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return ::poll(&input, 1, 0) > 0;
}

void answer(HostBus& bus) {
  std::array<surefoot::can::CanFrame, 64> frames{};
  const std::span received = std::span(frames).first(bus.receive(frames));
  for (surefoot::can::CanFrame& frame : received) {
    ++frame.identifier;
    std::reverse(frame.payload.begin(), frame.payload.begin() + frame.length);
  }
  bus.send(received);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 2) return 64;
  const auto bus = surefoot::host::open_bus(arguments[1], surefoot::host::BusRole::kEverything);
  std::puts("ready");
  std::fflush(stdout);
  while (!input_has_ended()) {
    if (bus->wait_readable(now_ns() + kStepNs)) answer(*bus);
  }
  const BusReport report = bus->report();
  fmt::print("sent {} received {} foreign_shape {} error_frames {}\n", report.sent, report.received,
             report.foreign_shape, report.error_frames);
  return 0;
} catch (const surefoot::host::BusError& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 69;
}
