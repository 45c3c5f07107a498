#include "sim_hw/world/terrain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace surefoot::sim_hw {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

TerrainConfig tiles(double height_m, std::uint64_t seed = 1) { return {.tile_height_m = height_m, .tile_seed = seed}; }

/// A floor of the given patches, friction 0.7.
Terrain with_patches(std::vector<PatchConfig> patches) {
  TerrainConfig config;
  config.patches = std::move(patches);
  return {config, 0.7};
}

TEST(Terrain, IsExactlyFlatWithoutTilesPlatesAndPatches) {
  const Terrain terrain({}, 0.7);
  EXPECT_TRUE(terrain.is_plane());
  EXPECT_EQ(terrain.height_m(0.123, -4.5), 0.0);
  EXPECT_EQ(terrain.at(0.123, -4.5).slope_x, 0.0);
  EXPECT_EQ(terrain.friction(0.123, -4.5), 0.7);
}

// Uniform from 0 to h: mean h/2, variance h^2/12. Kim, Park, Oh 2007 lay tiles of 30 x 30 x 4 mm.
TEST(Terrain, TilesAreUniformUpToTheirHeightAndFlatOverTheirEdge) {
  const Terrain terrain(tiles(0.004), 0.7);
  double sum = 0.0;
  double square = 0.0;
  double neighbours = 0.0;
  constexpr int kTiles = 200;
  for (int x = 0; x < kTiles; ++x) {
    for (int y = 0; y < kTiles; ++y) {
      const double left_m = 0.03 * x - 3.0;
      const double height_m = terrain.height_m(left_m + 0.015, 0.03 * y + 0.015);
      ASSERT_GE(height_m, 0.0);
      ASSERT_LT(height_m, 0.004);
      EXPECT_EQ(terrain.height_m(left_m + 0.0001, 0.03 * y + 0.0299), height_m);
      sum += height_m;
      square += height_m * height_m;
      neighbours += (height_m - 0.002) * (terrain.height_m(left_m + 0.045, 0.03 * y + 0.015) - 0.002);
    }
  }
  constexpr double kCount = kTiles * kTiles;
  const double variance = 0.004 * 0.004 / 12.0;
  EXPECT_NEAR(sum / kCount, 0.002, 4.0 * std::sqrt(variance / kCount));
  EXPECT_NEAR(square / kCount - std::pow(sum / kCount, 2), variance, 0.02 * variance);
  EXPECT_NEAR(neighbours / kCount, 0.0, 4.0 * variance / std::sqrt(kCount));
}

// A sole on four corners: the plane of least squares through the four heights. Each slope is a sum of four independent
// uniform numbers, so its standard deviation is h / (sqrt(12) L); the largest, two high against two low, is h / L:
// 1.64 degrees across a sole of 140 mm, 0.98 along one of 233 mm, 2.0 over 114 mm.
TEST(Terrain, FourMillimetresTiltASoleByUpToTheDegreesOfTheGeometry) {
  const Terrain terrain(tiles(0.004), 0.7);
  EXPECT_NEAR(std::atan(0.004 / 0.114) * kDegreesPerRadian, 2.0, 0.02);
  for (const auto& [length_m, width_m] : {std::pair{0.233, 0.140}, {0.114, 0.114}}) {
    double pitch_square = 0.0;
    double roll_square = 0.0;
    double steepest_pitch = 0.0;
    double steepest_roll = 0.0;
    constexpr int kSoles = 20000;
    for (int i = 0; i < kSoles; ++i) {
      const double x_m = 0.31 * i;
      const std::array<double, 4> height{terrain.height_m(x_m + length_m, width_m), terrain.height_m(x_m + length_m, 0),
                                         terrain.height_m(x_m, width_m), terrain.height_m(x_m, 0)};
      const double pitch = (height[0] + height[1] - height[2] - height[3]) / (2.0 * length_m);
      const double roll = (height[0] - height[1] + height[2] - height[3]) / (2.0 * width_m);
      pitch_square += pitch * pitch / kSoles;
      roll_square += roll * roll / kSoles;
      steepest_pitch = std::max(steepest_pitch, std::abs(pitch));
      steepest_roll = std::max(steepest_roll, std::abs(roll));
    }
    EXPECT_NEAR(std::sqrt(pitch_square), 0.004 / (std::sqrt(12.0) * length_m), 0.02 * 0.004 / length_m);
    EXPECT_NEAR(std::sqrt(roll_square), 0.004 / (std::sqrt(12.0) * width_m), 0.02 * 0.004 / width_m);
    EXPECT_LE(steepest_pitch, 0.004 / length_m);
    EXPECT_GT(steepest_pitch, 0.85 * 0.004 / length_m);
    EXPECT_LE(steepest_roll, 0.004 / width_m);
    EXPECT_GT(steepest_roll, 0.85 * 0.004 / width_m);
  }
}

TEST(Terrain, IsTheSameForTheSameSeedAndAnotherForAnother) {
  const Terrain one(tiles(0.004, 7), 0.7);
  const Terrain same(tiles(0.004, 7), 0.7);
  const Terrain other(tiles(0.004, 8), 0.7);
  int equal = 0;
  for (int i = 0; i < 1000; ++i) {
    const double x_m = 0.03 * i + 0.01;
    EXPECT_EQ(one.height_m(x_m, -x_m), same.height_m(x_m, -x_m));
    equal += one.height_m(x_m, -x_m) == other.height_m(x_m, -x_m) ? 1 : 0;
  }
  EXPECT_EQ(equal, 0);
}

