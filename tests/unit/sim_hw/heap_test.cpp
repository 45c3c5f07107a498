#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>

#include "tests/unit/sim_hw/standing.hpp"
#include "tests/unit/sim_hw/wire.hpp"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
std::atomic<bool> armed{false};
std::atomic<long> allocations{0};
}  // namespace

// Stands in front of the C library's malloc for the whole program, shared libraries included.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* old, std::size_t size);

void* malloc(std::size_t size) {
  if (armed.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* realloc(void* old, std::size_t size) {
  if (armed.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(old, size);
}
}

namespace surefoot::sim_hw {
namespace {

/// Allocations while a robot stands for 0.1 s and then loses its master.
long allocations_of(const SimConfig& config) {
  const PerSide<LegVector> pose = testing::stance(config.geometry);
  SimulatedRobot robot(config, pose);
  testing::Puppeteer puppeteer(robot);
  puppeteer.wire.from_robot.reserve(2048);
  allocations = 0;
  armed = true;
  for (int i = 0; i < 100; ++i) {
    puppeteer.sync();
    puppeteer.command(testing::hold(pose, {puppeteer.leg[0].angle_rad, puppeteer.leg[1].angle_rad},
                                    {puppeteer.leg[0].rate_rad_s, puppeteer.leg[1].rate_rad_s}));
  }
  for (int i = 0; i < 50; ++i) puppeteer.sync();  // watchdog and emergencies
  armed = false;
  EXPECT_EQ(robot.truth().payload_kg, 5.0);
  return allocations.load();
}

TEST(Heap, IsLeftAloneWhileTheRobotServes) {
  SimConfig config;
  config.payloads.push_back({.mass_kg = 5.0, .at_s = 0.02});
  EXPECT_EQ(allocations_of(config), 0);
}

TEST(Heap, IsLeftAloneByPushesAndByLoadsThatComeAndGo) {
  SimConfig config;
  config.payloads = {{.mass_kg = 2.0, .at_s = 0.01, .removed_at_s = 0.05}, {.mass_kg = 3.0, .at_s = 0.02}};
  config.pushes = {{.at_s = 0.03, .duration_s = 0.01, .force_n = {50.0, 0.0, 0.0}}};
  EXPECT_EQ(allocations_of(config), 0);
}

TEST(Heap, IsLeftAloneByARoughFloorAndFlexibleHips) {
  SimConfig config;
  config.payloads.push_back({.mass_kg = 5.0, .at_s = 0.02});
  config.terrain = {.tile_height_m = 0.004, .plates_per_m2 = 5.0, .patches = {PatchConfig{}}};
  config.drive.hip_roll_stiffness_nm_per_rad = 3000.0;
  EXPECT_EQ(allocations_of(config), 0);
}

TEST(Heap, IsLeftAloneByEveryKindOfFault) {
  for (std::size_t kind = 0; kind < kFaultKinds; ++kind) {
    SimConfig config;
    config.payloads.push_back({.mass_kg = 5.0, .at_s = 0.02});
    const auto of_kind = static_cast<FaultKind>(kind);
    const FaultTarget target = of_kind == FaultKind::kLinkDown ? FaultTarget::kBus : FaultTarget::kFootLeft;
    config.faults = {{.kind = of_kind, .target = target, .at_s = 0.03, .for_s = 0.05}};
    EXPECT_EQ(allocations_of(config), 0) << kind;
  }
}

TEST(Heap, GuardSeesAnAllocation) {
  allocations = 0;
  armed = true;
  void* volatile block = std::malloc(16);
  armed = false;
  std::free(block);
  EXPECT_EQ(allocations.load(), 1);
}

}  // namespace
}  // namespace surefoot::sim_hw

#endif
