#include "sim_hw/config_check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "sim_hw/bus/traffic.hpp"
#include "sim_hw/faults/fault_check.hpp"
#include "sim_hw/nodes/command_queue.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kMinLinkKg = 0.1;
constexpr double kMaxPhysicsStepS = 2.0e-3;
constexpr double kMaxSlopeDeg = 15.0;
constexpr double kLongestPushS = 3600.0;
constexpr double kMaxSpringPhaseRad = 1.0;  // of the rotor's swing in one step; symplectic Euler is unstable from 2 on
constexpr double kHighestTileM = 0.05;
constexpr double kHighestPatchM = 0.3;
constexpr double kSmallestPlateM = 0.005;
constexpr double kFarthestPatchM = 1000.0;

/// Written so that NaN fails.
void require(bool holds, std::string_view field, double value, std::string_view expected, std::string_view remedy) {
  if (holds) return;
  throw std::invalid_argument(fmt::format("{} is {}; expected {}\n  remedy: {}", field, value, expected, remedy));
}

void require_positive(std::string_view field, double value) {
  require(value > 0.0 && std::isfinite(value), field, value, "a number above 0",
          "give a positive value, or the default");
}

void require_not_negative(std::string_view field, double value) {
  require(value >= 0.0 && std::isfinite(value), field, value, "0 or more", "give 0 to switch it off");
}

void check_clock(const SimConfig& config) {
  require(config.physics_step_s > 0.0 && config.physics_step_s <= kMaxPhysicsStepS, "physics_step_s",
          config.physics_step_s, "above 0, at most 2 ms", "use 0.5 ms; 0.25 ms to check it");
  require_positive("control_period_s", config.control_period_s);
  const double steps = config.control_period_s / config.physics_step_s;
  require(steps >= 0.5 && std::abs(steps - std::round(steps)) < 1.0e-6, "physics_step_s", config.physics_step_s,
          fmt::format("a divisor of control_period_s ({})", config.control_period_s),
          "choose control_period_s / 1, / 2, / 4 ...");
  require_not_negative("command_latency_s", config.command_latency_s);
  require(config.command_latency_s < static_cast<double>(CommandQueue::kCapacity - 1) * config.control_period_s,
          "command_latency_s", config.command_latency_s, "less than 63 control periods", "give the latency in seconds");
  require(config.watchdog_s > config.control_period_s, "watchdog_s", config.watchdog_s,
          "longer than one control period", "leave it at 0.02 s");
  require(std::isfinite(config.time_zero_s), "time_zero_s", config.time_zero_s, "a finite time", "use 0");
}

void check_masses(const MassConfig& mass) {
  for (const auto& [field, value] : {std::pair{"mass.trunk_kg", mass.trunk_kg},
                                     {"mass.thigh_kg", mass.thigh_kg},
                                     {"mass.calf_kg", mass.calf_kg},
                                     {"mass.foot_kg", mass.foot_kg}}) {
    require(value >= kMinLinkKg && std::isfinite(value), field, value, "0.1 kg or more", "give the mass in kilograms");
  }
  for (const double size : mass.trunk_size_m) require_positive("mass.trunk_size_m", size);
  for (const double place : mass.trunk_com_body_m) {
    require(std::isfinite(place), "mass.trunk_com_body_m", place, "a finite place", "give metres in the body frame");
  }
}

void check_geometry(const geometry::RobotGeometry& geometry) {
  require_positive("geometry.thigh_m", geometry.thigh_m);
  require_positive("geometry.calf_m", geometry.calf_m);
  require_positive("geometry.ankle_height_m", geometry.ankle_height_m);
  require_positive("geometry.sole_width_m", geometry.sole_width_m);
  require_positive("sole length", geometry.sole_heel_m + geometry.sole_toe_m);
}

void check_contact(const ContactConfig& contact) {
  require_not_negative("contact.friction", contact.friction);
  require_positive("contact.normal_stiffness_n_per_m", contact.normal_stiffness_n_per_m);
  require_not_negative("contact.normal_damping_n_s_per_m", contact.normal_damping_n_s_per_m);
  require_positive("contact.tangential_stiffness_n_per_m", contact.tangential_stiffness_n_per_m);
  require_not_negative("contact.tangential_damping_n_s_per_m", contact.tangential_damping_n_s_per_m);
}