TEST(Terrain, HasNoEnd) {
  const Terrain terrain(tiles(0.004), 0.7);
  std::vector<double> heights;
  for (const double x_m : {1.0e4, -1.0e4, 1.0e8}) {
    for (int i = 0; i < 100; ++i) heights.push_back(terrain.height_m(x_m + 0.06 * i, -x_m));
  }
  std::ranges::sort(heights);
  EXPECT_EQ(std::ranges::adjacent_find(heights), heights.end()) << "no two tiles alike: no period, no border";
  for (const double nowhere : {1.0e300, -1.0e300, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(terrain.height_m(nowhere, 0.0), 0.0);
    EXPECT_EQ(terrain.height_m(0.0, nowhere), 0.0);
  }
}

// Each square of the size of a plate holds one with probability density times area; a plate covers such an area
// around it, and overlaps hide some: 1 - (1 - p/4-ish) has no neat form, so the share is that of a count of centres.
TEST(Terrain, ScattersAsManyPlatesOnASquareMetreAsAsked) {
  TerrainConfig config;
  config.plates_per_m2 = 5.0;
  const Terrain terrain(config, 0.7);
  int plates = 0;
  constexpr int kSquares = 300;
  for (int x = -kSquares / 2; x < kSquares / 2; ++x) {
    for (int y = 0; y < kSquares; ++y) {
      const auto centre = terrain.plate_centre_m({x, y});
      if (!centre) continue;
      ++plates;
      EXPECT_EQ(grid_cell((*centre)[0], (*centre)[1], 0.12).x, x);
      EXPECT_EQ(grid_cell((*centre)[0], (*centre)[1], 0.12).y, y);
      for (const double dx : {-0.0599, 0.0599}) {
        for (const double dy : {-0.0599, 0.0599}) {
          EXPECT_EQ(terrain.height_m((*centre)[0] + dx, (*centre)[1] + dy), 0.004);
        }
      }
    }
  }
  const double expected = 5.0 * std::pow(kSquares * 0.12, 2);
  EXPECT_NEAR(plates, expected, 4.0 * std::sqrt(expected));
}

TEST(Terrain, IsBareAwayFromThePlates) {
  TerrainConfig config;
  config.plates_per_m2 = 5.0;
  const Terrain terrain(config, 0.7);
  int bare = 0;
  constexpr int kPlaces = 100000;
  for (int i = 0; i < kPlaces; ++i) bare += terrain.height_m(0.0137 * i, 0.5) == 0.0 ? 1 : 0;
  // A point is bare when none of four quarters of the squares around it holds a centre near enough: for p = 0.072 and
  // a uniform centre that is the mean of (1-p a)(1-p b)(1-p c)(1-p d) with a + b + c + d = 1, 1 - p to first order.
  EXPECT_NEAR(static_cast<double>(bare) / kPlaces, 1.0 - 5.0 * 0.12 * 0.12, 0.02);
}

TEST(Terrain, APlateRaisesItsRectangleAndNothingElse) {
  const Terrain terrain = with_patches({{.centre_m = {2.0, -1.0}, .size_m = {0.4, 0.2}, .height_m = 0.01}});
  EXPECT_EQ(terrain.height_m(1.81, -1.09), 0.01);
  EXPECT_EQ(terrain.height_m(2.19, -0.91), 0.01);
  EXPECT_EQ(terrain.height_m(1.79, -1.0), 0.0);
  EXPECT_EQ(terrain.height_m(2.0, -0.89), 0.0);
  EXPECT_EQ(terrain.at(2.0, -1.0).slope_x, 0.0);
}

TEST(Terrain, ARampRisesAheadInAStraightLine) {
  const Terrain terrain =
      with_patches({{.kind = PatchKind::kRamp, .centre_m = {2.0, 0.0}, .size_m = {2.0, 1.0}, .height_m = 0.1}});
  for (const double x_m : {1.0, 1.3, 2.0, 2.99}) {
    EXPECT_NEAR(terrain.height_m(x_m, 0.2), 0.05 * (x_m - 1.0), 1e-15);
    EXPECT_DOUBLE_EQ(terrain.at(x_m, 0.2).slope_x, 0.05);
  }
  EXPECT_EQ(terrain.height_m(0.999, 0.0), 0.0);
  EXPECT_EQ(terrain.height_m(3.0, 0.0), 0.0);
}

TEST(Terrain, WherePatchesOverlapTheHighestCarriesAndTheLastWithAFrictionRubs) {
  const Terrain terrain = with_patches(
      {{.centre_m = {0, 0}, .size_m = {1, 1}, .height_m = 0.02, .friction = 0.3},
       {.kind = PatchKind::kFriction, .centre_m = {0, 0}, .size_m = {0.5, 0.5}, .height_m = 0.3, .friction = 0.05},
       {.centre_m = {0, 0}, .size_m = {0.2, 0.2}, .height_m = 0.01}});
  EXPECT_EQ(terrain.height_m(0.0, 0.0), 0.02);
  EXPECT_EQ(terrain.friction(0.0, 0.0), 0.05);
  EXPECT_EQ(terrain.friction(0.4, 0.4), 0.3);
  EXPECT_EQ(terrain.friction(0.6, 0.4), 0.7);
}

TEST(Terrain, PatchesLieOnTheTiles) {
  TerrainConfig config = tiles(0.004);
  const Terrain bare(config, 0.7);
  config.patches.push_back({.centre_m = {0, 0}, .size_m = {1, 1}, .height_m = 0.02});
  const Terrain covered(config, 0.7);
  EXPECT_DOUBLE_EQ(covered.height_m(0.2, 0.3), bare.height_m(0.2, 0.3) + 0.02);
}

}  // namespace
}  // namespace surefoot::sim_hw
