// Which plant a calibration chooses from its counts.
#include "tools/calibrate/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace surefoot::calibrate {
namespace {

using ::testing::ElementsAre;

/// Ten instants at each toe 1 mm apart from 100 mm on.
/// @param differing  cells that differ, toe by toe
std::vector<PlantCount> row_of(double friction, const std::vector<std::size_t>& differing) {
  std::vector<PlantCount> plants;
  for (const std::size_t count : differing) {
    plants.push_back({friction, 0.1 + 0.001 * static_cast<double>(plants.size()), 10, 10, count});
  }
  return plants;
}

std::vector<PlantCount> together(std::vector<PlantCount> first, const std::vector<PlantCount>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<int> millimetres(const Window& window) {
  std::vector<int> toes;
  for (const double toe_m : window.toes_m) toes.push_back(static_cast<int>(1e3 * toe_m + 0.5));
  return toes;
}

TEST(Calibration, CountsLightLoadsThatAreNotSurvivedAndHeavyOnesThatAre) {
  table::Band band{"off", "thesis", {0.1, 0.2}, {0.12}, Search{{}, {0.1, 0.2, 0.3}}.grid(), {}};
  for (const bool survives : {true, false, true, true, false, false, /* second plant */
                              true, false, true, false, true, false}) {
    band.cells.push_back({.survives = survives, .outcome = {}, .reason = {}, .fall = {}});
  }
  const std::vector<PlantCount> plants = count_plants(band);
  ASSERT_EQ(plants.size(), 2U);
  EXPECT_EQ(plants[0].light_survive, 2U);
  EXPECT_EQ(plants[0].heavy_survive, 1U);
  EXPECT_EQ(plants[0].differing(), 2U);
  EXPECT_EQ(plants[1].friction, 0.2);
  EXPECT_EQ(plants[1].differing(), 0U);
}

TEST(Calibration, AWindowIsTheLongestRowOfToesThatDifferLeast) {
  const std::vector<Window> found = windows(row_of(0.1, {3, 0, 0, 1, 0, 0, 0, 4}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(millimetres(found[0]), ElementsAre(104, 105, 106));
  EXPECT_EQ(found[0].differing, 0U);
}

TEST(Calibration, OfTwoRowsAlikeTheOneWithTheLongerToesIsTaken) {
  EXPECT_THAT(millimetres(windows(row_of(0.1, {0, 0, 1, 0, 0})).at(0)), ElementsAre(103, 104));
}

TEST(Calibration, WindowsDoNotReachFromOneFrictionIntoTheNext) {
  const std::vector<Window> found = windows(together(row_of(0.1, {1, 0, 0}), row_of(0.2, {0, 1, 1})));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(millimetres(found[0]), ElementsAre(101, 102));
  EXPECT_THAT(millimetres(found[1]), ElementsAre(100));
}

TEST(Calibration, WhereNoPlantAgreesTheLeastDifferenceMakesTheWindow) {
  const std::vector<Window> found = windows(together(row_of(0.1, {5, 4, 3}), row_of(0.2, {2, 2, 7})));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].friction, 0.2);
  EXPECT_EQ(found[0].differing, 2U);
}

TEST(Calibration, TakesTheWidestWindowAndOfTwoThatWithTheMostFriction) {
  EXPECT_EQ(widest({{0.1, {1, 2}, 0}, {0.2, {1, 2, 3}, 0}, {0.3, {1}, 0}}).friction, 0.2);
  EXPECT_EQ(widest({{0.1, {1, 2}, 0}, {0.2, {1, 2}, 0}, {0.3, {1}, 0}}).friction, 0.2);
}

TEST(Calibration, CsvHasOneLineForEachPlant) {
  Calibration calibration;
  calibration.plants = row_of(0.11, {0, 2});
  EXPECT_EQ(to_csv(calibration),
            "friction,toe_m,instants,light_survive,heavy_survive,differing\n"
            "0.11,0.1,10,10,0,0\n0.11,0.101,10,10,2,2\n");
}

}  // namespace
}  // namespace surefoot::calibrate
