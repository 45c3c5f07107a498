#include "tools/run/stabilizer_message.hpp"

#include <gtest/gtest.h>

namespace surefoot::run {
namespace {

using stabilizer::Adjustment;
using stabilizer::Controller;

/// No two fields alike, and none of another row's.
Adjustment numbered(float first) {
  Adjustment adjustment;
  adjustment.pelvis_x_m = first + 1;
  adjustment.pelvis_y_m = first + 2;
  adjustment.pelvis_z_m = first + 3;
  adjustment.leg_length_m = {first + 4, first + 5};
  adjustment.ankle_roll_rad = {first + 6, first + 7};
  adjustment.ankle_pitch_rad = {first + 8, first + 9};
  adjustment.hip_roll_rad = {first + 10, first + 11};
  adjustment.landing_x_m = first + 12;
  adjustment.landing_y_m = first + 13;
  adjustment.sway_m = first + 14;
  adjustment.sway_centre_x_m = first + 15;
  adjustment.sway_centre_y_m = first + 16;
  adjustment.earlier_landing_s = first + 17;
  return adjustment;
}

void expect_numbered(const stabilizer_t& message, std::size_t row, float first) {
  SCOPED_TRACE(row);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(message.pelvis_m[row][axis], first + 1 + static_cast<float>(axis));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const auto next = static_cast<float>(i);
    EXPECT_EQ(message.leg_length_m[row][i], first + 4 + next);
    EXPECT_EQ(message.ankle_roll_rad[row][i], first + 6 + next);
    EXPECT_EQ(message.ankle_pitch_rad[row][i], first + 8 + next);
    EXPECT_EQ(message.hip_roll_rad[row][i], first + 10 + next);
    EXPECT_EQ(message.landing_m[row][i], first + 12 + next);
    EXPECT_EQ(message.sway_centre_m[row][i], first + 15 + next);
  }
  EXPECT_EQ(message.sway_m[row], first + 14);
  EXPECT_EQ(message.earlier_landing_s[row], first + 17);
}

TEST(StabilizerMessage, HasEachControllersFieldsInItsRowAndTheTotalInTheLast) {
  TickOutput output;
  for (std::size_t i = 0; i < stabilizer::kControllers; ++i) {
    output.floor.adjustment.of[i] = numbered(100.0F * static_cast<float>(i));
  }
  output.floor.adjustment.total = numbered(5000.0F);
  output.floor.adjustment.of[2].holds_lowering = true;
  output.floor.adjustment.of[3].waits_for_contact = true;
  const stabilizer_t message = stabilizer_message(-5, {}, output);
  EXPECT_EQ(message.utime, -5);
  for (std::size_t i = 0; i < stabilizer::kControllers; ++i) {
    expect_numbered(message, i, 100.0F * static_cast<float>(i));
    EXPECT_EQ(message.holds_lowering[i], i == 2 ? 1 : 0);
    EXPECT_EQ(message.waits_for_contact[i], i == 3 ? 1 : 0);
  }
  expect_numbered(message, stabilizer_t::TOTAL, 5000.0F);
  EXPECT_EQ(message.holds_lowering[stabilizer_t::TOTAL], 0);
}

// While a foot is lifted, damping may act and soft landing may not (Kim, Park, Oh 2007, Fig. 21).
TEST(StabilizerMessage, CallsAControllerActiveThatIsOnAndMayAct) {
  TickOutput output;
  output.floor.input.walk.stage = decision::WalkStage::kLiftRight;
  output.floor.input.walk.is_double_support = false;
  stabilizer::Switches is_on{};
  is_on[static_cast<std::size_t>(Controller::kDamping)] = true;
  is_on[static_cast<std::size_t>(Controller::kSoftLanding)] = true;
  const stabilizer_t message = stabilizer_message(0, is_on, output);
  for (std::size_t i = 0; i < stabilizer::kControllers; ++i) {
    EXPECT_EQ(message.is_on[i] != 0, is_on[i]) << i;
    EXPECT_EQ(message.is_active[i] != 0, i == static_cast<std::size_t>(Controller::kDamping)) << i;
  }
  EXPECT_EQ(message.stage, std::int8_t{stabilizer_t::STAGE_LIFT_RIGHT});
}

TEST(StabilizerMessage, KeepsTheFeetApartAndDividesMomentsByTheForceThatCarries) {
  TickOutput output;
  output.floor.input.ankle = {{{.normal_force_n = 500.0, .roll_moment_nm = 10.0, .pitch_moment_nm = -25.0},
                               {.normal_force_n = 40.0, .roll_moment_nm = 1.0, .pitch_moment_nm = 1.0}}};
  output.floor.input.hip_roll_rate_rad_s = {0.25, -0.5};
  output.floor.input.measured.torso_roll_rad = 0.125;
  output.floor.input.measured.torso_pitch_rad = -0.0625;
  const stabilizer_t message = stabilizer_message(0, {}, output);
  EXPECT_EQ(message.ankle_force_n[stabilizer_t::RIGHT], 500.0F);
  EXPECT_EQ(message.ankle_force_n[stabilizer_t::LEFT], 40.0F);
  EXPECT_FLOAT_EQ(message.zmp_x_foot_m[stabilizer_t::RIGHT], 0.05F);
  EXPECT_FLOAT_EQ(message.zmp_y_foot_m[stabilizer_t::RIGHT], 0.02F);
  EXPECT_EQ(message.zmp_x_foot_m[stabilizer_t::LEFT], 0.0F) << "below 5 kgf";
  EXPECT_EQ(message.hip_roll_rate_rad_s[stabilizer_t::RIGHT], 0.25F);
  EXPECT_EQ(message.hip_roll_rate_rad_s[stabilizer_t::LEFT], -0.5F);
  EXPECT_EQ(message.torso_roll_rad, 0.125F);
  EXPECT_EQ(message.torso_pitch_rad, -0.0625F);
}

}  // namespace
}  // namespace surefoot::run
