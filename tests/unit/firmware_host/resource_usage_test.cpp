#include "firmware/host/realtime/resource_usage.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <ctime>
#include <latch>
#include <thread>

namespace surefoot::host {
namespace {

constexpr std::size_t kPages = 200;
constexpr std::size_t kPageBytes = 4096;

/// Maps pages of their own and touches each once.
void touch_fresh_pages() {
  void* pages = mmap(nullptr, kPages * kPageBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(pages, MAP_FAILED);
  madvise(pages, kPages * kPageBytes, MADV_NOHUGEPAGE);
  for (std::size_t i = 0; i < kPages; ++i) static_cast<volatile char*>(pages)[i * kPageBytes] = 1;
  munmap(pages, kPages * kPageBytes);
}

TEST(ResourceUsage, CountsOneMinorFaultForEachPageTouchedForTheFirstTime) {
  const ResourceUsage before = thread_resource_usage();
  touch_fresh_pages();
  EXPECT_GE((thread_resource_usage() - before).minor_page_faults, static_cast<std::int64_t>(kPages));
}

TEST(ResourceUsage, CountsEachWaitAsOneVoluntarySwitch) {
  const ResourceUsage before = thread_resource_usage();
  const timespec briefly{.tv_sec = 0, .tv_nsec = 100'000};
  for (int i = 0; i < 10; ++i) nanosleep(&briefly, nullptr);
  EXPECT_GE((thread_resource_usage() - before).voluntary_switches, 10);
}

// RUSAGE_SELF in its place would count the neighbour.
TEST(ResourceUsage, IsThatOfTheCallingThreadAlone) {
  std::latch has_begun{1};
  std::latch has_touched{1};
  std::jthread neighbour([&] {
    has_begun.wait();
    touch_fresh_pages();
    has_touched.count_down();
  });
  const ResourceUsage before = thread_resource_usage();
  has_begun.count_down();
  has_touched.wait();
  EXPECT_LT((thread_resource_usage() - before).minor_page_faults, static_cast<std::int64_t>(kPages));
}

TEST(ResourceUsage, DifferencesAreTakenFieldByField) {
  const ResourceUsage difference = ResourceUsage{10, 20, 30, 40} - ResourceUsage{1, 2, 3, 4};
  EXPECT_EQ(difference, (ResourceUsage{9, 18, 27, 36}));
}

}  // namespace
}  // namespace surefoot::host
