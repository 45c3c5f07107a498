// Rights belong to threads and processes, so each test works in a child process that it may spoil.
#include "firmware/host/realtime/realtime_rights.hpp"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <cstdio>
#include <thread>

#include "tests/unit/firmware_host/child_process.hpp"

namespace surefoot::host {
namespace {

/// An ordinary user with no real-time limits at all.
void give_up_every_right() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_RTPRIO, &none);
  setrlimit(RLIMIT_MEMLOCK, &none);
  become_nobody();
}

bool is_named_once(const MissingRights& missing, const std::string& what, const std::string& remedy) {
  int times = 0;
  for (const MissingRight& right : missing) {
    if (right.what.find(what) == std::string::npos) continue;
    if (right.why.empty() || right.remedy.find(remedy) == std::string::npos) return false;
    ++times;
  }
  return times == 1;
}

bool say(const MissingRights& missing, bool holds) {
  if (!holds) std::printf("%s", to_text(missing).c_str());
  return holds;
}

TEST(RealtimeRights, WithoutAnyEachIsNamedOnceWithTheCommandThatGrantsItAndNothingThrows) {
  EXPECT_TRUE(holds_in_a_child([] {
    give_up_every_right();
    const RealtimeRights rights(
        RealtimeRequest{.fifo_priority = 80, .cpu = 100'000, .keep_cpu_awake = true, .memory = {}});
    const MissingRights& missing = rights.missing();
    return say(missing,
               is_named_once(missing, "SCHED_FIFO priority 80", "sudo setcap cap_sys_nice,cap_ipc_lock=ep /") &&
                   is_named_once(missing, "SCHED_FIFO", "sudo chrt -f 80") &&
                   is_named_once(missing, "processor 100000", "taskset") &&
                   is_named_once(missing, "/dev/cpu_dma_latency", ""));
  }));
}

TEST(RealtimeRights, NothingIsMissedThatWasNotAskedFor) {
  EXPECT_TRUE(holds_in_a_child([] {
    give_up_every_right();
    const RealtimeRequest nothing{.fifo_priority = 0,
                                  .cpu = RealtimeRequest::kAnyCpu,
                                  .keep_cpu_awake = false,
                                  .memory = {.lock_all = false, .stack_prefault_bytes = 0, .heap_reserve_bytes = 0}};
    const RealtimeRights rights(nothing);
    return say(rights.missing(), rights.missing().empty() && sched_getscheduler(0) == SCHED_OTHER);
  }));
}

// What the machine grants differs; that what was not reported as missing is in force may not.
TEST(RealtimeRights, WhatIsNotReportedAsMissingIsInForce) {
  EXPECT_TRUE(holds_in_a_child([] {
    cpu_set_t allowed;
    sched_getaffinity(0, sizeof allowed, &allowed);
    int last = 0;
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) last = CPU_ISSET(static_cast<unsigned>(cpu), &allowed) ? cpu : last;
    const RealtimeRights rights(
        {.fifo_priority = 17, .cpu = last, .keep_cpu_awake = false, .memory = {.lock_all = false}});
    bool is_missing_priority = false;
    for (const MissingRight& right : rights.missing()) is_missing_priority |= right.what.starts_with("SCHED_FIFO");
    sched_param parameters{};
    sched_getparam(0, &parameters);
    sched_getaffinity(0, sizeof allowed, &allowed);
    const bool has_priority =
        (sched_getscheduler(0) & ~SCHED_RESET_ON_FORK) == SCHED_FIFO && parameters.sched_priority == 17;
    return say(rights.missing(), has_priority != is_missing_priority && CPU_COUNT(&allowed) == 1 &&
                                     CPU_ISSET(static_cast<unsigned>(last), &allowed));
  }));
}

// The recorder's thread at the loop's priority would compete with it.
TEST(RealtimeRights, ThreadsStartedLaterAreOrdinary) {
  EXPECT_TRUE(holds_in_a_child([] {
    const RealtimeRights rights(
        {.fifo_priority = 17, .cpu = -1, .keep_cpu_awake = false, .memory = {.lock_all = false}});
    int policy = -1;
    std::thread([&] { policy = sched_getscheduler(0); }).join();
    return policy == SCHED_OTHER;
  }));
}

TEST(RealtimeRights, TimerSlackIsOneNanosecond) {
  EXPECT_TRUE(holds_in_a_child([] {
    give_up_every_right();
    const RealtimeRights rights(
        {.fifo_priority = 0, .cpu = -1, .keep_cpu_awake = false, .memory = {.lock_all = false}});
    return prctl(PR_GET_TIMERSLACK) == 1;
  }));
}

TEST(RealtimeRights, APriorityOutOfRangeIsAnsweredWithTheRange) {
  EXPECT_TRUE(holds_in_a_child([] {
    const RealtimeRights rights(
        {.fifo_priority = 100, .cpu = -1, .keep_cpu_awake = false, .memory = {.lock_all = false}});
    return say(rights.missing(), is_named_once(rights.missing(), "SCHED_FIFO priority 100", "1 to 99"));
  }));
}

}  // namespace
}  // namespace surefoot::host
