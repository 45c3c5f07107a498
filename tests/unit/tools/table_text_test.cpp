#include "tools/table/table_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace surefoot::table {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Six instants by two loads, hand-made: '+' survives, 'f' falls, 'l' does not recover.
Table table_of(const std::string& symbols) {
  Table table{"original", "thesis", {{0.1, 0.2, 0.3, 2.5, 2.6, 2.7}, {5.0, 12.5}}, {}};
  for (const char c : symbols) {
    Cell cell;
    cell.outcome = c == '+' ? run::Outcome::kWalked : c == 'l' ? run::Outcome::kLimit : run::Outcome::kFell;
    cell.survives = c == '+';
    cell.reason = "0.5 cycles walked after recovery";
    if (c == 'f') cell.fall = Fall{Direction::kLeft, 1.25, 1.2, "settling"};
    table.cells.push_back(cell);
  }
  return table;
}

const Table kTable = table_of(
    "++"
    "+f"
    "l+"
    "++"
    "++"
    "+f");
const std::optional<Reference> kReference =
    parse_reference("paper", "load_time_s,5,12.5\n0.1,1,1\n0.2,1,1\n0.3,,\n2.5,1,0\n2.6,1,1\n2.7,1,0\n");

TEST(Matrix, StandsBesideItsReferenceWithDifferingCellsMarked) {
  EXPECT_EQ(matrix_text(kTable, kReference),
            "  load at  here, kg       paper, kg\n"
            "              5  12.5        5  12.5 \n"
            "    0.1 s     +     +        +     + \n"
            "    0.2 s     +     f!       +     + \n"
            "    0.3 s     l     +        -     - \n"
            "    2.5 s     +     +!       +     f \n"
            "    2.6 s     +     +        +     + \n"
            "    2.7 s     +     f        +     f \n");
}

TEST(Matrix, StandsAloneAndUnmarkedWithoutAReference) {
  const std::string text = matrix_text(kTable, {});
  EXPECT_THAT(text, HasSubstr("    0.2 s     +     f \n"));
  EXPECT_THAT(text, Not(HasSubstr("!")));
}

TEST(Comparison, CountsOnlyWhatIsPrinted) {
  const Comparison sums = compare(kTable, *kReference);
  EXPECT_EQ(sums.printed, 10U);
  EXPECT_EQ(sums.survive_printed, 8U);
  EXPECT_EQ(sums.only_survive_here, 1U);
  EXPECT_EQ(sums.only_survive_there, 1U);
  EXPECT_EQ(sums.differing(), 2U);
}

TEST(Symmetry, FindsEveryPairHalfACycleApartOfWhichOneSurvives) {
  const SymmetryCheck check = check_symmetry(kTable, 2.4);
  EXPECT_EQ(check.pairs, 6U);
  ASSERT_EQ(check.breaches.size(), 3U);
  EXPECT_EQ(check.breaches[0].mass_kg, 5.0);
  EXPECT_EQ(check.breaches[0].early_s, 0.3);
  EXPECT_FALSE(check.breaches[0].early_survives);
  EXPECT_EQ(check.breaches[1].mass_kg, 12.5);
  EXPECT_EQ(check.breaches[1].early_s, 0.2);
  EXPECT_EQ(check.breaches[1].late_s, 2.6);
  EXPECT_TRUE(check.breaches[2].early_survives) << "12.5 kg at 0.3 s, and a fall at 2.7 s";
}

TEST(Symmetry, HasNothingToSayOfAGridWithoutPairs) {
  EXPECT_EQ(check_symmetry(kTable, 2.45).pairs, 0U);
  EXPECT_THAT(summary_text(kTable, {}, 2.45), Not(HasSubstr("symmetry")));
}

TEST(Summary, CountsSurvivorsDifferencesDirectionsAndBreaches) {
  const std::string text = summary_text(kTable, kReference, 2.4);
  EXPECT_THAT(text, HasSubstr("9 of 12 cells survive"));
  EXPECT_THAT(text, HasSubstr("paper: 8 of 10 printed cells survive"));
  EXPECT_THAT(text, HasSubstr("2 differ (!): 1 survive here only, 1 there only"));
  EXPECT_THAT(text, HasSubstr("falls: left 2\n"));
  EXPECT_THAT(text, HasSubstr("no fall, but not walked on either: 1 "));
  EXPECT_THAT(text, HasSubstr("3 of 6 pairs differ"));
  EXPECT_THAT(text, HasSubstr("12.5 kg: survives at 2.6 s, not at 0.2 s"));
}

TEST(Falls, AreListedWithTimeDirectionAndPhaseAndOtherFailuresWithTheirReason) {
  const std::string text = falls_text(loads_of(kTable.grid), kTable.cells);
  EXPECT_EQ(std::ranges::count(text, '\n'), 4);
  EXPECT_THAT(text, HasSubstr("   12.5      0.2  fell         1.250 s        1.200 s  left       settling\n"));
  EXPECT_THAT(text, HasSubstr("limit     0.5 cycles walked after recovery\n"));
}

TEST(TableCsv, HasARowForEveryCellWithTheSameNumberOfFields) {
  const std::string text = to_csv(loads_of(kTable.grid), kTable.cells, kReference);
  EXPECT_EQ(std::ranges::count(text, '\n'), 13);
  EXPECT_EQ(std::ranges::count(text, ','), 13 * 8);
  EXPECT_THAT(text, HasSubstr("\n0.2,12.5,0,fell,1,left,1.250,1.200,settling\n"));
  EXPECT_THAT(text, HasSubstr("\n0.3,5,0,limit,,,,,\n"));
}

TEST(TableJson, HoldsCellsCountsAndBreaches) {
  const auto json = nlohmann::json::parse(to_json(kTable, kReference, 2.4));
  EXPECT_EQ(json.at("survive"), 9);
  EXPECT_EQ(json.at("cells").size(), 12U);
  EXPECT_EQ(json.at("cells")[3].at("fall").at("direction"), "left");
  EXPECT_TRUE(json.at("cells")[4].at("reference").is_null());
  EXPECT_EQ(json.at("reference").at("differ"), 2);
  EXPECT_EQ(json.at("symmetry").at("breaches").size(), 3U);
  EXPECT_TRUE(nlohmann::json::parse(to_json(kTable, {}, 2.4)).at("reference").is_null());
}

}  // namespace
}  // namespace surefoot::table
