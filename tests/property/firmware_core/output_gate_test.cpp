#include "firmware/core/safety/output_gate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace surefoot::safety {
namespace {

constexpr double kPeriodS = 1.0e-3;

/// Mostly sane numbers, sometimes the worst that a double can be, any bit pattern among them.
double any_number(double sane) {
  using Limits = std::numeric_limits<double>;
  const int kind = *rc::gen::inRange(0, 4000);
  if (kind == 0) return *rc::gen::element(Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity());
  if (kind == 1) return *rc::gen::element(Limits::max(), Limits::lowest(), Limits::denorm_min(), -0.0);
  if (kind == 2) return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return sane * (*rc::gen::inRange(-1000, 1001)) * 1e-3;
}

Freshness any_freshness() {
  const int kind = *rc::gen::inRange(0, 600);
  if (kind == 0) return {Freshness::kNeverHeard};
  if (kind == 1) return {*rc::gen::arbitrary<std::uint32_t>()};
  return {kind < 30 ? *rc::gen::inRange(1U, 12U) : 0U};
}

SensorSnapshot any_sensors() {
  SensorSnapshot sensors;
  for (LegSensors& leg : sensors.leg) {
    for (double& angle : leg.angle_rad) angle = any_number(0.019);
    for (double& rate : leg.rate_rad_s) rate = any_number(24.0);
    leg.freshness = any_freshness();
  }
  for (FootSensors& foot : sensors.foot) foot.freshness = any_freshness();
  sensors.torso.freshness = any_freshness();
  return sensors;
}

GateOrders any_orders() {
  const int kind = *rc::gen::inRange(0, 100);
  const Fault fault = *rc::gen::element(Fault::kSecondMaster, Fault::kLoopOverrun, Fault::kSensorImplausible);
  return {.reported = kind == 0 ? finding_of(fault) : Finding{}, .is_waiting_for_posture = kind == 1};
}

PerSide<LegVector> any_torques() {
  PerSide<LegVector> torques{};
  for (LegVector& leg : torques) {
    for (double& torque : leg) torque = any_number(400.0);
  }
  return torques;
}

RC_GTEST_PROP(OutputGate, IsFiniteWithinItsLimitsAndSilentOnceItDampsWhateverComesIn, ()) {
  OutputGateConfig config;
  config.torque_rate_limit_nm_s = *rc::gen::element(1.0e4, 7.0e4, 2.0e5, 1.0e9);
  OutputGateState state;
  PerSide<LegVector> previous_nm{};
  Finding first;
  const int ticks = *rc::gen::inRange(1, 60);
  for (int tick = 0; tick < ticks; ++tick) {
    const PerSide<LegCommand> command =
        step(config, state, {.torque_nm = any_torques()}, any_sensors(), any_orders(), kPeriodS);
    if (first.fault != Fault::kNone) RC_ASSERT(state.latched.fault == first.fault);
    RC_ASSERT(state.latched.needs >= first.needs);
    first = state.latched;
    RC_ASSERT(command[0].mode == command[1].mode);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      RC_ASSERT(command[leg].torque_nm == state.last_torque_nm[leg]);
      for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
        const double torque = command[leg].torque_nm[joint];
        RC_ASSERT(std::isfinite(torque));
        RC_ASSERT(std::abs(torque) <= config.torque_limit_nm);
        if (command[leg].mode == LegMode::kDamp) {
          RC_ASSERT(torque == 0.0);
        } else {
          RC_ASSERT(first.needs != SafeState::kDamp);
          RC_ASSERT(std::abs(torque - previous_nm[leg][joint]) <= config.torque_rate_limit_nm_s * kPeriodS + 1e-9);
        }
        previous_nm[leg][joint] = torque;
      }
    }
    if (first.needs == SafeState::kDamp) RC_ASSERT(command[0].mode == LegMode::kDamp);
  }
  RC_CLASSIFY(first.needs == SafeState::kDamp, "damps");
  RC_CLASSIFY(first.needs == SafeState::kStanceHold, "holds its stance");
}

WantedMotion any_motion() {
  WantedMotion wanted{.mode = *rc::gen::element(LegMode::kPosition, LegMode::kPosition, LegMode::kTorque)};
  wanted.torque_nm = any_torques();
  for (LegVector& leg : wanted.angle_rad) {
    for (double& angle : leg) angle = any_number(4.0);
  }
  return wanted;
}

RC_GTEST_PROP(OutputGate, SendsAnglesInRangeAndWithoutAJumpWhateverComesIn, ()) {
  const OutputGateConfig config;
  OutputGateState state;
  PerSide<LegVector> previous_rad{};
  PerSide<bool> goes_on{};
  const int ticks = *rc::gen::inRange(1, 60);
  for (int tick = 0; tick < ticks; ++tick) {
    const WantedMotion wanted = any_motion();
    const SensorSnapshot sensors = any_sensors();
    const PerSide<LegCommand> command = step(config, state, wanted, sensors, any_orders(), kPeriodS);
    for (std::size_t leg = 0; leg < 2; ++leg) {
      RC_ASSERT(command[leg].mode == LegMode::kDamp || command[leg].mode == wanted.mode);
      const bool has_angles = command[leg].mode == LegMode::kPosition;
      const LegVector& from_rad = goes_on[leg] ? previous_rad[leg] : sensors.leg[leg].angle_rad;
      for (std::size_t joint = 0; has_angles && joint < kJointsPerLeg; ++joint) {
        const double angle = command[leg].angle_rad[joint];
        RC_ASSERT(angle >= config.angle_min_rad[joint] && angle <= config.angle_max_rad[joint]);
        RC_ASSERT(std::abs(angle - from_rad[joint]) <= config.reference_rate_limit_rad_s * kPeriodS + 1e-12);
      }
      previous_rad[leg] = command[leg].angle_rad;
      goes_on[leg] = has_angles;
    }
  }
  RC_CLASSIFY(goes_on[0], "ends with angles");
}

}  // namespace
}  // namespace surefoot::safety
