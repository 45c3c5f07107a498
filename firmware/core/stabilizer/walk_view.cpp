#include "firmware/core/stabilizer/walk_view.hpp"

namespace surefoot::stabilizer {

Adjustment& Adjustment::operator+=(const Adjustment& other) noexcept {
  pelvis_x_m += other.pelvis_x_m;
  pelvis_y_m += other.pelvis_y_m;
  pelvis_z_m += other.pelvis_z_m;
  for (const Side side : kSides) {
    leg_length_m[index(side)] += other.leg_length_m[index(side)];
    ankle_roll_rad[index(side)] += other.ankle_roll_rad[index(side)];
    ankle_pitch_rad[index(side)] += other.ankle_pitch_rad[index(side)];
    hip_roll_rad[index(side)] += other.hip_roll_rad[index(side)];
  }
  landing_x_m += other.landing_x_m;
  landing_y_m += other.landing_y_m;
  sway_m += other.sway_m;
  sway_centre_x_m += other.sway_centre_x_m;
  sway_centre_y_m += other.sway_centre_y_m;
  earlier_landing_s += other.earlier_landing_s;
  holds_lowering = holds_lowering || other.holds_lowering;
  waits_for_contact = waits_for_contact || other.waits_for_contact;
  return *this;
}

}  // namespace surefoot::stabilizer
