// By hand, at 1 and 5 Mbit/s, worst-case stuffing: 32 nominal bits each; data bits 33 + 10 n to 16 bytes, 38 + 10 n
// above. 8 bytes 54.6 us, 16 bytes 70.6, 20 bytes 79.6, 48 bytes 135.6.
#include "sim_hw/bus/bus_budget.hpp"

#include <gtest/gtest.h>

namespace surefoot::sim_hw {
namespace {

const StreamBudget& stream(const SingleBusBudget& bus, std::uint16_t identifier) {
  for (const StreamBudget& entry : bus.streams) {
    if (entry.stream.identifier == identifier) return entry;
  }
  throw std::out_of_range("no such identifier on this bus");
}

// SYNC 54.6 + legs 2 x 135.6 + feet 2 x 70.6 + IMU 79.6 = 546.6; torques 2 x 79.6 = 159.2; heartbeat 54.6.
TEST(BusBudget, OneBusCarriesOneKilohertz) {
  const BusBudget budget = bus_budget({}, 1e-3);
  EXPECT_EQ(budget.chain.sync_and_states_ns, 546'600);
  EXPECT_EQ(budget.chain.commands_ns, 159'200);
  EXPECT_EQ(budget.chain.heartbeat_ns, 54'600);
  EXPECT_EQ(budget.chain.compute_ns, 20'000);
  EXPECT_EQ(budget.chain.total_ns(), 780'400);
  EXPECT_EQ(budget.spare_ns(), 219'600);
  EXPECT_EQ(budget.spare_emergencies(), 4);
  EXPECT_TRUE(budget.carries());
  EXPECT_FALSE(refuse_overload({}, 1e-3));
  // (546.6 + 159.2) / 1000 and six heartbeats of 54.6 us in 100 ms
  EXPECT_NEAR(budget.buses.at(0).worst_load_percent, 70.58 + 0.3276, 1e-9);
}

// SYNC 54.6 + leg 135.6 + foot 70.6 + IMU 79.6 = 340.4; torques 79.6.
TEST(BusBudget, TwoBusesCarryTwoKilohertzWithLittleToSpare) {
  const BusBudget budget = bus_budget({.count = 2}, 0.5e-3);
  EXPECT_EQ(budget.chain.total_ns(), 340'400 + 20'000 + 79'600 + 54'600);
  EXPECT_EQ(budget.spare_ns(), 5'400);
  EXPECT_EQ(budget.spare_emergencies(), 0);
  EXPECT_FALSE(refuse_overload({.count = 2}, 0.5e-3));
}

// SYNC blocked by the longest frame; the last torques by a heartbeat, after everything above them once.
TEST(BusBudget, WorstCaseResponsesFollowTheTick) {
  const SingleBusBudget bus = bus_budget({}, 1e-3).buses.at(0);
  EXPECT_EQ(stream(bus, 0x080).worst_response_ns, 135'600 + 54'600);
  EXPECT_EQ(stream(bus, 0x202).worst_response_ns, 54'600 + 546'600 + 159'200);
  EXPECT_EQ(stream(bus, 0x0FF).worst_response_ns, 135'600 + 7 * 54'600);  // behind SYNC and five emergencies
}

// 8 bytes 54.6, 24 bytes (38 + 240 data bits) 87.6. As before 546.6, and hips 2 x 54.6 + feet 2 x 70.6 = 250.4; angles
// 2 x 87.6 = 175.2; computing 20; heartbeat 54.6: 1046.8. On two buses 465.6 + 20 + 87.6 + 54.6 = 627.8.
TEST(BusBudget, InertialLegsAndAnglesNeedASlowerTickOrTwoBuses) {
  constexpr TrafficOptions kRobot{.has_inertial_legs = true, .commands_angles = true};
  const BusBudget one = bus_budget({}, 1e-3, kRobot);
  EXPECT_EQ(one.chain.sync_and_states_ns, 797'000);
  EXPECT_EQ(one.chain.commands_ns, 175'200) << "angles, and not torques too";
  EXPECT_EQ(one.chain.total_ns(), 1'046'800);
  EXPECT_FALSE(one.carries());
  const auto refusal = refuse_overload({}, 1e-3, kRobot);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->remedy.find("bus.count = 2 (the tick then needs 627.8 us)"), std::string::npos) << refusal->remedy;
  EXPECT_NE(refusal->remedy.find("control_period_s = 0.00105 or more"), std::string::npos) << refusal->remedy;
  EXPECT_EQ(bus_budget({.count = 2}, 1e-3, kRobot).chain.total_ns(), 627'800);
  EXPECT_TRUE(bus_budget({}, 2e-3, kRobot).carries());
  EXPECT_FALSE(stream(one.buses.at(0), 0x201).worst_response_ns) << "seldom: no part of a healthy tick";
  EXPECT_EQ(stream(one.buses.at(0), 0x201).period_ns, 0);
}

TEST(BusBudget, NodesTakePartOfTheTick) {
  const BusBudget budget = bus_budget({.node_latency_s = 100e-6, .node_jitter_s = 50e-6}, 1e-3);
  EXPECT_EQ(budget.chain.node_ns, 150'000);
  EXPECT_EQ(budget.chain.total_ns(), 930'400);
  EXPECT_TRUE(refuse_overload({.node_latency_s = 200e-6, .node_jitter_s = 50e-6}, 1e-3));
}

TEST(RefuseOverload, SaysByHowMuchAndWhatWouldHelp) {
  const auto refusal = refuse_overload({}, 0.5e-3);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->statement.find("780.4 us"), std::string::npos) << refusal->statement;
  EXPECT_NE(refusal->statement.find("280.4 us (56.1 %) more"), std::string::npos) << refusal->statement;
  EXPECT_NE(refusal->remedy.find("bus.count = 2 (the tick then needs 494.6 us)"), std::string::npos);
  EXPECT_NE(refusal->remedy.find("control_period_s = 0.0008 or more"), std::string::npos) << refusal->remedy;
}

// At 8 Mbit/s: nine frames of 32 nominal bits, 2362 data bits of 0.125 us, computing 20 us: 603.25 us.
TEST(RefuseOverload, ProposesAFasterDataPhaseWhereThatIsEnough) {
  const auto refusal = refuse_overload({}, 0.7e-3);
  ASSERT_TRUE(refusal);
  EXPECT_NE(refusal->remedy.find("bus.data_bit_rate_hz = 8e6 (the tick then needs 603.2 us)"), std::string::npos)
      << refusal->remedy;
}

TEST(RefuseOverload, ItsRemediesHelp) {
  EXPECT_FALSE(refuse_overload({.count = 2}, 0.5e-3));
  EXPECT_FALSE(refuse_overload({.data_bit_rate_hz = 8e6}, 0.7e-3));
  EXPECT_FALSE(refuse_overload({}, 0.8e-3));
}

// Neither two buses nor a fast data phase nor both: only a slower tick is left.
TEST(RefuseOverload, NamesNoRemedyThatDoesNotHelp) {
  const auto refusal = refuse_overload({}, 0.2e-3);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->remedy.find("bus."), std::string::npos) << refusal->remedy;
}

}  // namespace
}  // namespace surefoot::sim_hw
