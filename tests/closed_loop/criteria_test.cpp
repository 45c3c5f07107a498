#include "tools/floor/criteria.hpp"

#include <gtest/gtest.h>

#include "tools/floor/floor_cases.hpp"

namespace surefoot::floor {
namespace {

Criteria measured(const std::string& controller, const std::vector<std::uint64_t>& seeds = {1}, unsigned jobs = 0) {
  CriteriaOptions options;
  options.jobs = jobs;
  return measure(criterion_experiments(seeds, controller), base_of({}, {}), options);
}

// Kim, Park, Oh 2007, eqs. (8), (9): 3.72 mm on each leg and 3 degrees on each ankle on a slope of 3 degrees.
TEST(EachController, UprightPoseReachesLegLengthsAndAnglesOfTheSlope) {
  const Criteria criteria = measured("upright_pose");
  ASSERT_EQ(criteria.rows.size(), 5U);
  for (const CriterionRow& row : criteria.rows) {
    EXPECT_EQ(row.verdict(), CriterionVerdict::kHolds) << row.what << ": " << row.on.mean;
  }
  EXPECT_NEAR(criteria.rows[4].off.mean, 3.0, 0.2) << "without it the torso leans as the floor";
  EXPECT_LT(criteria.rows[4].on.mean, 0.3);
}

TEST(EachController, ShockAbsorberTakesAThirdOffTheForceOfEarlyLandings) {
  const Criteria criteria = measured("shock_absorber", {1, 8});  // it walks on these tiles with and without it
  ASSERT_EQ(criteria.rows.size(), 2U);
  const CriterionRow& alone = criteria.rows[0];
  EXPECT_GE(alone.off.samples, 10U);
  EXPECT_EQ(alone.verdict(), CriterionVerdict::kHolds) << alone.off.mean << " N, " << alone.on.mean << " N";
}

// Kim, Park, Oh 2007, Fig. 20: the lifted leg's vibration, gone after a second.
TEST(EachController, VibrationReductionStillsTheLegOnItsFlexibleHip) {
  const Criteria criteria = measured("vibration_reduction");
  ASSERT_EQ(criteria.rows.size(), 1U);
  EXPECT_EQ(criteria.rows[0].verdict(), CriterionVerdict::kHolds) << criteria.rows[0].on.mean << " % are left";
  EXPECT_GT(criteria.rows[0].off.mean, 5.0) << "without the controller it goes on";
  const Criteria again = measured("vibration_reduction", {1}, 1);
  EXPECT_EQ(to_json(again), to_json(criteria)) << "whatever the number of threads";
}

}  // namespace
}  // namespace surefoot::floor
