#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/doctor/report.hpp"

namespace surefoot::doctor {
namespace {

using ::testing::HasSubstr;

const Check kRoom{"run folders", Purpose::kLockstepRun, ok("9 MiB free")};
const Check kNoRoom{"run folders", Purpose::kLockstepRun, missing("not writable", "cd elsewhere")};
const Check kLittleRoom{"run folders", Purpose::kLockstepRun, warning("little", "rm -r runs")};
const Check kNoVcan{"vcan", Purpose::kTwoPrograms, missing("none", "sudo modprobe vcan")};
const Check kGovernor{"governor", Purpose::kWallClock, warning("powersave", "echo performance")};

TEST(DoctorExitCode, IsThatOfTheRequiredChecksAlone) {
  EXPECT_EQ(exit_code_of({}), run::ExitCode::kVerdictHolds);
  EXPECT_EQ(exit_code_of({kRoom, kNoVcan, kGovernor}), run::ExitCode::kVerdictHolds);
  EXPECT_EQ(exit_code_of({kLittleRoom}), run::ExitCode::kVerdictHolds);
  EXPECT_EQ(exit_code_of({kNoVcan, kNoRoom}), run::ExitCode::kMachineLacks);
}

TEST(DoctorText, GroupsByPurposeAndPutsTheRemedyBelowEachLineThatIsNotOk) {
  EXPECT_EQ(to_text({kGovernor, kRoom, kNoVcan}),
            "Required for surefoot run\n"
            "  OK       run folders  9 MiB free\n"
            "Optional: firmware and robot as two programs on a CAN bus\n"
            "  MISSING  vcan         none\n"
            "           remedy: sudo modprobe vcan\n"
            "Optional: the loop on the wall clock, every millisecond\n"
            "  WARN     governor     powersave\n"
            "           remedy: echo performance\n"
            "What surefoot run needs is here; optional: 1 missing, 1 to improve\n");
}

TEST(DoctorText, SaysWhatSurefootRunLacks) {
  EXPECT_THAT(to_text({kNoRoom, kNoVcan}), HasSubstr("\nsurefoot run lacks 1 of what it needs; optional: 1 missing"));
}

TEST(DoctorJson, HoldsTheSameForPrograms) {
  const auto json = nlohmann::json::parse(to_json({kRoom, kNoVcan}));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0], (nlohmann::json{{"check", "run folders"},
                                     {"purpose", "lockstep"},
                                     {"required", true},
                                     {"status", "ok"},
                                     {"detail", "9 MiB free"},
                                     {"remedy", ""}}));
  EXPECT_EQ(json[1]["status"], "missing");
  EXPECT_EQ(json[1]["required"], false);
  EXPECT_EQ(json[1]["remedy"], "sudo modprobe vcan");
}

TEST(DoctorJson, SurvivesWhatOtherProgramsSayInOtherEncodings) {
  const Check latin1{"vcan", Purpose::kTwoPrograms, missing("ung\xFCltig", "try")};
  EXPECT_EQ(nlohmann::json::parse(to_json({latin1}))[0]["detail"], "ung\xEF\xBF\xBDltig");  // U+FFFD
}

}  // namespace
}  // namespace surefoot::doctor
