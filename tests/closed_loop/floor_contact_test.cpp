// The same walk in two contact models that share nothing but the heights of the tiles: springs and dampers under the
// corners of the soles, and Bullet's rigid solver on boxes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/closed_loop/run_scenario.hpp"

namespace surefoot::run {
namespace {

constexpr int kSeeds = 8;

Verdict walk_on_tiles(const std::string& contact, int seed, std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(), {"contact.model=" + contact, "floor.tile_seed=" + std::to_string(seed)});
  return testing::run_scenario("khr2_uneven", overrides);
}

/// Means over the seeds of the torso's largest angles.
struct Lean {
  double roll_deg = 0.0;
  double pitch_deg = 0.0;
};

Lean mean_lean(const std::string& contact) {
  Lean mean;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    const Verdict walk = walk_on_tiles(contact, seed);
    EXPECT_EQ(walk.outcome, Outcome::kWalked) << contact << ", seed " << seed << ": " << walk.reason;
    mean.roll_deg += walk.torso_roll_deg.largest_magnitude() / kSeeds;
    mean.pitch_deg += walk.torso_pitch_deg.largest_magnitude() / kSeeds;
  }
  return mean;
}

// Kim, Park, Oh 2007, Fig. 24, case 4: tiles of 4 mm, 3 degrees, limit 2 degrees. Bullet's spheres of 10 mm meet a tile
// that is 4 mm higher up to 8 mm before its edge, so that of the tiles of 30 mm every second corner meets another one
// than in the springs' world: single walks differ as two draws of the tiles do in one world, up to 0.6 degrees. Their
// means over some draws differ by much less.
TEST(FloorContact, SpringsAndBulletsBoxesAgreeOnTilesOnASlope) {
  constexpr double kAsMeansOfEightDraws_deg = 0.3;
  const Lean springs = mean_lean("spring_damper");
  const Lean boxes = mean_lean("bullet");
  EXPECT_NEAR(boxes.roll_deg, springs.roll_deg, kAsMeansOfEightDraws_deg);
  EXPECT_NEAR(boxes.pitch_deg, springs.pitch_deg, kAsMeansOfEightDraws_deg);
  for (const Lean& lean : {springs, boxes}) {
    EXPECT_LE(lean.roll_deg, 2.0);
    EXPECT_LE(lean.pitch_deg, lean.roll_deg);
  }
}

// What they agree on is the controllers' work.
TEST(FloorContact, WithoutControllersTheRobotLeansTooFarInBoth) {
  for (const char* contact : {"spring_damper", "bullet"}) {
    const Verdict bare = walk_on_tiles(contact, 1, {"stabilizer.set=off", "pattern.standing_s=2"});
    EXPECT_NE(bare.outcome, Outcome::kWalked) << contact;
    EXPECT_GT(bare.torso_roll_deg.max, 5.0) << contact << ": downhill of a slope in roll";
    EXPECT_GT(bare.torso_pitch_deg.max, 5.0) << contact;
  }
}

}  // namespace
}  // namespace surefoot::run
