#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>

#include "tools/doctor/bus_checks.hpp"

namespace surefoot::doctor {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

const Outcome kUnknownType{2, "Error: Unknown device type."};  // iproute2 6.1 on a kernel without vcan

TEST(DoctorCanSockets, AreFineWhenTheKernelGivesOne) { EXPECT_EQ(judge_can_sockets(0, false).status, Status::kOk); }

// A modprobe of what was never built mends nothing.
TEST(DoctorCanSockets, OfAKernelWithoutCanAreMendedByTheModuleOrElseByAGuest) {
  const Finding with_module = judge_can_sockets(EAFNOSUPPORT, true);
  EXPECT_EQ(with_module.status, Status::kMissing);
  EXPECT_EQ(with_module.remedy, "sudo modprobe can-raw");
  EXPECT_THAT(judge_can_sockets(EAFNOSUPPORT, false).remedy, StartsWith("tools/with-vcan"));
}

TEST(DoctorCanSockets, ThatAreForbiddenAreNotCalledAbsent) {
  const Finding forbidden = judge_can_sockets(EPERM, true);
  EXPECT_EQ(forbidden.status, Status::kMissing);
  EXPECT_THAT(forbidden.detail, HasSubstr("refuses"));
}

TEST(DoctorVcan, AnInterfaceThatIsThereIsNamed) {
  const Finding there = judge_vcan({"can0", "vcan0"}, kUnknownType, false);
  EXPECT_EQ(there.status, Status::kOk);
  EXPECT_THAT(there.detail, HasSubstr("can0, vcan0"));
}

TEST(DoctorVcan, OneThatCanBeMadeIsEnough) { EXPECT_EQ(judge_vcan({}, {0, ""}, false).status, Status::kOk); }

TEST(DoctorVcan, AnUnknownTypeIsMendedByTheModuleOrElseByAGuest) {
  EXPECT_EQ(judge_vcan({}, kUnknownType, true).remedy, "sudo modprobe vcan");
  EXPECT_THAT(judge_vcan({}, kUnknownType, false).remedy, StartsWith("tools/with-vcan"));
  EXPECT_THAT(judge_vcan({}, {2, "RTNETLINK answers: Operation not supported"}, false).remedy,
              StartsWith("tools/with-vcan"));
}

TEST(DoctorVcan, AUserWhoMayNotTryIsToldThat) {
  const Finding unknown = judge_vcan({}, {1, "unshare: unshare failed: Operation not permitted"}, false);
  EXPECT_EQ(unknown.status, Status::kMissing);
  EXPECT_THAT(unknown.detail, HasSubstr("by this user (unshare: unshare failed"));
}

TEST(DoctorCanUtils, NamesWhatIsAbsent) {
  EXPECT_EQ(judge_can_utils({}).status, Status::kOk);
  const Finding absent = judge_can_utils({"cansend", "canplayer"});
  EXPECT_EQ(absent.status, Status::kMissing);
  EXPECT_THAT(absent.detail, HasSubstr("cansend, canplayer"));
  EXPECT_THAT(absent.remedy, HasSubstr("apt-get install -y can-utils"));
}

TEST(DoctorUserModeLinux, NeedsItsProgramItsModulesAndInsmod) {
  EXPECT_EQ(judge_user_mode_linux({true, true, true}).status, Status::kOk);
  EXPECT_THAT(judge_user_mode_linux({false, true, true}).remedy, HasSubstr("user-mode-linux"));
  EXPECT_THAT(judge_user_mode_linux({true, false, true}).remedy, HasSubstr("user-mode-linux"));
  const Finding no_insmod = judge_user_mode_linux({true, true, false});
  EXPECT_EQ(no_insmod.status, Status::kMissing);
  EXPECT_THAT(no_insmod.remedy, HasSubstr("-y kmod"));
}

TEST(DoctorTimeTravel, IsShownWithItsPathOrTheWayToBuildIt) {
  EXPECT_EQ(judge_time_travel("/cache/linux").detail, "/cache/linux");
  EXPECT_THAT(judge_time_travel(std::nullopt).remedy, StartsWith("tools/build-uml"));
}

TEST(DoctorWithVcan, WorksWithEitherBackendAndNamesTheMissingOneOtherwise) {
  const Finding absent = missing("none", "install it");
  EXPECT_THAT(judge_with_vcan(true, ok(""), absent).detail, HasSubstr("this kernel"));
  EXPECT_THAT(judge_with_vcan(true, absent, ok("")).detail, HasSubstr("User Mode Linux"));
  EXPECT_EQ(judge_with_vcan(true, absent, absent).status, Status::kMissing);
  EXPECT_EQ(judge_with_vcan(true, absent, absent).remedy, "install it");
  EXPECT_EQ(judge_with_vcan(false, ok(""), ok("")).status, Status::kMissing);
}

}  // namespace
}  // namespace surefoot::doctor
