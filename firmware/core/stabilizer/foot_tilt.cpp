#include "firmware/core/stabilizer/foot_tilt.hpp"

#include <algorithm>

namespace surefoot::stabilizer {
namespace {

constexpr double kLongestPeriod_s = 0.1;  // that is believed

double following_rad(const FootTiltConfig& config, double sole_rad, double slope_rad) noexcept {
  return within(config.gain * beyond_band(deviation(sole_rad, slope_rad), config.band_rad), config.max_angle_rad);
}

bool is_sound(double angle_rad) noexcept { return sound_or_zero(angle_rad) == angle_rad; }

void learn_slope(const FootTiltConfig& config, FootTiltState& state, const StabilizerInput& input) noexcept {
  const double period_s = std::min(input.period_s, kLongestPeriod_s);
  const double share = 0.5 * low_pass_share(period_s, config.slope_time_constant_s);  // two soles a tick
  for (const Side side : kSides) {
    const AnkleAngles sole{input.foot_roll_rad[index(side)], input.foot_pitch_rad[index(side)]};
    if (!input.ankle[index(side)].carries() || !is_sound(sole.roll_rad) || !is_sound(sole.pitch_rad)) continue;
    approach(state.slope, sole, share);
  }
}

}  // namespace

Adjustment step(const FootTiltConfig& config, FootTiltState& state, const StabilizerInput& input,
                bool is_active) noexcept {
  learn_slope(config, state, input);
  const double share = low_pass_share(input.period_s, config.time_constant_s);
  const bool walks = input.walk.stage != decision::WalkStage::kStanding;
  for (const Side side : kSides) {
    AnkleAngles target;
    EdgeRoom room;
    if (is_active && walks && input.ankle[index(side)].carries()) {
      room = edge_room(config.edge, input.sole, input.ankle[index(side)]);
      target = {following_rad(config, input.foot_roll_rad[index(side)], state.slope.roll_rad),
                following_rad(config, input.foot_pitch_rad[index(side)], state.slope.pitch_rad)};
    }
    approach(state.added_angle[index(side)].roll_rad, target.roll_rad, room.across() * share);
    approach(state.added_angle[index(side)].pitch_rad, target.pitch_rad, room.along() * share);
  }
  return with_ankles(state.added_angle);
}

}  // namespace surefoot::stabilizer
