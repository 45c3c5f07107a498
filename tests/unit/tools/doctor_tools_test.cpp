#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/doctor/tool_checks.hpp"

namespace surefoot::doctor {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
const Outcome kNotThere{127, ""};

TEST(DoctorRunSpace, IsMissingWithoutRoomForOneRunAndWarnsOfLittle) {
  EXPECT_EQ(judge_run_space({"/here", true, 99 * kMiB}).status, Status::kMissing);
  EXPECT_EQ(judge_run_space({"/here", true, 100 * kMiB}).status, Status::kWarning);
  EXPECT_EQ(judge_run_space({"/here", true, 1024 * kMiB}).status, Status::kOk);
  EXPECT_THAT(judge_run_space({"/here", true, 1024 * kMiB}).detail, HasSubstr("1024 MiB free in /here"));
}

TEST(DoctorRunSpace, InAFolderThatMayNotBeWrittenIsMissingHoweverLarge) {
  const Finding finding = judge_run_space({"/here", false, 9999 * kMiB});
  EXPECT_EQ(finding.status, Status::kMissing);
  EXPECT_THAT(finding.detail, HasSubstr("/here is not writable"));
}

TEST(DoctorPython, NamesTheModulesThatTheEnvironmentLacks) {
  EXPECT_EQ(judge_python({0, ""}).status, Status::kOk);
  EXPECT_THAT(judge_python({0, "can, lcm"}).detail, HasSubstr("no can, lcm"));
  EXPECT_EQ(judge_python(kNotThere).remedy, "tools/setup");
  // An environment whose interpreter has been replaced: set-up alone would take its stamp for good.
  EXPECT_EQ(judge_python({1, "Traceback"}).remedy, "rm -r .venv && tools/setup");
}

TEST(DoctorJava, SaysItsVersionThroughTheChatterOfVirtualMachines) {
  EXPECT_EQ(judge_java({0, "Picked up JAVA_TOOL_OPTIONS: -Xmx1g\nopenjdk version \"17.0.15\" 2025-04-15"}).detail,
            "17.0.15");
  EXPECT_EQ(judge_java({0, "something else"}).status, Status::kOk);
  EXPECT_EQ(judge_java(kNotThere).status, Status::kMissing);
  EXPECT_EQ(judge_java({1, "Error: could not create the Java Virtual Machine"}).status, Status::kMissing);
}

// lcm-spy of Debian 12 calls java with -Xincgc, which Java 9 removed (lcm-proj/lcm 241).
TEST(DoctorLcmSpy, StartsUnderJava8AloneAndTheRemedyForOthersIsItsOwnCommandLine) {
  EXPECT_EQ(judge_lcm_spy({}, ok("1.8.0_392")).status, Status::kOk);
  for (const char* version : {"9", "11.0.2", "17.0.15"}) {
    const Finding finding = judge_lcm_spy({}, ok(version));
    EXPECT_EQ(finding.status, Status::kWarning) << version;
    EXPECT_THAT(finding.remedy, HasSubstr("lcm.spy.Spy"));
  }
}

TEST(DoctorLcmSpy, LacksItsClassesOrJava) {
  EXPECT_THAT(judge_lcm_spy({"/a/lcm.jar"}, ok("17")).remedy, HasSubstr("liblcm-java libjchart2d-java"));
  EXPECT_EQ(judge_lcm_spy({}, missing("there is none", "install it")).remedy, "install it");
}

}  // namespace
}  // namespace surefoot::doctor
