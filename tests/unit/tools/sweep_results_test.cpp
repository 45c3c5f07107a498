#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tools/sweep/results.hpp"
#include "tools/sweep/row_ranges.hpp"
#include "tools/sweep/slurm_script.hpp"

namespace surefoot::sweep {
namespace {

using ::testing::HasSubstr;

Sweep two_rows() {
  return load_text("dir/it's.toml",
                   "scenario = \"a b.toml\"\n[set]\nplant = \"nominal\"\n[grid]\nfloor.friction = [1, 0.1]\n"
                   "payload.0.position_m = [[0.2, 0, 0.25]]\n");
}

std::vector<run::Verdict> two_verdicts() {
  std::vector<run::Verdict> verdicts(2);
  verdicts[0].outcome = run::Outcome::kFell;
  verdicts[0].reason = "the \"robot\" fell, at last";
  verdicts[1].reason = "walks";
  verdicts[1].torso_pitch_deg.include(-0.25);
  verdicts[1].events = {{"payload_attached", 1.2}, {"payload_detected", 1.25}, {"payload_detected", 1e-7}};
  verdicts[1].peak_torque_nm = {1.0, 2.0, 131.5, 0.0, 0.0, 0.0};
  return verdicts;
}

TEST(SweepResults, CsvIsAsRfc4180HasIt) {
  const std::string csv = to_csv(results_of(two_rows(), two_verdicts()));
  EXPECT_TRUE(csv.starts_with("row,floor.friction,payload.0.position_m,outcome,reason,ended_at_s,"));
  EXPECT_THAT(csv, HasSubstr("\r\n0,1.0,\"[0.2, 0, 0.25]\",fell,\"the \"\"robot\"\" fell, at last\",0.0,nan,nan,"));
  EXPECT_THAT(csv, HasSubstr("\r\n1,0.1,\"[0.2, 0, 0.25]\",walked,walks,0.0,-0.25,-0.25,nan,nan,"));
  EXPECT_THAT(csv, HasSubstr(",1e-07,1.25,"));  // first and last detection
  EXPECT_TRUE(csv.ends_with("\r\n"));
}

TEST(SweepResults, EachColumnHoldsOneTypeAndNoRowIsShort) {
  const Results results = results_of(two_rows(), two_verdicts());
  for (const auto& row : results.rows) {
    ASSERT_EQ(row.size(), results.columns.size());
    for (std::size_t column = 0; column < row.size(); ++column) {
      const std::string& name = results.columns[column].name;
      EXPECT_FALSE(row[column].empty()) << name;
      const bool looks_like_float = row[column].find_first_of(".en") != std::string::npos;
      const ColumnType type = results.columns[column].type;
      EXPECT_TRUE(type == ColumnType::kText || looks_like_float == (type == ColumnType::kNumber)) << name;
    }
  }
}

TEST(SweepResults, JsonHoldsNumbersAndNullForNone) {
  const auto json = nlohmann::json::parse(to_json(results_of(two_rows(), two_verdicts())));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[1]["pitch_max_deg"], -0.25);
  EXPECT_EQ(json[1]["peak_torque_nm"], 131.5);
  EXPECT_TRUE(json[0]["pitch_max_deg"].is_null());
  EXPECT_TRUE(json[0]["row"].is_number_integer());
}

TEST(SweepResults, TheCommandIsQuotedForAShell) {
  EXPECT_EQ(command_of(two_rows(), 1),
            "surefoot run 'dir/a b.toml' --set plant=nominal --set floor.friction=0.1 "
            "--set 'payload.0.position_m=[0.2, 0, 0.25]'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_word("$(x)"), "'$(x)'");
}

TEST(RowRanges, TakeNeighboursTogetherUpToTheLongest) {
  std::vector<std::string> texts;
  for (const RowRange& range : ranges_of({0, 1, 2, 3, 7, 9, 10}, 3)) texts.push_back(to_text(range));
  EXPECT_THAT(texts, ::testing::ElementsAre("0-2", "3-3", "7-7", "9-10"));
}

TEST(RowRanges, AreReadOnlyAsTheyAreWritten) {
  EXPECT_EQ(range_of("3-17")->last, 17U);
  EXPECT_EQ(range_of("4")->last, 4U);
  for (const char* text : {"", "-", "3-", "-3", "5-4", "1-2-3", "a", "1 -2", "+1", "99999999999999999999"}) {
    EXPECT_FALSE(range_of(text).has_value()) << text;
  }
}

// A Slurm array takes 1,001 tasks unless it was told otherwise (MaxArraySize).
TEST(RowRanges, MakeFewEnoughPiecesForASlurmArray) {
  for (const std::size_t rows : {1U, 63U, 2000U, 32000U, 32001U, 1000000U}) {
    const std::size_t size = rows_in_a_piece(rows);
    EXPECT_GE(size, 1U);
    EXPECT_LE((rows + size - 1) / size, 1000U) << rows;
  }
}

TEST(SlurmScript, NamesNoJobAfterWhatAFileNameMayHold) {
  Sweep sweep = two_rows();
  sweep.name = "a\n#SBATCH --wrap x";
  const std::string script = slurm_script(sweep, {"/bin/surefoot", "/a b/s.toml", "/r"});
  EXPECT_THAT(script, HasSubstr("--job-name=surefoot-a__SBATCH_--wrap_x\n"));
  EXPECT_THAT(script, HasSubstr("sweep-rows '/a b/s.toml' --rows"));
  EXPECT_THAT(script, HasSubstr("#SBATCH --array=0-1\n"));
}

}  // namespace
}  // namespace surefoot::sweep
