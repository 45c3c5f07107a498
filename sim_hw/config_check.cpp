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
}

void check_bus(const BusConfig& bus) {
  require(bus.count == 1 || bus.count == kMaxBuses, "bus.count", bus.count, "1 or 2", "use 1, or 2 for one bus a leg");
  require_positive("bus.nominal_bit_rate_hz", bus.nominal_bit_rate_hz);
  require_positive("bus.data_bit_rate_hz", bus.data_bit_rate_hz);
  require_not_negative("bus.node_latency_s", bus.node_latency_s);
  require_not_negative("bus.node_jitter_s", bus.node_jitter_s);
  require_not_negative("bus.compute_s", bus.compute_s);
}

void check_faults(const std::vector<FaultConfig>& faults) {
  require(faults.size() <= kMaxFaults, "fault count", static_cast<double>(faults.size()), "at most 16",
          "remove some of the faults");
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (const auto problem = find_problem(faults[i])) {
      throw std::invalid_argument(
          fmt::format("fault[{}].{} {}\n  remedy: {}", i, problem->field, problem->statement, problem->remedy));
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
  check_contact(config.contact);
  check_faults(config.faults);
  check_bus(config.bus);
  check_slope(config.contact);
  check_payloads(config.payloads);
  check_pushes(config.pushes);
}

}  // namespace surefoot::sim_hw
