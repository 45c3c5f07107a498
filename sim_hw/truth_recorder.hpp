#pragma once

#include "sim_hw/ground_truth.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "sim_hw/nodes/inertial_motion.hpp"
#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {

/// Sums floor forces over a control period and writes down what really happened in it.
class TruthRecorder {
 public:
  /// @param time_s             the scenario's clock at the start
  /// @param has_inertial_legs  whether `leg_inertial` is wanted
  TruthRecorder(const World&, double time_s, bool has_inertial_legs = false) noexcept;

  /// After each physics step.
  void add_step(const PerSide<SoleLoad>& loads) noexcept;

  /// At the end of a period of `steps` steps.
  void close_period(const World&, const PerSide<LegVector>& torque_nm, double time_s, int steps,
                    double period_s) noexcept;

  /// Which faults are on from now on.
  void mark_faults(std::uint32_t active) noexcept { truth_.faults_active = active; }

  /// Which pushes have begun and ended so far.
  void mark_pushes(std::uint32_t begun, std::uint32_t ended) noexcept {
    truth_.pushes_begun = begun;
    truth_.pushes_ended = ended;
  }

  [[nodiscard]] const GroundTruth& truth() const noexcept { return truth_; }
  /// What an IMU at the body frame's origin felt in the period.
  [[nodiscard]] const TorsoMotion& torso() const noexcept { return torso_; }
  /// What inertial sensors in legs and feet felt in the period; zero where nobody wanted it.
  [[nodiscard]] const PerSide<LegInertialMotion>& leg_inertial() const noexcept { return leg_inertial_; }

 private:
  void read_pose(const World&) noexcept;
  void read_forces(const RobotModel&, int steps) noexcept;
  void read_legs(const RobotModel&, double period_s) noexcept;

  GroundTruth truth_{};
  TorsoMotion torso_{};
  PerSide<LegInertialMotion> leg_inertial_{};
  PerSide<geometry::Vector3> sole_velocity_world_m_s_{geometry::Vector3::Zero(), geometry::Vector3::Zero()};
  bool has_inertial_legs_;
  double initial_height_m_;
  PerSide<std::array<double, geometry::kCornersPerFoot>> force_sum_n_{};
  btVector3 moment_sum_nm_{0, 0, 0};
};

}  // namespace surefoot::sim_hw
