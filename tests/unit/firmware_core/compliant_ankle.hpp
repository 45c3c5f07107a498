#pragma once

#include <cmath>

#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

/// The body as an inverted pendulum on a compliant ankle, m l^2 phi'' = m g l phi - K (phi - u): phi and u positive to
/// the side to which a positive ankle angle leans the body, left (roll) or backwards (pitch). 56 kg, l = 0.9 m.
struct CompliantAnkle {
  static constexpr double kMass_kg = 56.0;
  static constexpr double kLength_m = 0.9;
  static constexpr double kGravity_m_s2 = 9.81;
  static constexpr double kWeight_n = kMass_kg * kGravity_m_s2;

  double stiffness_nm_per_rad = 2450.0;
  double lean_rad = 0.0;
  double rate_rad_s = 0.0;

  [[nodiscard]] double spring_per_s2() const { return stiffness_nm_per_rad / (kMass_kg * kLength_m * kLength_m); }
  [[nodiscard]] double mode_rad_s() const { return std::sqrt(spring_per_s2() - kGravity_m_s2 / kLength_m); }
  [[nodiscard]] double moment_nm(double command_rad) const { return stiffness_nm_per_rad * (lean_rad - command_rad); }
  [[nodiscard]] double zmp_m(double command_rad) const { return moment_nm(command_rad) / kWeight_n; }

  /// One period with the command held: exact.
  void advance(double command_rad, double period_s) {
    const double mode = mode_rad_s();
    const double rest_rad = spring_per_s2() * command_rad / (mode * mode);
    const double from_rest_rad = lean_rad - rest_rad;
    const double cosine = std::cos(mode * period_s);
    const double sine = std::sin(mode * period_s);
    lean_rad = rest_rad + from_rest_rad * cosine + rate_rad_s / mode * sine;
    rate_rad_s = rate_rad_s * cosine - from_rest_rad * mode * sine;
  }

  /// Half the square of the distance from rest in the phase plane: constant without control.
  [[nodiscard]] double energy() const {
    return 0.5 * (lean_rad * lean_rad + rate_rad_s * rate_rad_s / (mode_rad_s() * mode_rad_s()));
  }
};

/// What the sensors say of a lean to the left, on top of flat walking.
inline void lean_left(StabilizerInput& input, const CompliantAnkle& plant, double command_rad) {
  input.measured.torso_roll_rad = input.nominal.torso_roll_rad - plant.lean_rad;
  input.measured.torso_roll_rate_rad_s = input.nominal.torso_roll_rate_rad_s - plant.rate_rad_s;
  input.measured.zmp_y_foot_m = input.nominal.zmp_y_foot_m + plant.zmp_m(command_rad);
}

/// The same of a lean backwards.
inline void lean_back(StabilizerInput& input, const CompliantAnkle& plant, double command_rad) {
  input.measured.torso_pitch_rad = input.nominal.torso_pitch_rad - plant.lean_rad;
  input.measured.torso_pitch_rate_rad_s = input.nominal.torso_pitch_rate_rad_s - plant.rate_rad_s;
  input.measured.zmp_x_foot_m = input.nominal.zmp_x_foot_m - plant.zmp_m(command_rad);
}

}  // namespace surefoot::stabilizer
