#include "sim_hw/bus/traffic.hpp"
#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {
namespace {

constexpr std::array kContactModels{"spring_damper", "bullet"};

void append_masses(std::vector<Field>& table, sim_hw::MassConfig& mass) {
  table.insert(table.end(), {Field{"mass.trunk_kg", &mass.trunk_kg, {0.1, 500.0}, "kg", "mass of the trunk"},
                             array_field("mass.trunk_size_m", mass.trunk_size_m, {0.01, 2.0}, "m",
                                         "size of the trunk, length width height"),
                             array_field("mass.trunk_com_body_m", mass.trunk_com_body_m, {-1.0, 1.0}, "m",
                                         "centre of mass of the trunk in the body frame, x y z"),
                             Field{"mass.thigh_kg", &mass.thigh_kg, {0.1, 100.0}, "kg", "mass of a thigh"},
                             Field{"mass.calf_kg", &mass.calf_kg, {0.1, 100.0}, "kg", "mass of a calf"},
                             Field{"mass.foot_kg", &mass.foot_kg, {0.1, 100.0}, "kg", "mass of a foot"},
                             Field{"mass.foot_com_x_foot_m",
                                   &mass.foot_com_x_foot_m,
                                   {-0.5, 0.5},
                                   "m",
                                   "centre of mass of a foot ahead of the ankle"}});
}

void append_drives(std::vector<Field>& table, sim_hw::DriveConfig& drive) {
  table.insert(table.end(), {Field{"drive.rotor_inertia_kg_m2",
                                   &drive.rotor_inertia_kg_m2,
                                   {0.0, 10.0},
                                   "kg m2",
                                   "rotor inertia reflected to the joint"},
                             array_field("drive.rotor_share", drive.rotor_share, {0.0, 10.0}, "1",
                                         "share of it that each joint has, from hip yaw to ankle roll"),
                             Field{"drive.hip_knee_friction_nm_s_per_rad",
                                   &drive.hip_knee_friction_nm_s_per_rad,
                                   {0.0, 1000.0},
                                   "N m s/rad",
                                   "viscous friction of hips and knees"},
                             Field{"drive.ankle_friction_nm_s_per_rad",
                                   &drive.ankle_friction_nm_s_per_rad,
                                   {0.0, 1000.0},
                                   "N m s/rad",
                                   "viscous friction of the ankles"},
                             Field{"drive.torque_limit_nm",
                                   &drive.torque_limit_nm,
                                   {0.0, 300.0, true},
                                   "N m",
                                   "largest torque of a motor; where not given that of the gate"},
                             array_field("drive.servo_stiffness_nm_per_rad", drive.servo_stiffness_nm_per_rad,
                                         {0.0, 1e6}, "N m/rad", "stiffness of the leg boards' position servo"),
                             array_field("drive.servo_damping_nm_s_per_rad", drive.servo_damping_nm_s_per_rad,
                                         {0.0, 1e4}, "N m s/rad", "damping of the leg boards' position servo"),
                             Field{"drive.hip_roll_stiffness_nm_per_rad",
                                   &drive.hip_roll_stiffness_nm_per_rad,
                                   {0.0, 1e6},
                                   "N m/rad",
                                   "stiffness between hip roll motor and leg, 0 for a rigid hip"},
                             Field{"drive.hip_roll_damping_nm_s_per_rad",
                                   &drive.hip_roll_damping_nm_s_per_rad,
                                   {0.0, 100.0},
                                   "N m s/rad",
                                   "damping between hip roll motor and leg"}});
}

void append_floor(std::vector<Field>& table, sim_hw::ContactConfig& contact, sim_hw::TerrainConfig& terrain) {
  table.insert(
      table.end(),
      {Field{"floor.friction", &contact.friction, {0.0, 2.0}, "1", "coefficient of friction between sole and floor"},
       Field{"floor.slope_pitch_deg",
             &contact.slope_pitch_deg,
             {-15.0, 15.0},
             "deg",
             "slope of the floor, positive downhill ahead"},
       Field{"floor.slope_roll_deg",
             &contact.slope_roll_deg,
             {-15.0, 15.0},
             "deg",
             "slope of the floor across, positive downhill to the right"}});
  append_terrain_fields(table, terrain);
}

void append_contact(std::vector<Field>& table, sim_hw::ContactConfig& contact) {
  table.insert(table.end(),
               {choice_field("contact.model", contact.model, kContactModels, "model of the ground contact"),
                Field{"contact.normal_stiffness_n_per_m",
                      &contact.normal_stiffness_n_per_m,
                      {1e3, 1e8},
                      "N/m",
                      "normal stiffness of a corner"},
                Field{"contact.normal_damping_n_s_per_m",
                      &contact.normal_damping_n_s_per_m,
                      {0.0, 1e6},
                      "N s/m",
                      "normal damping of a corner"},
                Field{"contact.tangential_stiffness_n_per_m",
                      &contact.tangential_stiffness_n_per_m,
                      {1.0, 1e8},
                      "N/m",
                      "tangential stiffness of a corner"},
                Field{"contact.tangential_damping_n_s_per_m",
                      &contact.tangential_damping_n_s_per_m,
                      {0.0, 1e6},
                      "N s/m",
                      "tangential damping of a corner"}});
}

void append_sensors(std::vector<Field>& table, sim_hw::SensorConfig& sensor) {
  table.insert(
      table.end(),
      {Field{"sensor.encoder_resolution_rad", &sensor.encoder_resolution_rad, {0.0, 0.1}, "rad", "step of an encoder"},
       Field{
           "sensor.encoder_noise_rad", &sensor.encoder_noise_rad, {0.0, 0.1}, "rad", "standard deviation of an angle"},
       Field{"sensor.joint_rate_noise_rad_s",
             &sensor.joint_rate_noise_rad_s,
             {0.0, 10.0},
             "rad/s",
             "standard deviation of a joint rate"},
       Field{"sensor.force_resolution_n", &sensor.force_resolution_n, {0.0, 100.0}, "N", "step of a load cell"},
       Field{"sensor.force_noise_n", &sensor.force_noise_n, {0.0, 1000.0}, "N", "standard deviation of a corner force"},
       Field{"sensor.gyro_noise_rad_s", &sensor.gyro_noise_rad_s, {0.0, 10.0}, "rad/s", "standard deviation of a gyro"},
       Field{"sensor.accelerometer_noise_m_s2",
             &sensor.accelerometer_noise_m_s2,
             {0.0, 100.0},
             "m/s2",
             "standard deviation of an accelerometer"},
       flag_field("sensor.has_inertial_legs", sensor.has_inertial_legs,
                  "gyros at the hips, inclinometers and accelerometers in the feet"),
       Field{"sensor.hip_gyro_range_rad_s",
             &sensor.hip_gyro_range_rad_s,
             {0.0, 16.0, true},
             "rad/s",
             "largest rate that a hip gyro tells"},
       Field{"sensor.inclinometer_range_rad",
             &sensor.inclinometer_range_rad,
             {0.0, 1.5, true},
             "rad",
             "largest angle that a foot's inclinometer tells"},
       Field{"sensor.foot_accelerometer_range_m_s2",
             &sensor.foot_accelerometer_range_m_s2,
             {0.0, 160.0, true},
             "m/s2",
             "largest acceleration that a foot's accelerometer tells"},
       Field{"sensor.hip_gyro_noise_rad_s",
             &sensor.hip_gyro_noise_rad_s,
             {0.0, 10.0},
             "rad/s",
             "standard deviation of a hip gyro"},
       Field{"sensor.inclinometer_noise_rad",
             &sensor.inclinometer_noise_rad,
             {0.0, 1.0},
             "rad",
             "standard deviation of a foot's inclinometer"},
       Field{"sensor.foot_accelerometer_noise_m_s2",
             &sensor.foot_accelerometer_noise_m_s2,
             {0.0, 100.0},
             "m/s2",
             "standard deviation of a foot's accelerometer"}});
}

void append_bus(std::vector<Field>& table, sim_hw::SimConfig& sim) {
  sim_hw::BusConfig& bus = sim.bus;
  table.insert(
      table.end(),
      {Field{
           "bus.nominal_bit_rate_hz", &bus.nominal_bit_rate_hz, {1e4, 1e6}, "Hz", "bit rate of the arbitration phase"},
       Field{"bus.data_bit_rate_hz", &bus.data_bit_rate_hz, {1e4, 8e6}, "Hz", "bit rate of the data phase"},
       Field{"bus.count", &bus.count, {1.0, sim_hw::kMaxBuses}, "1", "number of CAN buses; 2: one for each leg"},
       Field{"bus.node_latency_s", &bus.node_latency_s, {0.0, 1e-2}, "s", "time from SYNC to a node's answer"},
       Field{"bus.node_jitter_s", &bus.node_jitter_s, {0.0, 1e-2}, "s", "largest random addition to the node latency"},
       Field{"bus.compute_s", &bus.compute_s, {0.0, 1e-2}, "s", "time from the last node's answer to the torques"},
       Field{"bus.command_latency_s",
             &sim.command_latency_s,
             {0.0, 0.1},
             "s",
             "time from the start of a tick to its torques at the motors"},
       Field{"bus.watchdog_s",
             &sim.watchdog_s,
             {1e-4, 10.0},
             "s",
             "time without a torque frame after which the leg boards damp"}});
}

}  // namespace

void append_simulator_fields(std::vector<Field>& table, Scenario& scenario) {
  sim_hw::SimConfig& sim = scenario.sim;
  append_masses(table, sim.mass);
  append_drives(table, sim.drive);
  append_floor(table, sim.contact, sim.terrain);
  append_contact(table, sim.contact);
  append_sensors(table, sim.sensor);
  append_bus(table, sim);
  table.push_back({"physics.step_s", &sim.physics_step_s, {1e-5, 2e-3}, "s", "step of the physics"});
}

}  // namespace surefoot::scenario
