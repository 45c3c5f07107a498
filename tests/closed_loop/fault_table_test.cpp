// Every fault of the catalogue in every situation, as `surefoot faults` prints it.
#include "tools/faults/fault_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace surefoot::faults {
namespace {

const std::vector<FaultRow>& table() {
  static const std::vector<FaultRow> rows = [] {
    const std::vector<std::string> nominal{"plant=nominal"};
    return try_all(scenario::load_default(nominal), catalogue(), [](std::size_t, std::size_t) {});
  }();
  return rows;
}

template <class Check>
void for_each_cell(const Check& check) {
  for (const FaultRow& row : table()) {
    for (const Situation situation : kSituations) {
      SCOPED_TRACE(row.entry.what + ", " + name(situation));
      check(row, row.result[static_cast<std::size_t>(situation)]);
    }
  }
}

TEST(FaultTable, HoldsEveryKindOfFault) {
  std::set<sim_hw::FaultKind> kinds;
  for (const FaultRow& row : table()) kinds.insert(row.entry.fault.kind);
  EXPECT_EQ(kinds.size(), sim_hw::kFaultKinds);
}

TEST(FaultTable, NoCommandEverLeavesTheOutputGatesLimits) {
  for_each_cell([](const FaultRow&, const TrialResult& result) {
    EXPECT_TRUE(result.command.is_within_gate)
        << result.command.torque_nm << " N m, step " << result.command.torque_step_nm;
  });
}

// A robot that has no fault latched, or stands, must be up; one that damps is lowered, not dropped: a body at
// 0.6 m that falls freely is down after 0.35 s.
TEST(FaultTable, ARobotStaysUpUnlessItsLegsCannotBeTrustedAndIsThenLowered) {
  for_each_cell([](const FaultRow&, const TrialResult& result) {
    if (result.safe_state == safety::SafeState::kDamp) {
      EXPECT_GT(result.fell_after_s.value_or(kWatch_s), 0.7);
    } else {
      EXPECT_FALSE(result.fell_after_s.has_value());
    }
  });
}

TEST(FaultTable, AFaultThatLatchesHasASafeStateAndOneThatDoesNotHasNone) {
  for_each_cell([](const FaultRow&, const TrialResult& result) {
    EXPECT_EQ(result.fault == safety::Fault::kNone, result.safe_state == safety::SafeState::kNone);
    EXPECT_EQ(result.fault == safety::Fault::kNone, !result.answer_ticks.has_value());
  });
}

TEST(FaultTable, WithoutAFaultNothingLatches) {
  const FaultRow& none = table().front();
  ASSERT_EQ(none.entry.what, "no fault");
  for (const TrialResult& result : none.result) EXPECT_EQ(result.fault, safety::Fault::kNone);
}

// FAULTS.md: ride-through of 10 ticks, then fault 1.
TEST(FaultTable, ASilentNodeLatchesFaultOneAfterTheRideThrough) {
  for_each_cell([](const FaultRow& row, const TrialResult& result) {
    if (row.entry.fault.kind != sim_hw::FaultKind::kDeadNode) return;
    EXPECT_EQ(result.fault, safety::Fault::kSensorSilent);
    EXPECT_EQ(result.answer_ticks, 10);
  });
}

// A board that comes back begins where its joints have gone meanwhile, and gets to the pattern's angles at the gate's
// pace: 12 rad/s, 0.012 rad a tick.
TEST(FaultTable, TheAnglesOfAPositionServoKeepTheGateToo) {
  const std::vector<CatalogueEntry> all = catalogue();
  const auto restart = std::ranges::find(all, "left leg board restarts, 5 ms", &CatalogueEntry::what);
  ASSERT_NE(restart, all.end());
  const std::vector<std::string> standing{"pattern.standing_s=2"};
  const scenario::Scenario khr2 = scenario::load(SUREFOOT_SCENARIOS "/khr2_flat.toml", standing);
  const TrialResult result = try_fault(khr2, Situation::kReflex, restart->fault);
  EXPECT_TRUE(result.command.is_within_gate) << result.command.angle_step_rad;
  EXPECT_EQ(result.command.torque_nm, 0.0);
  EXPECT_GT(result.command.angle_step_rad, 0.002) << "more than the pattern asks for, else nothing was judged";
  EXPECT_EQ(result.fault, safety::Fault::kNone);
}

TEST(FaultTable, AWholeTableIsTheSameEachTime) {
  const FaultRow& row = table().at(1);
  const std::vector<std::string> nominal{"plant=nominal"};
  const TrialResult again = try_fault(scenario::load_default(nominal), Situation::kWalking, row.entry.fault);
  EXPECT_EQ(again.command.torque_step_nm, row.result[1].command.torque_step_nm);
  EXPECT_EQ(again.lowest_body_m, row.result[1].lowest_body_m);
}

}  // namespace
}  // namespace surefoot::faults
