#pragma once

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer::testing {

inline constexpr double kDegree = 0.017453292519943295;

/// The moving foot goes up; `share` of the swing is done.
inline StabilizerInput lifting(Side foot, double share, double period_s = 1e-3) {
  StabilizerInput input;
  input.period_s = period_s;
  input.walk.stage = foot == Side::kLeft ? decision::WalkStage::kLiftLeft : decision::WalkStage::kLiftRight;
  input.walk.moving = foot;
  input.walk.is_double_support = false;
  input.walk.swing_share = share;
  input.walk.step_time_s = 0.0475 + 0.9025 * share;
  input.walk.step_share = input.walk.step_time_s / 0.95;
  input.ankle[index(opposite(foot))].normal_force_n = 549.0;
  return input;
}

/// It comes down and carries nothing yet.
inline StabilizerInput lowering(Side foot, double share, double period_s = 1e-3) {
  StabilizerInput input = lifting(foot, share, period_s);
  input.walk.stage = foot == Side::kLeft ? decision::WalkStage::kLowerLeft : decision::WalkStage::kLowerRight;
  return input;
}

/// It has landed at the end of its swing and carries `force_n`.
inline StabilizerInput landed(Side foot, double force_n, double period_s = 1e-3) {
  StabilizerInput input = lowering(foot, 1.0, period_s);
  input.walk.is_double_support = true;
  input.walk.has_landed = true;
  input.ankle[index(foot)].normal_force_n = force_n;
  return input;
}

inline StabilizerInput standing(double period_s = 1e-3) {
  StabilizerInput input;
  input.period_s = period_s;
  input.walk.has_landed = true;
  return input;
}

}  // namespace surefoot::stabilizer::testing
