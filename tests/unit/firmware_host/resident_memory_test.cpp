// Locks and limits belong to the process, so each test works in a child process that it may spoil.
#include "firmware/host/realtime/resident_memory.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/realtime/resource_usage.hpp"
#include "tests/unit/firmware_host/child_process.hpp"

namespace surefoot::host {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

/// To so much, or to the less that the machine permits anyway.
void limit_locked_memory(rlim_t bytes) {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  limit.rlim_cur = limit.rlim_max = std::min(bytes, limit.rlim_max);
  if (setrlimit(RLIMIT_MEMLOCK, &limit) != 0) _exit(2);
  become_nobody();
}

[[gnu::noinline]] void use_stack(std::size_t bytes) {
  auto* memory = static_cast<volatile char*>(__builtin_alloca(bytes));
  for (std::size_t i = 0; i < bytes; i += 4096) memory[i] = 1;
}

std::int64_t faults_of_using_stack(std::size_t bytes) {
  const ResourceUsage before = thread_resource_usage();
  use_stack(bytes);
  return (thread_resource_usage() - before).minor_page_faults;
}

std::int64_t faults_of_using_heap(std::size_t bytes) {
  const ResourceUsage before = thread_resource_usage();
  auto* memory = static_cast<volatile char*>(std::malloc(bytes));
  for (std::size_t i = 0; i < bytes; i += 4096) memory[i] = 1;
  std::free(const_cast<char*>(memory));
  return (thread_resource_usage() - before).minor_page_faults;
}

/// A sanitizer has an allocator and a shadow of its own.
bool has_plain_memory() { return allocation_guard::is_available(); }

constexpr ResidentMemory kNothing{.lock_all = false, .stack_prefault_bytes = 0, .heap_reserve_bytes = 0};

TEST(ResidentMemory, AStackTouchedBeforehandCostsNoPageFaultLater) {
  if (!has_plain_memory()) GTEST_SKIP() << "a sanitizer owns the stack";
  ResidentMemory wanted = kNothing;
  wanted.stack_prefault_bytes = 2 * kMiB;
  EXPECT_TRUE(make_resident(wanted).empty());
  EXPECT_EQ(faults_of_using_stack(kMiB), 0);
}

TEST(ResidentMemory, AReservedHeapCostsNoPageFaultLater) {
  if (!has_plain_memory()) GTEST_SKIP() << "a sanitizer owns the heap";
  EXPECT_TRUE(holds_in_a_child([&] {
    ResidentMemory wanted = kNothing;
    wanted.heap_reserve_bytes = 16 * kMiB;
    const bool was_granted = make_resident(wanted).empty();
    // Twice: what is given back stays with the process.
    const std::int64_t faults = faults_of_using_heap(8 * kMiB) + faults_of_using_heap(8 * kMiB);
    return was_granted && faults <= 2;
  }));
}

TEST(ResidentMemory, AStackThatIsTooSmallIsNamedWithTheCommandThatEnlargesIt) {
  ResidentMemory wanted = kNothing;
  wanted.stack_prefault_bytes = std::size_t{1} << 40;
  rlimit limit{};
  getrlimit(RLIMIT_STACK, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) GTEST_SKIP() << "the stack has no limit";
  EXPECT_TRUE(holds_in_a_child([&] {
    const rlimit small{kMiB, kMiB};
    setrlimit(RLIMIT_STACK, &small);
    const MissingRights missing = make_resident(wanted);
    return missing.size() == 1 && missing[0].remedy == "ulimit -s 1073742848";
  }));
}

TEST(ResidentMemory, MemoryThatMayNotBeLockedIsNamedWithTheCommandThatAllowsIt) {
  if (!has_plain_memory()) GTEST_SKIP() << "a sanitizer pretends to lock";
  ResidentMemory wanted = kNothing;
  wanted.lock_all = true;
  EXPECT_TRUE(holds_in_a_child([&] {
    limit_locked_memory(0);
    const MissingRights missing = make_resident(wanted);
    const bool is_named = missing.size() == 1 && missing[0].what.starts_with("all memory locked") &&
                          missing[0].remedy.find("ulimit -l unlimited") != std::string::npos &&
                          missing[0].remedy.starts_with("sudo setcap ");
    return is_named;
  }));
}

// Locking the future under a limit is granted by the kernel, and then malloc fails in the middle of a walk.
TEST(ResidentMemory, UnderALimitOfLockedMemoryTheHeapCanStillGrow) {
  if (!has_plain_memory()) GTEST_SKIP() << "a sanitizer pretends to lock";
  ResidentMemory wanted = kNothing;
  wanted.lock_all = true;
  EXPECT_TRUE(holds_in_a_child([&] {
    limit_locked_memory(64 * kMiB);
    const MissingRights missing = make_resident(wanted);
    const std::unique_ptr<char, void (*)(void*)> grown(static_cast<char*>(std::malloc(256 * kMiB)), &std::free);
    return missing.size() == 1 && grown != nullptr;
  }));
}

}  // namespace
}  // namespace surefoot::host