void check_drives_and_sensors(const DriveConfig& drive, const SensorConfig& sensor) {
  require_not_negative("drive.rotor_inertia_kg_m2", drive.rotor_inertia_kg_m2);
  require_not_negative("drive.hip_knee_friction_nm_s_per_rad", drive.hip_knee_friction_nm_s_per_rad);
  require_not_negative("drive.ankle_friction_nm_s_per_rad", drive.ankle_friction_nm_s_per_rad);
  require_positive("drive.torque_limit_nm", drive.torque_limit_nm);
  require_not_negative("sensor.encoder_resolution_rad", sensor.encoder_resolution_rad);
  require_not_negative("sensor.encoder_noise_rad", sensor.encoder_noise_rad);
  require_not_negative("sensor.joint_rate_noise_rad_s", sensor.joint_rate_noise_rad_s);
  require_not_negative("sensor.force_resolution_n", sensor.force_resolution_n);
  require_not_negative("sensor.force_noise_n", sensor.force_noise_n);
  require_not_negative("sensor.gyro_noise_rad_s", sensor.gyro_noise_rad_s);
  require_not_negative("sensor.accelerometer_noise_m_s2", sensor.accelerometer_noise_m_s2);
  require_not_negative("sensor.hip_gyro_noise_rad_s", sensor.hip_gyro_noise_rad_s);
  require_not_negative("sensor.inclinometer_noise_rad", sensor.inclinometer_noise_rad);
  require_not_negative("sensor.foot_accelerometer_noise_m_s2", sensor.foot_accelerometer_noise_m_s2);
}

void check_servo(const DriveConfig& drive) {
  for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
    require_not_negative("drive.rotor_share", drive.rotor_share[joint]);
    require_not_negative("drive.servo_stiffness_nm_per_rad", drive.servo_stiffness_nm_per_rad[joint]);
    require_not_negative("drive.servo_damping_nm_s_per_rad", drive.servo_damping_nm_s_per_rad[joint]);
  }
}

void check_hip_spring(const DriveConfig& drive, double step_s) {
  const double stiffness = drive.hip_roll_stiffness_nm_per_rad;
  require_not_negative("drive.hip_roll_stiffness_nm_per_rad", stiffness);
  require_not_negative("drive.hip_roll_damping_nm_s_per_rad", drive.hip_roll_damping_nm_s_per_rad);
  const double rotor_kg_m2 = drive.rotor_share[index(LegJoint::kHipRoll)] * drive.rotor_inertia_kg_m2;
  const double stiffest = kMaxSpringPhaseRad * kMaxSpringPhaseRad * rotor_kg_m2 / (step_s * step_s);
  require(stiffness <= stiffest, "drive.hip_roll_stiffness_nm_per_rad", stiffness,
          fmt::format("at most {:.4g}, for its rotor of {:.4g} kg m2 and a physics step of {} s", stiffest, rotor_kg_m2,
                      step_s),
          "use 0 for a rigid hip, lower it, or raise the rotor's inertia or its share at the hip roll");
}

void check_inertial_sensors(const SensorConfig& sensor) {
  require_positive("sensor.hip_gyro_range_rad_s", sensor.hip_gyro_range_rad_s);
  require_positive("sensor.inclinometer_range_rad", sensor.inclinometer_range_rad);
  require_positive("sensor.foot_accelerometer_range_m_s2", sensor.foot_accelerometer_range_m_s2);
}

void check_patch(const PatchConfig& patch) {
  for (const double place : patch.centre_m) {
    require(std::abs(place) <= kFarthestPatchM, "patch.centre_m", place, "-1000 to 1000 m", "give metres on the floor");
  }
  for (const double size : patch.size_m) {
    require(size >= kSmallestPlateM && size <= kFarthestPatchM, "patch.size_m", size, "0.005 to 1000 m",
            "give the lengths of its edges in metres");
  }
  require(patch.height_m >= 0.0 && patch.height_m <= kHighestPatchM, "patch.height_m", patch.height_m, "0 to 0.3 m",
          "give metres above the floor; a hole is a floor that is higher around it");
  require(patch.friction >= -1.0 && std::isfinite(patch.friction), "patch.friction", patch.friction,
          "0 or more, or -1 for that of the floor", "give a coefficient of friction");
}

void check_terrain(const TerrainConfig& terrain) {
  require(terrain.tile_height_m >= 0.0 && terrain.tile_height_m <= kHighestTileM, "floor.tile_height_m",
          terrain.tile_height_m, "0 to 0.05 m", "use 0 for no tiles, 0.004 for a rough floor");
  require(terrain.plate_height_m >= 0.0 && terrain.plate_height_m <= kHighestTileM, "floor.plate_height_m",
          terrain.plate_height_m, "0 to 0.05 m", "use 0.004");
  for (const auto& [field, edge_m] :
       {std::pair{"floor.tile_edge_m", terrain.tile_edge_m}, {"floor.plate_edge_m", terrain.plate_edge_m}}) {
    require(edge_m >= kSmallestPlateM && edge_m <= 1.0, field, edge_m, "0.005 to 1 m", "give the edge in metres");
  }
  require(terrain.plates_per_m2 >= 0.0 && terrain.plates_per_m2 * terrain.plate_edge_m * terrain.plate_edge_m <= 1.0,
          "floor.plates_per_m2", terrain.plates_per_m2,
          fmt::format("0 to {:.4g}, one on each square of their own size",
                      1.0 / (terrain.plate_edge_m * terrain.plate_edge_m)),
          "scatter fewer or smaller plates");
  require(terrain.patches.size() <= kMaxPatches, "patch count", static_cast<double>(terrain.patches.size()),
          "at most 64", "remove some of the patches");
  for (const PatchConfig& patch : terrain.patches) check_patch(patch);
}

