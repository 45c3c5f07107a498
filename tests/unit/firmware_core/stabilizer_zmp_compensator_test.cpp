#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "firmware/core/stabilizer/zmp_compensator.hpp"
#include "tests/unit/firmware_core/compliant_ankle.hpp"
#include "tests/unit/firmware_core/flat_walk.hpp"

namespace surefoot::stabilizer {
namespace {

const ZmpCompensatorConfig kConfig{};

/// ZMP / U = -(K / (m g l)) (s^2 - g/l) / (s^2 + K/(m l^2) - g/l), U the pelvis' offset in metres.
double zmp_gain(double stiffness_nm_per_rad, double s2_per_s2) {
  const double unstable = CompliantAnkle::kGravity_m_s2 / CompliantAnkle::kLength_m;
  const CompliantAnkle plant{.stiffness_nm_per_rad = stiffness_nm_per_rad};
  return -stiffness_nm_per_rad / (CompliantAnkle::kWeight_n * CompliantAnkle::kLength_m) * (s2_per_s2 - unstable) /
         (s2_per_s2 + plant.spring_per_s2() - unstable);
}

TEST(ZmpCompensator, StandsOnAModelWithThePrintedGainAtRestAndTheRigidLimit) {
  EXPECT_NEAR(zmp_gain(2450.0, 0.0), 1.253, 1e-3);
  const double l_by_g = CompliantAnkle::kLength_m / CompliantAnkle::kGravity_m_s2;
  for (const double s2 : {0.0, -4.0, -11.0}) EXPECT_NEAR(zmp_gain(1e9, s2), 1.0 - l_by_g * s2, 1e-4);
  // The plant of these tests rests where the gain says.
  CompliantAnkle plant;
  const double offset_m = 0.01;
  const double command_rad = offset_m / CompliantAnkle::kLength_m;
  plant.lean_rad = plant.spring_per_s2() * command_rad / (plant.mode_rad_s() * plant.mode_rad_s());
  EXPECT_NEAR(plant.zmp_m(command_rad), 1.253 * offset_m, 1e-5);
}

// Two equal poles: their sum and their product are what the gains' three decimals decide.
TEST(ZmpCompensator, HasGainsThatPlaceThePolesAtMinusFourAndMinusEight) {
  const CompliantAnkle plant;
  Eigen::Matrix2d system;
  system << 0.0, 1.0, -plant.mode_rad_s() * plant.mode_rad_s(), 0.0;
  const Eigen::Vector2d input{0.0, plant.spring_per_s2() / CompliantAnkle::kLength_m};
  const Eigen::RowVector2d output{plant.stiffness_nm_per_rad / CompliantAnkle::kWeight_n, 0.0};
  const Eigen::Matrix2d fed_back =
      system - input * Eigen::RowVector2d{kConfig.feedback_gain[0], kConfig.feedback_gain[1]};
  EXPECT_NEAR(fed_back.trace(), -8.0, 0.05);
  EXPECT_NEAR(fed_back.determinant(), 16.0, 0.05);
  const Eigen::Matrix2d observed =
      system - Eigen::Vector2d{kConfig.observer_gain[0], kConfig.observer_gain[1]} * output;
  EXPECT_NEAR(observed.trace(), -16.0, 0.05);
  EXPECT_NEAR(observed.determinant(), 64.0, 0.05);
}

/// One tick of the plant under the controller, on the lateral or the sagittal axis.
void tick(const ZmpCompensatorConfig& config, ZmpCompensatorState& state, CompliantAnkle& plant, double period_s,
          bool is_lateral) {
  StabilizerInput input = standing_on(Side::kRight, period_s);
  const double before_m = is_lateral ? state.y.offset_m : state.x.offset_m;
  const double zmp_m = plant.zmp_m(before_m / CompliantAnkle::kLength_m);
  (is_lateral ? input.measured.zmp_y_foot_m : input.measured.zmp_x_foot_m) = zmp_m;
  const Adjustment adjustment = step(config, state, input, true);
  const double offset_m = is_lateral ? adjustment.pelvis_y_m : adjustment.pelvis_x_m;
  plant.advance(offset_m / CompliantAnkle::kLength_m, period_s);
}

// Started with the truth, the observer keeps it and the loop has two poles at -4: phi = phi0 (1 + 4 t) exp(-4 t).
TEST(ZmpCompensator, BringsALeanBackAsTwoPolesAtMinusFourDo) {
  for (const bool is_lateral : {true, false}) {
    ZmpCompensatorState state;
    CompliantAnkle plant{.lean_rad = 0.01};
    ObservedLean& axis = is_lateral ? state.y : state.x;
    axis = {0.01, 0.0, -kConfig.feedback_gain[0] * 0.01};
    for (int k = 1; k <= 4000; ++k) {
      tick(kConfig, state, plant, 0.25e-3, is_lateral);
      const double time_s = 0.25e-3 * k;
      ASSERT_NEAR(plant.lean_rad, 0.01 * (1.0 + 4.0 * time_s) * std::exp(-4.0 * time_s), 1e-4) << time_s;
    }
  }
}

// Without feedback the error of the observer runs as two poles at -8: e = e0 (1 - 8 t) exp(-8 t), however the body
// moves.
TEST(ZmpCompensator, FindsTheLeanAsTwoPolesAtMinusEightDo) {
  ZmpCompensatorConfig config;
  config.feedback_gain = {0.0, 0.0};
  ZmpCompensatorState state;
  CompliantAnkle plant{.lean_rad = 0.01};
  for (int k = 1; k <= 4000; ++k) {
    tick(config, state, plant, 0.25e-3, true);
    const double time_s = 0.25e-3 * k;
    ASSERT_NEAR(plant.lean_rad - state.y.lean_rad, 0.01 * (1.0 - 8.0 * time_s) * std::exp(-8.0 * time_s), 1e-4);
  }
}

// With its input held the observer is sampled exactly.
TEST(ZmpCompensator, ObservesTheSameAtEveryPeriod) {
  ZmpCompensatorConfig config;
  config.feedback_gain = {0.0, 0.0};
  ZmpCompensatorState fine;
  StabilizerInput input = standing_on(Side::kRight, 0.25e-3);
  input.measured.zmp_y_foot_m = 0.02;
  for (int k = 0; k < 400; ++k) (void)step(config, fine, input, true);
  ZmpCompensatorState coarse;
  input.period_s = 10.0e-3;
  for (int k = 0; k < 10; ++k) (void)step(config, coarse, input, true);
  EXPECT_NEAR(fine.y.lean_rad, coarse.y.lean_rad, 1e-9);
  EXPECT_NEAR(fine.y.rate_rad_s, coarse.y.rate_rad_s, 1e-9);
}

TEST(ZmpCompensator, EndsASwingAtEveryPeriod) {
  for (const double period_s : {0.25e-3, 1.0e-3, 10.0e-3}) {
    ZmpCompensatorState state;
    CompliantAnkle plant{.lean_rad = 0.01};
    const double before = plant.energy();
    for (double time_s = 0.0; time_s < 2.0; time_s += period_s) tick(kConfig, state, plant, period_s, true);
    EXPECT_LT(plant.energy(), 1e-3 * before) << period_s;
  }
}

TEST(ZmpCompensator, ClipsItsOffset) {
  ZmpCompensatorState state;
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.measured.zmp_x_foot_m = 10.0;
  input.measured.zmp_y_foot_m = -10.0;
  double largest_m = 0.0;
  for (int k = 0; k < 5000; ++k) {
    const Adjustment adjustment = step(kConfig, state, input, true);
    largest_m = std::max({largest_m, std::abs(adjustment.pelvis_x_m), std::abs(adjustment.pelvis_y_m)});
    ASSERT_NEAR(adjustment.pelvis_x_m, -adjustment.pelvis_y_m, 1e-12);
  }
  EXPECT_LE(largest_m, 0.05);
}

TEST(ZmpCompensator, LetsGoOfTheZmpOfAFootThatDoesNotCarry) {
  ZmpCompensatorState state;
  StabilizerInput input = standing_on(Side::kRight, 1.0e-3);
  input.measured.zmp_y_foot_m = 0.05;
  for (int k = 0; k < 300; ++k) (void)step(kConfig, state, input, true);
  EXPECT_GT(std::abs(state.y.offset_m), 1e-3);
  input.ankle[index(Side::kRight)].normal_force_n = 40.0;
  for (int k = 0; k < 2000; ++k) (void)step(kConfig, state, input, true);
  EXPECT_NEAR(state.y.offset_m, 0.0, 1e-8);
}

TEST(ZmpCompensator, SurvivesGainsThatNoPlantCouldLiveWith) {
  ZmpCompensatorConfig config;
  config.observer_gain = {-100.0, -1000.0};
  ZmpCompensatorState state;
  StabilizerInput input = standing_on(Side::kRight, 10.0e-3);
  input.measured.zmp_y_foot_m = 0.05;
  for (int k = 0; k < 10000; ++k) ASSERT_LE(std::abs(step(config, state, input, true).pelvis_y_m), 0.05);
}

}  // namespace
}  // namespace surefoot::stabilizer
