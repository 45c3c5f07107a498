#include "tools/bench/relayed_loop.hpp"

#include <array>

#include "tools/bench/stopwatch.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::bench {
namespace {

constexpr std::size_t kBatchFrames = 32;

/// Takes what waits at one end; it passes it on to the other end, if there is one.
std::vector<can::CanFrame> pass(can::CanBus& from, can::CanBus* to) {
  std::vector<can::CanFrame> frames(kBatchFrames);
  frames.resize(from.receive(frames));
  if (to != nullptr) static_cast<void>(to->send(frames));
  return frames;
}

using Scratch = std::array<can::CanFrame, kBatchFrames>;

void drop(can::CanBus& bus, Scratch& scratch) noexcept { static_cast<void>(bus.receive(scratch)); }

}  // namespace

RelayedLoop::RelayedLoop(const scenario::Scenario& scenario)
    : sim_(scenario.sim), firmware_(scenario.firmware), robot_(scenario.sim, run::standing_pose(scenario.firmware)) {}

void RelayedLoop::run_to(std::int64_t tick) {
  while (firmware_.next_tick() < tick) cycle();
}

void RelayedLoop::keep_ticks(std::int64_t count) {
  firmware_before_ = std::make_unique<host::FirmwareNode>(firmware_);
  firmware_bus_before_ = std::make_unique<host::MemoryBus>(firmware_bus_, nullptr);
  robot_before_ = robot_.branch(sim_);
  kept_.clear();
  for (std::int64_t tick = 0; tick < count; ++tick) kept_.push_back(cycle());
}

TickFrames RelayedLoop::cycle() {
  TickFrames frames;
  firmware_.begin_tick(firmware_bus_.controller_end());
  frames.sync = pass(firmware_bus_.robot_end(), &robot_bus_.controller_end());
  robot_.serve(robot_bus_.robot_end());
  frames.answers = pass(robot_bus_.controller_end(), &firmware_bus_.robot_end());
  static_cast<void>(firmware_.collect(firmware_bus_.controller_end()));
  output_ = &firmware_.finish_tick(firmware_bus_.controller_end());
  frames.commands = pass(firmware_bus_.robot_end(), &robot_bus_.controller_end());
  robot_.serve(robot_bus_.robot_end());
  frames.later = pass(robot_bus_.controller_end(), &firmware_bus_.robot_end());
  return frames;
}

double RelayedLoop::firmware_us() const {
  host::FirmwareNode firmware(*firmware_before_);
  host::MemoryBus bus(*firmware_bus_before_, nullptr);
  Scratch scratch;
  const double start_us = cpu_us();
  for (const TickFrames& frames : kept_) {
    firmware.begin_tick(bus.controller_end());
    drop(bus.robot_end(), scratch);
    static_cast<void>(bus.robot_end().send(frames.answers));
    static_cast<void>(firmware.collect(bus.controller_end()));
    keep(firmware.finish_tick(bus.controller_end()));
    drop(bus.robot_end(), scratch);
    static_cast<void>(bus.robot_end().send(frames.later));
  }
  return cpu_us() - start_us;
}

double RelayedLoop::robot_us() const {
  const std::unique_ptr<sim_hw::SimulatedRobot> robot = robot_before_->branch(sim_);
  host::MemoryBus bus;
  Scratch scratch;
  const double start_us = cpu_us();
  for (const TickFrames& frames : kept_) {
    static_cast<void>(bus.controller_end().send(frames.sync));
    robot->serve(bus.robot_end());
    drop(bus.controller_end(), scratch);
    static_cast<void>(bus.controller_end().send(frames.commands));
    robot->serve(bus.robot_end());
    drop(bus.controller_end(), scratch);
  }
  return cpu_us() - start_us;
}

}  // namespace surefoot::bench
