#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "tools/table/reference.hpp"

namespace surefoot::table {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::ptrdiff_t count(const Reference& reference, std::optional<bool> wanted) {
  return std::ranges::count(reference.survives, wanted);
}

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_reference("mine.csv", text));
  } catch (const BadReference& error) {
    return error.what();
  }
  return {};
}

// El-Kahlout 2003, tables 4.1 to 4.3.
TEST(ThesisTables, HaveTheCountsThatTheThesisPrints) {
  const Reference off = thesis_table("off").value();
  const Reference original = thesis_table("original").value();
  const Reference modified = thesis_table("modified").value();
  for (const Reference* reference : {&off, &original, &modified}) {
    EXPECT_EQ(reference->grid.times_s, thesis_grid().times_s);
    EXPECT_EQ(reference->grid.masses_kg, thesis_grid().masses_kg);
  }
  EXPECT_EQ(count(off, true), 48);
  EXPECT_EQ(count(off, false), 240);
  EXPECT_EQ(count(original, true), 268);
  EXPECT_EQ(count(original, false), 14);
  EXPECT_EQ(count(original, std::nullopt), 6);
  EXPECT_EQ(count(modified, true), 284);
  EXPECT_EQ(count(modified, false), 4);
}

// A table read with rows and columns changed over, or one row too low, would pass the counts.
TEST(ThesisTables, HaveTheirFailuresWhereTheThesisPrintsThem) {
  const Reference original = thesis_table("original").value();
  for (const double at_s : {1.3, 1.4, 1.5, 1.6, 1.7, 3.7, 3.8, 3.9, 4.0, 4.1}) {
    EXPECT_EQ(original.at(at_s, 15.0), false) << at_s;
  }
  for (const double at_s : {1.4, 1.5, 3.8, 3.9}) EXPECT_EQ(original.at(at_s, 12.5), false) << at_s;
  EXPECT_EQ(original.at(4.2, 15.0), std::nullopt) << "the row that is not printed";
  const Reference modified = thesis_table("modified").value();
  for (const double at_s : {1.3, 1.4, 3.7, 3.8}) EXPECT_EQ(modified.at(at_s, 15.0), false) << at_s;
  EXPECT_EQ(thesis_table("off").value().at(2.4, 2.5), true);
}

TEST(ThesisTables, KnowNoOtherMethod) { EXPECT_FALSE(thesis_table("capture")); }

TEST(Reference, KnowsNothingOfCellsOffItsGrid) {
  const Reference reference = parse_reference("mine.csv", "load_time_s,5\n0.1,1\n");
  EXPECT_EQ(reference.at(0.1, 5.0), true);
  EXPECT_EQ(reference.at(0.15, 5.0), std::nullopt);
  EXPECT_EQ(reference.at(0.1, 6.0), std::nullopt);
}

TEST(Reference, TakesLineEndsOfOtherSystemsAndEmptyLines) {
  const Reference reference = parse_reference("mine.csv", "load_time_s,5,10\r\n\r\n0.1,1,0\r\n");
  EXPECT_EQ(reference.at(0.1, 10.0), false);
}

TEST(Reference, RefusesWithFileLineValueAndRemedy) {
  EXPECT_THAT(refusal_of("load_time_s,5\n0.1,1\n0.2,yes\n"),
              AllOf(HasSubstr("mine.csv:3"), HasSubstr("\"yes\""), HasSubstr("remedy:")));
  EXPECT_THAT(refusal_of("load_time_s,5\n0.1,1,0\n"), AllOf(HasSubstr("mine.csv:2"), HasSubstr("3 fields")));
  EXPECT_THAT(refusal_of("load_time_s,5\n0.2,1\n0.1,1\n"), HasSubstr("does not come after"));
  EXPECT_THAT(refusal_of("load_time_s,5,5\n0.1,1,1\n"), HasSubstr("does not come after"));
  EXPECT_THAT(refusal_of("time,5\n0.1,1\n"), HasSubstr("not load_time_s"));
}

TEST(Reference, RefusesWhatIsNoTableAtAll) {
  const std::string zeros(1000, '\0');
  for (const std::string& text :
       {std::string(), std::string("\n\n"), std::string("load_time_s\n0.1\n"), std::string("load_time_s,5\n"),
        std::string("load_time_s,nan\n0.1,1\n"), std::string("load_time_s,5\n-1,1\n"),
        std::string("load_time_s,5\n0.1,2\n"), std::string("load_time_s,5\n0.1, 1\n"), zeros,
        std::string("load_time_s,\n0.1,1\n")}) {
    EXPECT_THAT(refusal_of(text), HasSubstr("remedy:")) << text;
  }
}

// A file may hold anything; a terminal shall not obey it.
TEST(Reference, ShowsNoControlCharacterOfTheFile) {
  EXPECT_EQ(refusal_of("\x1b[2J,5\n0.1,1\n").find('\x1b'), std::string::npos);
}

TEST(Reference, RefusesAFileThatIsNotThereOrIsAFolder) {
  for (const char* file : {"/nowhere/table.csv", "/"}) {
    EXPECT_THROW(static_cast<void>(load_reference(file)), BadReference);
  }
}

}  // namespace
}  // namespace surefoot::table
