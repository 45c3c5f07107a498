#pragma once

#include "sim_hw/ground_truth.hpp"
#include "sim_hw/nodes/imu_node.hpp"
#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {

/// Sums floor forces over a control period and writes down what really happened in it.
class TruthRecorder {
 public:
  /// @param time_s  the scenario's clock at the start
  TruthRecorder(const World&, double time_s) noexcept;

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

 private:
  void read_pose(const World&) noexcept;
  void read_forces(const RobotModel&, int steps) noexcept;

  GroundTruth truth_{};
  TorsoMotion torso_{};
  double initial_height_m_;
  PerSide<std::array<double, geometry::kCornersPerFoot>> force_sum_n_{};
  btVector3 moment_sum_nm_{0, 0, 0};
};

}  // namespace surefoot::sim_hw
