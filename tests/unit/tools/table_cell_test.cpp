#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tools/table/cell.hpp"

namespace surefoot::table {
namespace {

run::Verdict fallen(double ended_at_s) {
  run::Verdict verdict;
  verdict.outcome = run::Outcome::kFell;
  verdict.ended_at_s = ended_at_s;
  verdict.torso_pitch_deg.include(0.0);
  verdict.torso_roll_deg.include(0.0);
  return verdict;
}

TEST(Cell, SurvivesWithTheVerdictWalkedAlone) {
  run::Verdict verdict;
  verdict.outcome = run::Outcome::kWalked;
  EXPECT_TRUE(cell_of(verdict, 1.2).survives);
  EXPECT_FALSE(cell_of(verdict, 1.2).fall);
  for (const run::Outcome outcome : {run::Outcome::kFell, run::Outcome::kLimit, run::Outcome::kFault}) {
    verdict.outcome = outcome;
    EXPECT_FALSE(cell_of(verdict, 1.2).survives);
  }
}

TEST(Cell, HasASymbolForEachOutcome) {
  Cell cell;
  std::string symbols;
  for (const run::Outcome outcome :
       {run::Outcome::kWalked, run::Outcome::kFell, run::Outcome::kLimit, run::Outcome::kFault}) {
    cell.outcome = outcome;
    symbols += symbol(cell);
  }
  EXPECT_EQ(symbols, "+flx");
}

// Pitch is positive forward, roll positive to the right.
TEST(Fall, GoesWhereTheTorsoTiltedMost) {
  struct Case {
    double pitch_deg, roll_deg;
    Direction direction;
  };
  for (const Case& c :
       {Case{45.0, 10.0, Direction::kForward}, Case{-45.0, 10.0, Direction::kBackward},
        Case{10.0, -45.0, Direction::kLeft}, Case{-10.0, 45.0, Direction::kRight}, Case{5.0, -5.0, Direction::kDown}}) {
    run::Verdict verdict = fallen(3.0);
    verdict.torso_pitch_deg.include(c.pitch_deg);
    verdict.torso_roll_deg.include(c.roll_deg);
    EXPECT_EQ(cell_of(verdict, 1.2).fall.value().direction, c.direction) << name(c.direction);
  }
}

TEST(Fall, BeforeTheLoadIsNoticedHasNoTriggerAndIsInTheWalk) {
  run::Verdict verdict = fallen(2.0);
  verdict.events = {
      {"standing_done", -9.0}, {"restored", -7.8}, {"rested", -7.0}, {"payload_attached", 1.2}, {"payload_seen", 1.3}};
  const Fall fall = cell_of(verdict, 1.2).fall.value();
  EXPECT_NEAR(fall.after_load_s, 0.8, 1e-12);
  EXPECT_FALSE(fall.after_trigger_s);
  EXPECT_EQ(fall.phase, "walking");
}

TEST(Fall, NamesThePhaseThatItsEventsLeadTo) {
  run::Verdict verdict = fallen(4.0);
  verdict.events = {{"standing_done", -9.0},   {"restored", -7.8},         {"rested", -7.0},
                    {"payload_attached", 1.2}, {"payload_detected", 1.25}, {"reflex_done", 1.35}};
  EXPECT_EQ(cell_of(verdict, 1.2).fall.value().phase, "settling");
  EXPECT_NEAR(cell_of(verdict, 1.2).fall.value().after_trigger_s.value(), 2.75, 1e-12);
  verdict.events.insert(verdict.events.end(),
                        {{"settled", 3.35}, {"shifted", 3.85}, {"restored", 3.9}, {"rested", 3.95}});
  EXPECT_EQ(cell_of(verdict, 1.2).fall.value().phase, "walking on") << "not as before the load";
}

TEST(Survivors, AreCountedOverTheCellsOfTheirLoads) {
  std::vector<run::Verdict> verdicts(3, fallen(2.0));
  verdicts[1].outcome = run::Outcome::kWalked;
  const std::vector<Cell> cells = cells_of({{5.0, 0.5}, {5.0, 1.0}, {5.0, 1.5}}, verdicts);
  EXPECT_EQ(survivors(cells), 1U);
  EXPECT_EQ(cells[2].fall.value().after_load_s, 0.5) << "each cell counts from its own load";
}

}  // namespace
}  // namespace surefoot::table
