#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>

#include "tools/doctor/outcome.hpp"

namespace surefoot::doctor {
namespace {

TEST(DoctorOutcome, HoldsExitCodeAndBothOutputs) {
  const Outcome outcome = run_program({"sh", "-c", "echo out; echo err >&2; exit 3"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_EQ(outcome.output, "out\nerr");
  EXPECT_FALSE(outcome.is_success());
}

TEST(DoctorOutcome, OfAProgramThatIsNotThereIs127) { EXPECT_EQ(run_program({"/no/such/program"}).exit_code, 127); }

TEST(DoctorOutcome, ArgumentsReachTheProgramAsTheyAre) {
  EXPECT_EQ(run_program({"printf", "%s|", "two words", "$HOME", ""}).output, "two words|$HOME||");
}

TEST(DoctorOutcome, AProgramThatReadsDoesNotWaitForAnyone) { EXPECT_TRUE(run_program({"cat"}).is_success()); }

TEST(DoctorOutcome, ACrashStaysInTheChild) {
  EXPECT_EQ(in_child_process([] { return std::raise(SIGKILL); }).exit_code, 128 + SIGKILL);
}

TEST(DoctorOutcome, MoreOutputThanAPipeHoldsIsReadToItsEnd) {
  const Outcome outcome = in_child_process([] {
    for (int i = 0; i < 300'000; ++i) std::fputc('x', stdout);
    return 0;
  });
  EXPECT_TRUE(outcome.is_success());
  EXPECT_EQ(outcome.output.size(), 300'000U);
}

}  // namespace
}  // namespace surefoot::doctor
