#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "firmware/core/geometry/robot_geometry.hpp"
#include "sim_hw/faults/fault_config.hpp"

namespace surefoot::sim_hw {

/// Masses of the robot; the firmware never sees them.
/// Source: El-Kahlout 2003 prints trunk and leg masses and the trunk's size; the split of a leg and
/// the box shapes of its links are assumptions.
struct MassConfig {
  double trunk_kg = 50.0;
  std::array<double, 3> trunk_size_m{0.2, 0.4, 0.5};         ///< L x W x H
  std::array<double, 3> trunk_com_body_m{-0.05, 0.0, 0.25};  ///< s
  double thigh_kg = 9.5;
  double calf_kg = 0.5;
  double foot_kg = 5.0;
  double foot_com_x_foot_m = 0.02;  ///< ahead of the ankle; with the hip's place it sets the standing ZMP (-0.0344 m)
};

/// Geared joint drives. The rotor's inertia behind the gear is what keeps stiff sampled joints stable.
struct DriveConfig {
  double rotor_inertia_kg_m2 = 0.4;              ///< reflected to the joint
  LegVector rotor_share{1, 1, 1, 1, 1, 1};       ///< of `rotor_inertia_kg_m2`, joint by joint
  double hip_knee_friction_nm_s_per_rad = 10.0;  ///< viscous
  double ankle_friction_nm_s_per_rad = 20.0;     ///< viscous
  double torque_limit_nm = 200.0;
  /// Of the leg boards' position servo: torque = kp (reference - angle) + kd (its rate - rate).
  LegVector servo_stiffness_nm_per_rad{3000, 17000, 8000, 8000, 2000, 2000};
  LegVector servo_damping_nm_s_per_rad{30, 180, 80, 80, 60, 60};
  /// Spring between the hip roll motor and the leg, 0: rigid. The encoder sits at the motor.
  double hip_roll_stiffness_nm_per_rad = 0.0;
  double hip_roll_damping_nm_s_per_rad = 2.0;  ///< of that spring
};

/// What carries the robot.
enum class ContactModel : std::uint8_t {
  kSpringDamper,  ///< four spring-dampers with anchored friction at the corners of each sole
  kBullet,        ///< Bullet's contact solver on four small spheres a sole, to contradict the other
};

/// Floor and soles. Stiffness and damping are per corner.
///
/// The floor is a plane. Its slopes are turns of the floor as torso angles are turns of the torso, rotation z-y-x with
/// yaw zero: a positive pitch goes downhill ahead, a positive roll downhill to the right. The world frame is the
/// floor's: z along its normal, x ahead at the start; only gravity leans in it.
struct ContactConfig {
  double friction = 0.7;
  double slope_pitch_deg = 0.0;  ///< about y, positive downhill ahead
  double slope_roll_deg = 0.0;   ///< about x, positive downhill to the right
  ContactModel model = ContactModel::kSpringDamper;
  double normal_stiffness_n_per_m = 6.0e5;
  double normal_damping_n_s_per_m = 3000.0;
  double tangential_stiffness_n_per_m = 1.0e4;
  double tangential_damping_n_s_per_m = 1500.0;
};

/// What a rough floor is made of, on top of the plane that `ContactConfig` tilts. All of it in the plane's frame.
enum class PatchKind : std::uint8_t {
  kPlate,     ///< raises the floor by `height_m`; also a step, where it is long
  kRamp,      ///< rises from 0 at its near edge (least x) to `height_m` at its far one
  kFriction,  ///< only its friction differs
};

/// A rectangle of floor.
struct PatchConfig {
  PatchKind kind = PatchKind::kPlate;
  std::array<double, 2> centre_m{1.0, 0.0};
  std::array<double, 2> size_m{0.12, 0.12};
  double height_m = 0.004;
  double friction = -1.0;  ///< below 0: that of what lies below
};

/// Most patches on one floor.
inline constexpr std::size_t kMaxPatches = 64;

/// The floor's surface. Tiles: squares whose heights are drawn from 0 to `tile_height_m`, by `tile_seed`.
struct TerrainConfig {
  double tile_height_m = 0.0;  ///< 0: no tiles
  double tile_edge_m = 0.03;
  std::uint64_t tile_seed = 1;
  /// Scattered square plates of `plate_edge_m`, placed by `tile_seed`: so many on each square metre, at most one on
  /// each square of their own size.
  double plates_per_m2 = 0.0;
  double plate_height_m = 0.004;
  double plate_edge_m = 0.12;
  /// At most `kMaxPatches`. They lie on the tiles; where several lie, the highest carries, and the friction is that of
  /// the last in the list that has one.
  std::vector<PatchConfig> patches{};
};

/// Sensors of the nodes: resolution, noise (standard deviation) and range, in physical units.
struct SensorConfig {
  double encoder_resolution_rad = 1.0e-5;
  double encoder_noise_rad = 0.0;
  double joint_rate_noise_rad_s = 0.0;
  double force_resolution_n = 0.1;
  double force_noise_n = 0.0;
  double gyro_noise_rad_s = 0.0;
  double accelerometer_noise_m_s2 = 0.0;
  /// Legs and feet carry inertial sensors and send their frames.
  bool has_inertial_legs = false;
  double hip_gyro_range_rad_s = 1.745;           ///< 100 deg/s (Kim, Park, Oh 2007, Table 2)
  double inclinometer_range_rad = 0.262;         ///< 15 degrees
  double foot_accelerometer_range_m_s2 = 19.62;  ///< 2 g
  double hip_gyro_noise_rad_s = 0.0;
  double inclinometer_noise_rad = 0.0;
  double foot_accelerometer_noise_m_s2 = 0.0;
};

/// How the trunk's inertia follows a payload.
enum class PayloadInertia : std::uint8_t {
  kThesis,  ///< scaled with mass, eq. (3.8)
  kExact,   ///< trunk and box about their common centre of mass (parallel axes)
};

/// An instant that never comes.
inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// A box hung on the trunk at one instant, eqs. (3.8)-(3.10), and taken off at another; neither with a velocity jump.
struct PayloadConfig {
  double mass_kg = 5.0;
  double at_s = 1.2;                                  ///< on the scenario's clock
  double removed_at_s = kNever_s;                     ///< the same, later than `at_s`
  std::array<double, 3> position_m{0.20, 0.0, 0.25};  ///< its centre of mass, body frame
  double edge_m = 0.2;                                ///< cube
  PayloadInertia inertia = PayloadInertia::kThesis;
};

/// Most pushes in one run.
inline constexpr std::size_t kMaxPushes = 16;

/// A constant force on the trunk for a while. It acts over whole physics steps, at least one; where the duration is no
/// whole number of them the force is scaled so that the impulse is force times duration exactly.
struct PushConfig {
  double at_s = 5.0;                ///< on the scenario's clock
  double duration_s = 0.1;          ///< above 0
  std::array<double, 3> force_n{};  ///< world frame: x ahead at the start, y left, z along the floor's normal
  std::array<double, 3> point_body_m{0.0, 0.0, 0.25};  ///< where it acts, moving with the trunk; default its middle
};

/// The CAN bus, or the two of them. Bit rates last a whole number of nanoseconds a bit.
struct BusConfig {
  double nominal_bit_rate_hz = 1.0e6;
  double data_bit_rate_hz = 5.0e6;
  std::uint32_t count = 1;      ///< 1, or 2: one for each leg, the torso IMU on the right leg's
  double node_latency_s = 0.0;  ///< from the end of SYNC to the answer of a node being ready
  double node_jitter_s = 0.0;   ///< up to so much more, drawn anew for each answer
  double compute_s = 2.0e-5;    ///< from the end of the last state frame to the torques being ready
};

/// The robot that is not there: everything the simulator knows and the firmware does not.
struct SimConfig {
  geometry::RobotGeometry geometry{};
  MassConfig mass{};
  DriveConfig drive{};
  ContactConfig contact{};
  TerrainConfig terrain{};
  SensorConfig sensor{};
  std::vector<PayloadConfig> payloads{};
  std::vector<PushConfig> pushes{};   ///< at most `kMaxPushes`
  std::vector<FaultConfig> faults{};  ///< at most `kMaxFaults`
  BusConfig bus{};
  double control_period_s = 1.0e-3;   ///< world time between two SYNC frames in lockstep
  double physics_step_s = 5.0e-4;     ///< divides the control period
  double command_latency_s = 1.0e-3;  ///< from the tick's start to its torques at the motors: bus and computing
  double watchdog_s = 0.02;           ///< leg boards damp when no torque frame came for this long
  double time_zero_s = 0.0;           ///< world time at which the scenario's clock reads 0
  std::uint64_t seed = 1;
};

}  // namespace surefoot::sim_hw
