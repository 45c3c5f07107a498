#include "firmware/host/allocation_guard.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

namespace surefoot::host::allocation_guard {
namespace {

/// Hides a pointer from the optimiser, which otherwise removes paired allocations.
template <typename T>
T* kept(T* pointer) {
  asm volatile("" : "+r"(pointer) : : "memory");
  return pointer;
}

class AllocationGuard : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!is_available()) GTEST_SKIP() << "a sanitizer owns malloc";
  }
};

TEST_F(AllocationGuard, SeesEachFunctionOfTheMallocFamilyOnce) {
  const auto allocations_of = [](auto allocate) {
    arm();
    void* const memory = kept(static_cast<void*>(allocate()));
    const Counts counts = disarm();
    std::free(memory);
    return counts.allocations;
  };
  EXPECT_EQ(allocations_of([] { return std::malloc(10); }), 1U);
  EXPECT_EQ(allocations_of([] { return std::calloc(3, 10); }), 1U);
  EXPECT_EQ(allocations_of([] { return std::realloc(nullptr, 10); }), 1U);
  EXPECT_EQ(allocations_of([] { return std::aligned_alloc(64, 128); }), 1U);
  EXPECT_EQ(allocations_of([] {
              void* memory = nullptr;
              return ::posix_memalign(&memory, 64, 128) == 0 ? memory : nullptr;
            }),
            1U);
}

TEST_F(AllocationGuard, SeesOperatorNewAndDeleteInsideTheStandardLibrary) {
  arm();
  delete kept(new int(1));
  EXPECT_EQ(disarm().allocations, 1U);

  std::vector<int> grown(4);
  arm();
  grown.resize(1000);
  const Counts growth = disarm();
  EXPECT_EQ(growth.allocations, 1U);
  EXPECT_EQ(growth.frees, 1U);

  // Lives in libstdc++.so: a wrapped symbol in our own objects would not see it.
  std::string text(100, 'x');
  arm();
  text.append(1000, 'y');
  EXPECT_EQ(disarm().allocations, 1U);
}

TEST_F(AllocationGuard, DoesNotSeeWhatCameBeforeOrAfter) {
  std::free(kept(std::malloc(10)));
  arm();
  disarm();
  std::free(kept(std::malloc(10)));
  arm();
  const Counts nothing = disarm();
  EXPECT_EQ(nothing.allocations, 0U);
  EXPECT_EQ(nothing.frees, 0U);
}

TEST_F(AllocationGuard, DoesNotSeeOtherThreads) {
  std::atomic<int> turn{0};
  std::thread other([&turn] {
    while (turn != 1) std::this_thread::yield();
    for (int i = 0; i < 100; ++i) std::free(kept(std::malloc(10)));
    turn = 2;
  });
  arm();
  turn = 1;
  while (turn != 2) std::this_thread::yield();
  const Counts nothing = disarm();
  other.join();
  EXPECT_EQ(nothing.allocations, 0U);
  EXPECT_EQ(nothing.frees, 0U);
}

TEST_F(AllocationGuard, MemoryIsUsableAndAlignedAndBadAlignmentIsRefused) {
  void* memory = nullptr;
  ASSERT_EQ(::posix_memalign(&memory, 4096, 100), 0);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory) % 4096, 0U);
  std::free(memory);
  EXPECT_EQ(::posix_memalign(&memory, 24, 100), EINVAL);
  const auto* const zeros = static_cast<char*>(kept(std::calloc(1000, 1)));
  EXPECT_EQ(std::string(zeros, 1000), std::string(1000, '\0'));
  std::free(const_cast<char*>(zeros));
}

}  // namespace
}  // namespace surefoot::host::allocation_guard