void check_bus(const BusConfig& bus) {
  require(bus.count == 1 || bus.count == kMaxBuses, "bus.count", bus.count, "1 or 2", "use 1, or 2 for one bus a leg");
  require_positive("bus.nominal_bit_rate_hz", bus.nominal_bit_rate_hz);
  require_positive("bus.data_bit_rate_hz", bus.data_bit_rate_hz);
  require_not_negative("bus.node_latency_s", bus.node_latency_s);
  require_not_negative("bus.node_jitter_s", bus.node_jitter_s);
  require_not_negative("bus.compute_s", bus.compute_s);
}

void check_faults(const std::vector<FaultConfig>& faults, bool has_inertial_legs) {
  require(faults.size() <= kMaxFaults, "fault count", static_cast<double>(faults.size()), "at most 16",
          "remove some of the faults");
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (const auto problem = find_problem(faults[i])) {
      throw std::invalid_argument(
          fmt::format("fault[{}].{} {}\n  remedy: {}", i, problem->field, problem->statement, problem->remedy));
    }
    if (is_of_inertial_legs(faults[i].signal) && !has_inertial_legs) {
      throw std::invalid_argument(
          fmt::format("fault[{}].signal is not measured by a robot without inertial legs\n"
                      "  remedy: set sensor.has_inertial_legs to true, or remove the fault",
                      i));
    }
  }
}

void check_slope(const ContactConfig& contact) {
  for (const auto& [field, value] : {std::pair{"floor.slope_pitch_deg", contact.slope_pitch_deg},
                                     {"floor.slope_roll_deg", contact.slope_roll_deg}}) {
    require(std::abs(value) <= kMaxSlopeDeg, field, value, "-15 to 15 degrees", "use 0 for a level floor");
  }
}

void check_payloads(const std::vector<PayloadConfig>& payloads) {
  for (const PayloadConfig& payload : payloads) {
    require_not_negative("payload.mass_kg", payload.mass_kg);
    require_not_negative("payload.edge_m", payload.edge_m);
    require(std::isfinite(payload.at_s), "payload.at_s", payload.at_s, "a finite time", "give seconds");
    require(payload.removed_at_s > payload.at_s, "payload.removed_at_s", payload.removed_at_s,
            fmt::format("later than payload.at_s ({})", payload.at_s), "give seconds, or inf for never");
    for (const double place : payload.position_m) {
      require(std::isfinite(place), "payload.position_m", place, "a finite place", "give metres in the body frame");
    }
  }
}

void check_pushes(const std::vector<PushConfig>& pushes) {
  require(pushes.size() <= kMaxPushes, "push count", static_cast<double>(pushes.size()), "at most 16",
          "remove some of the pushes");
  for (const PushConfig& push : pushes) {
    require(std::isfinite(push.at_s), "push.at_s", push.at_s, "a finite time", "give seconds");
    require(push.duration_s > 0.0 && push.duration_s <= kLongestPushS, "push.duration_s", push.duration_s,
            "more than 0, up to 3600 s", "give seconds");
    for (const double component : push.force_n) {
      require(std::isfinite(component), "push.force_n", component, "a finite force", "give newtons in the world frame");
    }
    for (const double place : push.point_body_m) {
      require(std::isfinite(place), "push.point_body_m", place, "a finite place", "give metres in the body frame");
    }
  }
}

}  // namespace

void check(const SimConfig& config) {
  check_clock(config);
  check_geometry(config.geometry);
  check_masses(config.mass);
  check_drives_and_sensors(config.drive, config.sensor);
  check_servo(config.drive);
  check_hip_spring(config.drive, config.physics_step_s);
  check_inertial_sensors(config.sensor);
  check_contact(config.contact);
  check_terrain(config.terrain);
  check_faults(config.faults, config.sensor.has_inertial_legs);
  check_bus(config.bus);
  check_slope(config.contact);
  check_payloads(config.payloads);
  check_pushes(config.pushes);
}

}  // namespace surefoot::sim_hw
