#pragma once

#include "firmware/core/decision/payload_shift.hpp"
#include "firmware/core/estimation/attitude.hpp"
#include "firmware/core/estimation/estimator.hpp"
#include "firmware/core/foot_reference.hpp"
#include "firmware/core/gait/floor_walk.hpp"
#include "firmware/core/geometry/robot_geometry.hpp"
#include "firmware/core/sensor_snapshot.hpp"
#include "firmware/core/stabilizer/nominal_table.hpp"
#include "firmware/core/stabilizer/stabilizer.hpp"

namespace surefoot {

/// The walk on uneven floors beyond `gait::WalkParameters`. Source: Kim, Park, Oh 2007.
struct FloorWalkerConfig {
  gait::FourFactorParameters pattern{};
  estimation::AttitudeConfig attitude{};
  estimation::AnkleSensorRange ankle_range{};
  stabilizer::StabilizerConfig stabilizer{};
  stabilizer::NominalTable nominal{};
  double body_mass_kg = 56.0;  ///< without load
  decision::PayloadShiftConfig payload{};
};

/// Everything that lives between two ticks.
struct FloorWalkerState {
  gait::FloorWalkState walk{};
  estimation::AttitudeState attitude{};
  stabilizer::StabilizerState stabilizer{};
  stabilizer::Adjustment last{};
  PerSide<double> planned_foot_pitch_rad{};  ///< of the tick before: the soles of a planned walk roll
  double standing_force_n = 0.0;  ///< filtered force at the end of the standing, loads that were answered included
  decision::PayloadShiftState payload{};
};

/// What one tick of it produced.
struct FloorWalkerOutput {
  stabilizer::StabilizerInput input{};
  stabilizer::StabilizerOutput adjustment{};
  FootReference foot_reference{};
  JointReference joint_reference{};
  double planned_zmp_x_foot_m = 0.0;  ///< of a planned walk, from the foothold of the foot that landed last
};

/// One tick: sensors, stages, controllers, feet, joints.
///
/// @param detector  of loads; its state and the reflex' are `FloorWalkerState::payload`
/// @param answers   whether the pelvis moves when a load is seen
/// @param stops     the walk shall end, for good
/// @param period_s  time since the last call, > 0
[[nodiscard]] FloorWalkerOutput step(const FloorWalkerConfig&, const gait::WalkParameters&,
                                     const geometry::RobotGeometry&, const decision::PayloadDetectorConfig& detector,
                                     bool answers, FloorWalkerState&, const SensorSnapshot&,
                                     const estimation::Estimate&, bool stops, double period_s) noexcept;

}  // namespace surefoot
