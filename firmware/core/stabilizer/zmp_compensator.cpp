#include "firmware/core/stabilizer/zmp_compensator.hpp"

#include <Eigen/Core>

#include "firmware/core/stabilizer/gradual.hpp"

namespace surefoot::stabilizer {
namespace {

constexpr double kGravity_m_s2 = 9.81;

/// Far beyond what the model holds for: keeps the state finite whatever the gains.
constexpr double kMaxLean_rad = 0.5;
constexpr double kMaxRate_rad_s = 5.0;

/// The observer x' = F x + G (u, y), sampled with u and y held: x <- x + integral (F x + G (u, y)).
struct Observer {
  Eigen::Matrix2d system;
  Eigen::Matrix2d input;
  Eigen::Matrix2d integral;  ///< of exp(F t) over one period
};

Observer observer(const ZmpCompensatorConfig& config, double mass_kg, double period_s) noexcept {
  const double length_m = config.pendulum_m;
  const double spring_per_s2 = config.stiffness_nm_per_rad / (mass_kg * length_m * length_m);
  const double zmp_m_per_rad = config.stiffness_nm_per_rad / (mass_kg * kGravity_m_s2);
  const Eigen::Vector2d gain{config.observer_gain[0], config.observer_gain[1]};
  Eigen::Matrix2d plant;
  plant << 0.0, 1.0, kGravity_m_s2 / length_m - spring_per_s2, 0.0;

  Observer result;
  result.system = plant - zmp_m_per_rad * gain * Eigen::RowVector2d{1.0, 0.0};
  result.input.col(0) = Eigen::Vector2d{0.0, spring_per_s2 / length_m} + gain * (zmp_m_per_rad / length_m);
  result.input.col(1) = gain;
  result.integral.setIdentity();
  // Exponential series; at 10 ms its ninth term is below 1e-9.
  for (int term = 9; term > 1; --term) {
    result.integral = Eigen::Matrix2d::Identity() + result.system * result.integral * (period_s / term);
  }
  result.integral *= period_s;
  return result;
}

void observe(const Observer& observer, ObservedLean& axis, double zmp_error_m) noexcept {
  const Eigen::Vector2d lean{axis.lean_rad, axis.rate_rad_s};
  const Eigen::Vector2d input{axis.offset_m, zmp_error_m};
  const Eigen::Vector2d after = lean + observer.integral * (observer.system * lean + observer.input * input);
  axis.lean_rad = within(after.x(), kMaxLean_rad);
  axis.rate_rad_s = within(after.y(), kMaxRate_rad_s);
}

}  // namespace

Adjustment step(const ZmpCompensatorConfig& config, ZmpCompensatorState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const bool is_usable = input.body_mass_kg > 0.0 && are_usable(input.body_mass_kg) && is_usable_period(input.period_s);
  if (is_usable && is_active && input.ankle[index(input.walk.support())].carries()) {
    const Observer sampled = observer(config, input.body_mass_kg, input.period_s);
    const double x_m = deviation(input.measured.zmp_x_foot_m, input.nominal.zmp_x_foot_m);
    const double y_m = deviation(input.measured.zmp_y_foot_m, input.nominal.zmp_y_foot_m);
    observe(sampled, state.x, within(x_m, config.max_zmp_error_m));
    observe(sampled, state.y, within(y_m, config.max_zmp_error_m));
  } else {
    const double share = low_pass_share(input.period_s, config.fade_s);
    for (ObservedLean* axis : {&state.x, &state.y}) {
      approach(axis->lean_rad, 0.0, share);
      approach(axis->rate_rad_s, 0.0, share);
    }
  }
  for (ObservedLean* axis : {&state.x, &state.y}) {
    const auto& gain = config.feedback_gain;
    axis->offset_m = within(-gain[0] * axis->lean_rad - gain[1] * axis->rate_rad_s, config.max_offset_m);
  }
  Adjustment adjustment;
  adjustment.pelvis_x_m = state.x.offset_m;
  adjustment.pelvis_y_m = state.y.offset_m;
  return adjustment;
}

}  // namespace surefoot::stabilizer
