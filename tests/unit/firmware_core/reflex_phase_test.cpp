#include "firmware/core/decision/reflex_phase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace surefoot::decision {
namespace {

bool is_in_table(ReflexPhase phase, ReflexEvent event) {
  return std::any_of(kReflexEdges.begin(), kReflexEdges.end(),
                     [&](const Edge& edge) { return edge.from == phase && edge.on == event; });
}

// Written out, so that an edited table has to be edited twice.
TEST(ReflexPhase, FollowsEveryLegalEdge) {
  using P = ReflexPhase;
  using E = ReflexEvent;
  EXPECT_EQ(next_phase(P::kStanding, E::kStandingDone), P::kRestoring);
  EXPECT_EQ(next_phase(P::kWalking, E::kPayloadDetected), P::kReflex);
  EXPECT_EQ(next_phase(P::kWalking, E::kBalanceLost), P::kReflex);
  EXPECT_EQ(next_phase(P::kReflex, E::kReflexDone), P::kSettling);
  EXPECT_EQ(next_phase(P::kSettling, E::kSettled), P::kShifting);
  EXPECT_EQ(next_phase(P::kShifting, E::kShifted), P::kRestoring);
  EXPECT_EQ(next_phase(P::kRestoring, E::kRestored), P::kResting);
  EXPECT_EQ(next_phase(P::kResting, E::kRested), P::kWalking);
  for (const P phase :
       {P::kStanding, P::kWalking, P::kReflex, P::kSettling, P::kShifting, P::kRestoring, P::kResting}) {
    EXPECT_EQ(next_phase(phase, E::kStopOrdered), P::kStopped);
  }
  EXPECT_EQ(kReflexEdges.size(), 15U);
}

TEST(ReflexPhase, RefusesEveryPairThatIsNotInTheTable) {
  int illegal = 0;
  for (const ReflexPhase phase : kReflexPhases) {
    for (const ReflexEvent event : kReflexEvents) {
      if (is_in_table(phase, event)) continue;
      EXPECT_EQ(next_phase(phase, event), std::nullopt) << name(phase) << " on " << name(event);
      ++illegal;
    }
  }
  EXPECT_EQ(illegal, 8 * 9 - 15);
}

TEST(ReflexPhase, HasOneWayOutOfEachPhaseButWalkingBesideTheStopAndNoneOutOfThat) {
  for (const ReflexPhase phase : kReflexPhases) {
    EXPECT_EQ(std::count_if(kReflexEdges.begin(), kReflexEdges.end(), [&](const Edge& e) { return e.from == phase; }),
              phase == ReflexPhase::kStopped   ? 0
              : phase == ReflexPhase::kWalking ? 3
                                               : 2);
  }
}

TEST(ReflexPhase, HasItsOwnNameForEachPhaseAndEvent) {
  std::set<std::string> names;
  for (const ReflexPhase phase : kReflexPhases) names.insert(name(phase));
  for (const ReflexEvent event : kReflexEvents) names.insert(name(event));
  EXPECT_EQ(names.size(), kReflexPhases.size() + kReflexEvents.size());
  EXPECT_EQ(names.count("unknown"), 0U);
  EXPECT_STREQ(name(ReflexPhase::kSettling), "settling");
  EXPECT_STREQ(name(ReflexEvent::kPayloadDetected), "payload_detected");
}

}  // namespace
}  // namespace surefoot::decision
