#include "firmware/core/decision/walk_stage.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace surefoot::decision {
namespace {

TEST(WalkStage, EveryLegalEdgeLeadsWhereTheTableSays) {
  for (const WalkEdge& edge : kWalkEdges) EXPECT_EQ(next_stage(edge.from, edge.on), edge.to);
}

TEST(WalkStage, NothingElseMovesIt) {
  for (const WalkStage stage : kWalkStages) {
    for (const WalkEvent event : kWalkEvents) {
      const bool is_legal =
          std::ranges::any_of(kWalkEdges, [&](const WalkEdge& edge) { return edge.from == stage && edge.on == event; });
      EXPECT_EQ(next_stage(stage, event).has_value(), is_legal) << name(stage) << " on " << name(event);
    }
  }
}

TEST(WalkStage, AFootInTheAirIsNotStoppedThere) {
  EXPECT_FALSE(next_stage(WalkStage::kLiftLeft, WalkEvent::kStopOrdered));
  EXPECT_FALSE(next_stage(WalkStage::kLiftRight, WalkEvent::kStopOrdered));
}

TEST(WalkStage, EveryNameIsItsOwn) {
  std::set<std::string> names;
  for (const WalkStage stage : kWalkStages) EXPECT_TRUE(names.insert(name(stage)).second);
  for (const WalkEvent event : kWalkEvents) EXPECT_TRUE(names.insert(name(event)).second);
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace surefoot::decision
