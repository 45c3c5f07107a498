#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/doctor/realtime_checks.hpp"

namespace surefoot::doctor {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kDebian = "#1 SMP PREEMPT_DYNAMIC Debian 6.1.140-1 (2025-05-22)";

TEST(DoctorRights, AreJudgedEachByItsOwnName) {
  const host::MissingRights rights{{"SCHED_FIFO priority 80", "not permitted", "setcap"}};
  const Finding priority = judge_right(rights, "SCHED_FIFO", "granted");
  EXPECT_EQ(priority.status, Status::kMissing);
  EXPECT_EQ(priority.detail, "not permitted");
  EXPECT_EQ(priority.remedy, "setcap");
  EXPECT_EQ(judge_right(rights, "all memory locked", "granted").status, Status::kOk);
}

TEST(DoctorThrottling, LeavesALoopHalfAProcessorOrMore) {
  EXPECT_THAT(judge_throttling("950000", "1000000").detail, HasSubstr("95 %"));
  EXPECT_EQ(judge_throttling("950000", "1000000").status, Status::kOk);
  EXPECT_EQ(judge_throttling("-1", "1000000").status, Status::kOk);
  EXPECT_EQ(judge_throttling("", "").status, Status::kOk);
  for (const char* little : {"0", "100000", "499999"}) {
    const Finding finding = judge_throttling(little, "1000000");
    EXPECT_EQ(finding.status, Status::kWarning) << little;
    EXPECT_THAT(finding.remedy, StartsWith("sudo sysctl -w kernel.sched_rt_runtime_us="));
  }
}

TEST(DoctorThrottling, DoesNotDivideByWhatItCannotRead) {
  EXPECT_EQ(judge_throttling("950000", "0").status, Status::kWarning);
  EXPECT_EQ(judge_throttling("much", "1000000").status, Status::kWarning);
  EXPECT_EQ(judge_throttling("950000", "").status, Status::kWarning);
}

// PREEMPT is the begin of the two others: a search for text alone would take all three for the same.
TEST(DoctorPreemption, TellsTheThreeKindsApart) {
  EXPECT_EQ(judge_preemption("#1 SMP PREEMPT_RT Debian 6.1.140-1", "", "").detail, "PREEMPT_RT");
  EXPECT_EQ(judge_preemption("#1 SMP PREEMPT Mon", "", "").status, Status::kOk);
  EXPECT_EQ(judge_preemption(kDebian, "", "").status, Status::kWarning);
  const Finding none = judge_preemption("#1 SMP Mon", "", "");
  EXPECT_EQ(none.status, Status::kWarning);
  EXPECT_THAT(none.remedy, HasSubstr("linux-image-rt-amd64"));
}

TEST(DoctorPreemption, DynamicIsAsGoodAsItsMode) {
  EXPECT_EQ(judge_preemption(kDebian, "none voluntary (full)", "").status, Status::kOk);
  const Finding voluntary = judge_preemption(kDebian, "none (voluntary) full", "quiet preempt=full");
  EXPECT_EQ(voluntary.status, Status::kWarning) << "it was changed since the start";
  EXPECT_THAT(voluntary.detail, HasSubstr("none (voluntary) full"));
}

// Otherwise an ordinary user who follows the remedy is warned for ever.
TEST(DoctorPreemption, WithoutTheRightToReadTheModeTheCommandLineDecides) {
  EXPECT_EQ(judge_preemption(kDebian, "", "ro quiet preempt=full").status, Status::kOk);
  EXPECT_EQ(judge_preemption(kDebian, "", "ro quiet preempt=fullest").status, Status::kWarning);
  EXPECT_THAT(judge_preemption(kDebian, "", "ro quiet").remedy, HasSubstr("preempt=full"));
}

TEST(DoctorGovernor, WarnsWhenAnyProcessorSavesEnergy) {
  EXPECT_EQ(judge_governor({}).status, Status::kOk);
  EXPECT_EQ(judge_governor({"performance", "performance"}).status, Status::kOk);
  const Finding mixed = judge_governor({"performance", "powersave", "performance"});
  EXPECT_EQ(mixed.status, Status::kWarning);
  EXPECT_THAT(mixed.detail, StartsWith("performance, powersave:"));
  EXPECT_THAT(mixed.remedy, StartsWith("echo performance | sudo tee "));
}

TEST(DoctorIsolation, IsAskedForWhereThereIsAProcessorToSpare) {
  EXPECT_EQ(judge_isolation("2-3", 4).status, Status::kOk);
  EXPECT_EQ(judge_isolation("", 1).status, Status::kOk);
  EXPECT_THAT(judge_isolation("", 4).remedy, HasSubstr("isolcpus=3 "));
}

TEST(DoctorClockSource, WarnsOfThoseThatAreReadSlowly) {
  for (const char* fast : {"tsc", "kvm-clock", "arch_sys_counter", ""}) {
    EXPECT_EQ(judge_clock_source(fast, "tsc hpet").status, Status::kOk) << fast;
  }
  EXPECT_THAT(judge_clock_source("hpet", "tsc hpet acpi_pm").remedy, StartsWith("echo tsc | sudo tee "));
  EXPECT_THAT(judge_clock_source("acpi_pm", "hpet acpi_pm").remedy, HasSubstr("tsc=reliable"));
}

TEST(DoctorTimers, OfJiffiesCannotMeetATick) {
  EXPECT_EQ(judge_timers(1).status, Status::kOk);
  const Finding jiffies = judge_timers(4'000'000);
  EXPECT_EQ(jiffies.status, Status::kMissing);
  EXPECT_THAT(jiffies.detail, HasSubstr("4000 us"));
}

TEST(DoctorHardware, AHypervisorIsReadFromTheFlagsAlone) {
  EXPECT_EQ(judge_hardware("processor : 0\nflags\t\t: fpu tsc hypervisor\nbogomips : 1\n").status, Status::kWarning);
  EXPECT_EQ(judge_hardware("processor : 0\nflags\t\t: fpu tsc\nmodel name : hypervisor \n").status, Status::kOk);
  EXPECT_EQ(judge_hardware("").status, Status::kOk);
}

}  // namespace
}  // namespace surefoot::doctor
