#include "firmware/core/stabilizer/nominal_table.hpp"

#include <algorithm>

namespace surefoot::stabilizer {
namespace {

constexpr double kRecordedStepLength_m = 0.2;

constexpr NominalTable kOnTheSpot{{{
#include "firmware/core/stabilizer/nominal_on_the_spot.inc"
}}};

constexpr NominalTable kForward{{{
#include "firmware/core/stabilizer/nominal_forward.inc"
}}};

constexpr NominalTable kPendulumOnTheSpot{{{
#include "firmware/core/stabilizer/nominal_on_the_spot_pendulum.inc"
}}};

constexpr NominalTable kPendulumForward{{{
#include "firmware/core/stabilizer/nominal_forward_pendulum.inc"
}}};

}  // namespace

PhaseSample mirrored(const PhaseSample& sample) noexcept {
  PhaseSample other = sample;
  other.torso_roll_rad = -sample.torso_roll_rad;
  other.torso_roll_rate_rad_s = -sample.torso_roll_rate_rad_s;
  other.zmp_y_foot_m = -sample.zmp_y_foot_m;
  other.support_roll_rate_rad_s = -sample.support_roll_rate_rad_s;
  return other;
}

PhaseSample between(const PhaseSample& a, const PhaseSample& b, double share) noexcept {
  const auto blend = [share](double from, double to) { return from + share * (to - from); };
  return {.torso_roll_rad = blend(a.torso_roll_rad, b.torso_roll_rad),
          .torso_pitch_rad = blend(a.torso_pitch_rad, b.torso_pitch_rad),
          .torso_roll_rate_rad_s = blend(a.torso_roll_rate_rad_s, b.torso_roll_rate_rad_s),
          .torso_pitch_rate_rad_s = blend(a.torso_pitch_rate_rad_s, b.torso_pitch_rate_rad_s),
          .zmp_x_foot_m = blend(a.zmp_x_foot_m, b.zmp_x_foot_m),
          .zmp_y_foot_m = blend(a.zmp_y_foot_m, b.zmp_y_foot_m),
          .support_roll_rate_rad_s = blend(a.support_roll_rate_rad_s, b.support_roll_rate_rad_s)};
}

PhaseSample NominalTable::at(Side stepping, double step_share) const noexcept {
  const double place = std::clamp(step_share, 0.0, 1.0) * static_cast<double>(kPlaces);
  const std::size_t before = std::min(static_cast<std::size_t>(place), kPlaces - 1);
  const PhaseSample& after = before + 1 < kPlaces ? of_left_step[before + 1] : of_left_step[before];
  const PhaseSample sample = between(of_left_step[before], after, place - static_cast<double>(before));
  return stepping == Side::kLeft ? sample : mirrored(sample);
}

NominalTable recorded_table(gait::SwayProfile sway, double step_length_m) noexcept {
  const bool is_sine = sway == gait::SwayProfile::kSine;
  const NominalTable& on_the_spot = is_sine ? kOnTheSpot : kPendulumOnTheSpot;
  const NominalTable& forward = is_sine ? kForward : kPendulumForward;
  NominalTable table;
  for (std::size_t i = 0; i < NominalTable::kPlaces; ++i) {
    table.of_left_step[i] =
        between(on_the_spot.of_left_step[i], forward.of_left_step[i], step_length_m / kRecordedStepLength_m);
  }
  return table;
}

}  // namespace surefoot::stabilizer
