#pragma once

#include "firmware/core/decision/walk_stage.hpp"
#include "firmware/core/estimation/ankle_load.hpp"
#include "firmware/core/joints.hpp"

namespace surefoot::stabilizer {

/// Where the walk is in this tick: all that the controllers know of the pattern.
struct WalkView {
  decision::WalkStage stage = decision::WalkStage::kStanding;
  bool is_double_support = true;  ///< by the plan: standing, shifting, landing, and the end of stages 2 and 4
  Side moving = Side::kLeft;      ///< foot that is lifted and lowered; in double support the one that landed last
  double swing_share = 0.0;       ///< u of the step: 0 at lift, 0.5 at the top, 1 at the planned landing
  double step_share = 0.0;        ///< time in the step over T_step, [0, 1]; place in the nominal table
  double step_time_s = 0.0;       ///< the same in seconds
  bool begins_step = false;       ///< true in the first tick of a step (the double support before a lift)
  bool has_landed = false;        ///< the moving foot has carried 5 kgf since its top; true in double support
  double since_landing_s = 0.0;   ///< since that instant
  bool is_waiting = false;        ///< the pattern's clock stands: the landing foot does not carry yet

  [[nodiscard]] Side support() const noexcept { return opposite(moving); }
  [[nodiscard]] bool is_swinging() const noexcept {
    return decision::is_lifting(stage) || (decision::is_lowering(stage) && !is_double_support);
  }
};

/// What the sensors say at one place of the step, once measured and once as flat walking has it.
/// Signs as torso angles: roll positive leans right, pitch positive leans forward.
struct PhaseSample {
  double torso_roll_rad = 0.0;
  double torso_pitch_rad = 0.0;
  double torso_roll_rate_rad_s = 0.0;
  double torso_pitch_rate_rad_s = 0.0;
  double zmp_x_foot_m = 0.0;             ///< of the supporting foot, in its frame
  double zmp_y_foot_m = 0.0;             ///< y to the left
  double support_roll_rate_rad_s = 0.0;  ///< hip gyro of the supporting leg
};

/// How far a sole reaches from its foot frame's origin.
struct SoleSize {
  double toe_m = 0.128;
  double heel_m = 0.105;
  double half_width_m = 0.07;
};

/// Everything the controllers may know in one tick.
struct StabilizerInput {
  WalkView walk;
  PhaseSample measured;
  PhaseSample nominal;                    ///< of flat walking at `walk.step_share`; zero while standing
  PerSide<estimation::AnkleLoad> ankle;   ///< clipped to the sensor's range
  PerSide<double> hip_roll_rate_rad_s{};  ///< hip gyros
  PerSide<double> foot_roll_rad{};        ///< inclinometers of the soles, against gravity
  PerSide<double> foot_pitch_rad{};
  PerSide<double> foot_lateral_force_m_s2{};  ///< accelerometers of the soles, y: specific force
  SoleSize sole;
  double body_mass_kg = 56.0;
  double period_s = 1.0e-3;
};

/// What the controllers add to the walking pattern. Zero changes nothing.
struct Adjustment {
  double pelvis_x_m = 0.0;  ///< moves the pelvis over the feet, walking frame
  double pelvis_y_m = 0.0;
  double pelvis_z_m = 0.0;
  PerSide<double> leg_length_m{};    ///< longer is positive
  PerSide<double> ankle_roll_rad{};  ///< added to the joint
  PerSide<double> ankle_pitch_rad{};
  PerSide<double> hip_roll_rad{};
  double landing_x_m = 0.0;      ///< moves the point where the moving foot lands
  double landing_y_m = 0.0;      ///< y to the left
  double sway_m = 0.0;           ///< added to the pattern's amplitude
  double sway_centre_x_m = 0.0;  ///< moves the centre of the pelvis' swing
  double sway_centre_y_m = 0.0;
  double earlier_landing_s = 0.0;  ///< the lowering ends so much earlier; 0 or more
  bool holds_lowering = false;     ///< the moving foot goes no further down
  bool waits_for_contact = false;  ///< the step does not end before the landing foot carries

  /// Sums up; an order that one gives holds.
  Adjustment& operator+=(const Adjustment& other) noexcept;
};

}  // namespace surefoot::stabilizer
