#pragma once

#include <cmath>

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// What the stabiliser sees of a walk on flat floor with steps of 0.95 s, 5 % of them in double support (Kim, Park, Oh
/// 2007, Table 3). Every deviation from flat walking is added by the test.
class FlatWalk {
 public:
  static constexpr double kStep_s = 0.95;
  static constexpr double kDouble_s = 0.0475;
  static constexpr double kWeight_n = 56.0 * 9.81;

  explicit FlatWalk(double period_s) : period_s_{period_s} {}

  /// The input of the next tick.
  StabilizerInput next() {
    StabilizerInput input;
    input.period_s = period_s_;
    WalkView& walk = input.walk;
    const bool swings_left = step_ % 2 == 0;
    walk.begins_step = time_s_ < 0.5 * period_s_;
    walk.step_time_s = time_s_;
    walk.step_share = time_s_ / kStep_s;
    walk.is_double_support = time_s_ < kDouble_s;
    if (walk.is_double_support) {
      walk.moving = swings_left ? Side::kRight : Side::kLeft;
      walk.stage = swings_left ? decision::WalkStage::kLowerRight : decision::WalkStage::kLowerLeft;
      walk.swing_share = 1.0;
      walk.has_landed = true;
      walk.since_landing_s = time_s_;
    } else {
      walk.moving = swings_left ? Side::kLeft : Side::kRight;
      walk.swing_share = (time_s_ - kDouble_s) / (kStep_s - kDouble_s);
      const bool lowers = walk.swing_share >= 0.5;
      if (swings_left) {
        walk.stage = lowers ? decision::WalkStage::kLowerLeft : decision::WalkStage::kLiftLeft;
      } else {
        walk.stage = lowers ? decision::WalkStage::kLowerRight : decision::WalkStage::kLiftRight;
      }
    }
    load(input);
    const double swing = std::sin(M_PI * walk.step_share) * (swings_left ? 1.0 : -1.0);
    input.nominal = {0.01 * swing, 0.004, 0.03 * swing, 0.01 * swing, 0.005, 0.02 * swing, 0.1 * swing};
    input.measured = input.nominal;
    time_s_ += period_s_;
    if (time_s_ > kStep_s - 0.5 * period_s_) {
      time_s_ = 0.0;
      ++step_;
    }
    return input;
  }

 private:
  static void load(StabilizerInput& input) {
    const WalkView& walk = input.walk;
    const double shared = walk.is_double_support ? 0.5 : 0.0;
    input.ankle[index(walk.moving)].normal_force_n = shared * kWeight_n;
    input.ankle[index(walk.support())].normal_force_n = (1.0 - shared) * kWeight_n;
  }

  double period_s_;
  double time_s_ = 0.0;
  int step_ = 0;
};

/// One foot carries, the other is on its way up: every controller of stages 1 and 3 may act for as long as one likes.
inline StabilizerInput standing_on(Side support, double period_s) {
  StabilizerInput input;
  input.period_s = period_s;
  input.walk.moving = opposite(support);
  input.walk.stage = support == Side::kRight ? decision::WalkStage::kLiftLeft : decision::WalkStage::kLiftRight;
  input.walk.is_double_support = false;
  input.walk.swing_share = 0.3;
  input.walk.step_share = 0.3;
  input.walk.step_time_s = 0.3 * FlatWalk::kStep_s;
  input.ankle[index(support)].normal_force_n = FlatWalk::kWeight_n;
  return input;
}

/// The foot is on its way down, later than `standing_on`.
inline StabilizerInput coming_down(Side moving, double period_s) {
  StabilizerInput input = standing_on(opposite(moving), period_s);
  input.walk.stage = moving == Side::kLeft ? decision::WalkStage::kLowerLeft : decision::WalkStage::kLowerRight;
  input.walk.swing_share = 0.8;
  return input;
}

}  // namespace surefoot::stabilizer
