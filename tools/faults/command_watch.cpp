#include "tools/faults/command_watch.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::faults {
namespace {

constexpr double kTolerance = 1e-9;  // N m, rad

}  // namespace

CommandWatch::CommandWatch(const safety::OutputGateConfig& gate, double period_s) noexcept
    : gate_(gate), period_s_(period_s) {}

void CommandWatch::observe(const PerSide<LegCommand>& command, const PerSide<LegSensors>& legs) noexcept {
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    watch_torques(command[i], last_torque_nm_[i]);
    if (command[i].mode == LegMode::kPosition) watch_angles(command[i], last_[i], legs[i]);
  }
  last_ = command;
  if (extremes_.torque_nm > gate_.torque_limit_nm + kTolerance) extremes_.is_within_gate = false;
  if (extremes_.torque_step_nm > gate_.torque_rate_limit_nm_s * period_s_ + kTolerance) {
    extremes_.is_within_gate = false;
  }
  if (extremes_.angle_step_rad > gate_.reference_rate_limit_rad_s * period_s_ + kTolerance) {
    extremes_.is_within_gate = false;
  }
}

void CommandWatch::watch_torques(const LegCommand& now, LegVector& last_nm) noexcept {
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    const double torque_nm = now.mode == LegMode::kTorque ? now.torque_nm[joint] : 0.0;
    if (!std::isfinite(torque_nm)) extremes_.is_within_gate = false;
    extremes_.torque_nm = std::max(extremes_.torque_nm, std::abs(torque_nm));
    if (now.mode == LegMode::kTorque) {
      extremes_.torque_step_nm = std::max(extremes_.torque_step_nm, std::abs(torque_nm - last_nm[joint]));
    }
    last_nm[joint] = torque_nm;
  }
}

void CommandWatch::watch_angles(const LegCommand& now, const LegCommand& last, const LegSensors& leg) noexcept {
  const bool begins = last.mode != LegMode::kPosition || (leg.freshness.is_fresh() && leg.is_damping);
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    const double least_rad = gate_.angle_min_rad[joint];
    const double most_rad = gate_.angle_max_rad[joint];
    const double angle_rad = now.angle_rad[joint];
    const bool is_in_range = angle_rad >= least_rad - kTolerance && angle_rad <= most_rad + kTolerance;
    if (!is_in_range) extremes_.is_within_gate = false;  // nor is NaN
    const double from_rad = begins ? std::clamp(leg.angle_rad[joint], least_rad, most_rad) : last.angle_rad[joint];
    extremes_.angle_step_rad = std::max(extremes_.angle_step_rad, std::abs(angle_rad - from_rad));
  }
}

}  // namespace surefoot::faults
