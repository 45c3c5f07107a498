#pragma once

#include "firmware/core/stabilizer/gradual.hpp"
#include "firmware/core/stabilizer/sole_edge.hpp"

namespace surefoot::stabilizer {

/// Attitude feedback: the ankles that carry turn against the deviation of the torso's roll and pitch, and of their
/// rates, from flat walking at this place of the step. Each foot takes its share of the load, so that the moment on the
/// body does not change while the weight goes from one to the other. Source: ours.
struct AttitudeFeedbackConfig {
  double gain = 1.8;                  ///< ankle angle per torso angle
  double nominal_share = 1.0;         ///< of flat walking's own swing that is left to it; 1: silent on the flat
  double standing_pitch_share = 0.3;  ///< of the turn in pitch, when the robot begins to stand on two feet
  double standing_fade_s = 3.0;       ///< time constant with which that goes over to the upright pose
  double rate_gain_s = 0.05;    ///< D: seconds of the rate that count as angle; the smoothing takes 0.02 s of them back
  double max_angle_rad = 0.07;  ///< 4 degrees
  double max_rate_rad_s = 2.0;  ///< of the output, so that no step of an input passes
  double smoothing_s = 0.02;    ///< of the wanted angle: the torso swings on hips that give
  double load_time_constant_s = 0.02;  ///< of the shares of the load
  double fade_s = 0.1;                 ///< in and out
  EdgeLimits edge;                     ///< slows the turn that pushes the ZMP toward an edge of its sole
};

struct AttitudeFeedbackState {
  double stood_s = 0.0;                ///< on both feet
  double activity = 0.0;               ///< 0 faded out, 1 in force
  AnkleAngles wanted;                  ///< of a foot that carries all, low-passed
  PerSide<double> load_share{};        ///< low-passed
  PerSide<AnkleAngles> added_angle{};  ///< outputs
};

/// One tick.
/// @return ankle angles of both feet, each within `max_angle_rad`, changing by `max_rate_rad_s` at the most
[[nodiscard]] Adjustment step(const AttitudeFeedbackConfig&, AttitudeFeedbackState&, const StabilizerInput&,
                              bool is_active) noexcept;

}  // namespace surefoot::stabilizer
