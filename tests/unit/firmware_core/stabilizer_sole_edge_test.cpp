#include <gtest/gtest.h>

#include <cmath>

#include "firmware/core/stabilizer/attitude_feedback.hpp"
#include "firmware/core/stabilizer/foot_tilt.hpp"
#include "firmware/core/stabilizer/sole_edge.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr SoleSize kSole{.toe_m = 0.13, .heel_m = 0.10, .half_width_m = 0.07};
constexpr EdgeLimits kLimits{.margin_m = 0.01, .band_m = 0.02};

estimation::AnkleLoad load_at(double x_m, double y_m, double force_n = 500.0) {
  return {.normal_force_n = force_n, .roll_moment_nm = y_m * force_n, .pitch_moment_nm = -x_m * force_n};
}

TEST(SoleEdge, FadesOverTheBandBeforeEachEdgeAndIsNothingInItsMargin) {
  for (const double way_m : {0.0, 0.005, 0.01, 0.02, 0.03, 0.05}) {
    const double expected = std::clamp((way_m - 0.01) / 0.02, 0.0, 1.0);
    EXPECT_NEAR(edge_room(kLimits, kSole, load_at(0.13 - way_m, 0.0)).front, expected, 1e-12) << way_m;
    EXPECT_NEAR(edge_room(kLimits, kSole, load_at(way_m - 0.10, 0.0)).rear, expected, 1e-12) << way_m;
    EXPECT_NEAR(edge_room(kLimits, kSole, load_at(0.0, 0.07 - way_m)).left, expected, 1e-12) << way_m;
    EXPECT_NEAR(edge_room(kLimits, kSole, load_at(0.0, way_m - 0.07)).right, expected, 1e-12) << way_m;
  }
}

TEST(SoleEdge, LeavesTheWayBackFromAnEdgeFree) {
  const EdgeRoom room = edge_room(kLimits, kSole, load_at(0.13, 0.07));
  EXPECT_EQ(room.front, 0.0);
  EXPECT_EQ(room.rear, 1.0);
  EXPECT_EQ(room.left, 0.0);
  EXPECT_EQ(room.right, 1.0);
  EXPECT_EQ(room.along(), 0.0);
  EXPECT_EQ(room.across(), 0.0);
}

TEST(SoleEdge, DoesNotBindAFootInTheAirAndBindsOneWhoseLoadIsNoNumber) {
  const EdgeRoom in_air = edge_room(kLimits, kSole, load_at(0.13, 0.07, 1.0));
  EXPECT_EQ(in_air.along() + in_air.across(), 2.0);
  estimation::AnkleLoad broken = load_at(0.0, 0.0);
  broken.roll_moment_nm = std::nan("");
  EXPECT_EQ(edge_room(kLimits, kSole, broken).across(), 0.0);
  EXPECT_EQ(edge_room({.margin_m = 0.01, .band_m = 0.0}, kSole, load_at(0.0, 0.0)).across(), 1.0);
}

/// Turn of the ankle after a while, for a ZMP at this place of the only foot that carries.
Adjustment answered(double roll_rad, double pitch_rad, double zmp_x_m, double zmp_y_m) {
  AttitudeFeedbackState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.measured.torso_roll_rad = roll_rad;
  input.measured.torso_pitch_rad = pitch_rad;
  input.ankle[index(Side::kLeft)] = load_at(zmp_x_m, zmp_y_m);
  Adjustment adjustment;
  for (int k = 0; k < 1000; ++k) adjustment = step(AttitudeFeedbackConfig{}, state, input, true);
  return adjustment;
}

// A torso that leans right is answered by a turn that moves the ZMP right; one that leans forward, to the front.
TEST(SoleEdge, KeepsTheAttitudeFeedbackFromTippingAFootOverTheEdgeItStandsOn) {
  const double all_rad = 1.8 * 0.01;
  EXPECT_NEAR(answered(0.01, 0.0, 0.0, 0.0).ankle_roll_rad[1], all_rad, 1e-6);
  EXPECT_EQ(answered(0.01, 0.0, 0.0, -0.07).ankle_roll_rad[1], 0.0);
  EXPECT_NEAR(answered(0.01, 0.0, 0.0, 0.07).ankle_roll_rad[1], all_rad, 1e-6);
  EXPECT_EQ(answered(-0.01, 0.0, 0.0, 0.07).ankle_roll_rad[1], 0.0);
  EXPECT_EQ(answered(0.0, 0.01, 0.128, 0.0).ankle_pitch_rad[1], 0.0);
  EXPECT_NEAR(answered(0.0, 0.01, -0.105, 0.0).ankle_pitch_rad[1], all_rad, 1e-6);
  EXPECT_EQ(answered(0.0, -0.01, -0.105, 0.0).ankle_pitch_rad[1], 0.0);
}

TEST(SoleEdge, KeepsTheFootTiltFromFollowingAFootThatTips) {
  const FootTiltConfig config{.slope_time_constant_s = 1e9, .edge = {}};
  FootTiltState state;
  StabilizerInput input = standing_on(Side::kLeft, 1.0e-3);
  input.foot_roll_rad = {0.0, 0.02};
  Adjustment adjustment;
  for (int k = 0; k < 1000; ++k) adjustment = step(config, state, input, true);
  const double followed_rad = adjustment.ankle_roll_rad[1];
  EXPECT_NEAR(followed_rad, 0.7 * 0.02, 1e-6);
  input.ankle[index(Side::kLeft)] = load_at(0.0, -0.065);
  input.foot_roll_rad = {0.0, 0.08};
  for (int k = 0; k < 1000; ++k) adjustment = step(config, state, input, true);
  EXPECT_EQ(adjustment.ankle_roll_rad[1], followed_rad);
}

}  // namespace
}  // namespace surefoot::stabilizer
