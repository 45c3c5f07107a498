#include "firmware/core/stabilizer/attitude_feedback.hpp"

#include <cmath>

#include "firmware/core/stabilizer/nominal_table.hpp"

namespace surefoot::stabilizer {
namespace {

/// Share of each foot that carries; 0 for one that does not.
PerSide<double> load_share(const StabilizerInput& input) noexcept {
  PerSide<double> force_n{};
  for (const Side side : kSides) {
    const auto& load = input.ankle[index(side)];
    force_n[index(side)] = load.carries() ? sound_or_zero(load.normal_force_n) : 0.0;
  }
  const double sum_n = force_n[0] + force_n[1];
  if (!(sum_n > 0.0)) return {};
  return {force_n[0] / sum_n, force_n[1] / sum_n};
}

double against_rad(const AttitudeFeedbackConfig& config, double angle_rad, double rate_rad_s) noexcept {
  return within(config.gain * (angle_rad + config.rate_gain_s * rate_rad_s), config.max_angle_rad);
}

/// Goes toward `target`, more slowly in a direction where there is little room.
double turned(double angle_rad, double target_rad, double room_above, double room_below, double rate_rad_s,
              double period_s) noexcept {
  const double room = target_rad > angle_rad ? room_above : room_below;
  return room > 0.0 ? slewed(angle_rad, target_rad, room * rate_rad_s, period_s) : angle_rad;
}

}  // namespace

Adjustment step(const AttitudeFeedbackConfig& config, AttitudeFeedbackState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  const PhaseSample& now = input.measured;
  const PhaseSample flat = between(PhaseSample{}, input.nominal, config.nominal_share);
  const AnkleAngles wanted{against_rad(config, deviation(now.torso_roll_rad, flat.torso_roll_rad),
                                       deviation(now.torso_roll_rate_rad_s, flat.torso_roll_rate_rad_s)),
                           against_rad(config, deviation(now.torso_pitch_rad, flat.torso_pitch_rad),
                                       deviation(now.torso_pitch_rate_rad_s, flat.torso_pitch_rate_rad_s))};
  approach(state.wanted, wanted, low_pass_share(input.period_s, config.smoothing_s));

  const PerSide<double> carried = load_share(input);
  // Two feet that stand side by side hold the roll by their legs, which an ankle's turn would only bend.
  const bool stands = input.walk.stage == decision::WalkStage::kStanding;
  if (stands) state.stood_s += input.period_s;
  const double standing_share = config.standing_pitch_share * std::exp(-state.stood_s / config.standing_fade_s);
  const AnkleAngles share_of_wanted{stands ? 0.0 : 1.0, stands ? standing_share : 1.0};
  approach(state.activity, is_active ? 1.0 : 0.0, low_pass_share(input.period_s, config.fade_s));
  for (const Side side : kSides) {
    double& share = state.load_share[index(side)];
    approach(share, carried[index(side)], low_pass_share(input.period_s, config.load_time_constant_s));
    AnkleAngles& angle = state.added_angle[index(side)];
    const double weight = state.activity * share;
    // A turn to the right moves the ZMP to the right, one forward moves it to the front.
    const EdgeRoom room = edge_room(config.edge, input.sole, input.ankle[index(side)]);
    angle.roll_rad = turned(angle.roll_rad, weight * share_of_wanted.roll_rad * state.wanted.roll_rad, room.right,
                            room.left, config.max_rate_rad_s, input.period_s);
    angle.pitch_rad = turned(angle.pitch_rad, weight * share_of_wanted.pitch_rad * state.wanted.pitch_rad, room.front,
                             room.rear, config.max_rate_rad_s, input.period_s);
  }
  return with_ankles(state.added_angle);
}

}  // namespace surefoot::stabilizer
