#include <array>
#include <string>
#include <vector>

#include "tools/scenario/controller_fields.hpp"
#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/preset.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

namespace {

constexpr std::array kSwayProfiles{"sine", "pendulum"};

void append_payload_shift(std::vector<Field>& table, decision::PayloadShiftConfig& config) {
  const std::string prefix = "payload_shift.";
  table.insert(
      table.end(),
      {Field{prefix + "reflex_s", &config.reflex_s, {0.05, 5.0}, "s", "first move; the load is weighed meanwhile"},
       Field{prefix + "first_offset_m", &config.first_offset_m, {0.0, 0.1}, "m", "way back of the first move"},
       Field{prefix + "lever_m", &config.lever_m, {0.0, 1.0}, "m", "load ahead of the pelvis until the ZMP says more"},
       Field{prefix + "settling_s", &config.settling_s, {0.05, 60.0}, "s", "second move, by the weighed load"},
       Field{prefix + "measuring_s", &config.measuring_s, {0.05, 60.0}, "s", "time over which the ZMP is averaged"},
       Field{prefix + "shift_s", &config.shift_s, {0.05, 60.0}, "s", "last move, by the error of the ZMP"},
       Field{prefix + "max_offset_m", &config.max_offset_m, {0.0, 0.2}, "m", "bound on the pelvis' offset"}});
}

}  // namespace

void append_floor_walk_fields(std::vector<Field>& table, Scenario& scenario) {
  gait::FourFactorParameters& pattern = scenario.firmware.floor.pattern;
  stabilizer::AdjustmentLimits& limits = scenario.firmware.floor.stabilizer.limits;
  table.insert(
      table.end(),
      {Field{"pattern.step_length_m",
             &pattern.step_length_m,
             {0.0, 0.3},
             "m",
             "distance of two successive footholds, 0 to walk on the spot"},
       Field{"pattern.com_height_m",
             &pattern.com_height_m,
             {0.1, 2.0},
             "m",
             "height of the centre of mass above the soles, of the pendulum along x"},
       choice_field("pattern.sway_profile", pattern.sway_profile, kSwayProfiles,
                    "way the pelvis sways: sine with gait.sway_m, pendulum as the feet and the mass' height make it"),
       Field{"pattern.com_share",
             &pattern.com_share,
             {0.1, 1.0},
             "1",
             "share of the pelvis' sway that the centre of mass follows, of the profile pendulum"},
       Field{"pattern.transfer_s",
             &pattern.transfer_s,
             {0.001, 2.0},
             "s",
             "time in which the pressure centre goes from foot to foot, of the profile pendulum"},
       Field{"pattern.pelvis_x_m", &pattern.pelvis_x_m, {-0.1, 0.1}, "m", "pelvis ahead of the middle of the feet"},
       Field{"pattern.shift_steps",
             &pattern.shift_steps,
             {1.0, 20.0},
             "steps",
             "time in which the sway grows before the first lift"},
       Field{"pattern.standing_s", &pattern.standing_s, {0.0, 600.0, true}, "s", "time of standing before the walk"},
       Field{"pattern.longest_wait_s", &pattern.longest_wait_s, {0.0, 60.0}, "s", "longest wait of a step for contact"},
       Field{"pattern.height_settling_s",
             &pattern.height_settling_s,
             {0.01, 60.0},
             "s",
             "time constant with which a foot that landed high comes back to level"},
       Field{"attitude.time_constant_s",
             &scenario.firmware.floor.attitude.time_constant_s,
             {0.01, 600.0},
             "s",
             "time constant from which on the torso's accelerometer is trusted"},
       Field{"attitude.ankle_force_range_n",
             &scenario.firmware.floor.ankle_range.force_n,
             {1.0, 1e5},
             "N",
             "range of the force that is formed from a sole's load cells"},
       Field{"attitude.ankle_moment_range_nm",
             &scenario.firmware.floor.ankle_range.moment_nm,
             {1.0, 1e4},
             "N m",
             "range of the moments that are formed from a sole's load cells"},
       Field{"stabilizer.max_ankle_rad", &limits.ankle_rad, {0.0, 0.5}, "rad", "bound on the sum at each ankle axis"},
       Field{
           "stabilizer.max_pelvis_m", &limits.pelvis_m, {0.0, 0.2}, "m", "bound on the sum at each axis of the pelvis"},
       Field{"stabilizer.max_leg_m", &limits.leg_m, {0.0, 0.1}, "m", "bound on the sum at each leg's length"},
       Field{"stabilizer.max_landing_m",
             &limits.landing_m,
             {0.0, 0.2},
             "m",
             "bound on the sum at each axis of the landing point"},
       Field{"stabilizer.body_mass_kg",
             &scenario.firmware.floor.body_mass_kg,
             {1.0, 300.0},
             "kg",
             "mass of the robot as its controllers know it"},
       name_field("stabilizer.set", scenario.controllers, kControllerSets,
                  "set of online controllers that a scenario begins with")});
  append_new_controller_fields(table, scenario.firmware.floor.stabilizer);
  append_old_controller_fields(table, scenario.firmware.floor.stabilizer);
  append_smoothing_fields(table, scenario.firmware.floor.stabilizer);
  append_payload_shift(table, scenario.firmware.floor.payload);
}

}  // namespace surefoot::scenario
