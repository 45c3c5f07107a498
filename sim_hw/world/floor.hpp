#pragma once

#include <array>
#include <memory>
#include <utility>

#include "sim_hw/world/robot_model.hpp"

namespace surefoot::sim_hw {

/// What the floor does to one sole in one step.
struct SoleLoad {
  std::array<double, geometry::kCornersPerFoot> normal_n{};  ///< at each corner, never negative
  btVector3 normal_moment_world_nm{0, 0, 0};                 ///< sum of normal force times corner position
  double sliding_n_m = 0.0;                                  ///< sum of normal force times the way slid in this step

  [[nodiscard]] double normal_sum_n() const noexcept { return normal_n[0] + normal_n[1] + normal_n[2] + normal_n[3]; }
};

/// What carries the robot: the seam between contact models. A model takes the whole physics step,
/// because a solver of its own must see contact and motion together.
class Floor {
 public:
  virtual ~Floor() = default;

  /// One step: floor forces, motor torques held constant, joint friction, gravity.
  virtual void step(RobotModel& robot, const PerSide<LegVector>& motor_torque_nm, double step_s) noexcept = 0;

  /// Reads the forces of the present pose without moving, before the first step. A solver that
  /// knows forces only from its steps leaves them at zero.
  virtual void touch(const RobotModel& robot) noexcept = 0;

  /// Forces of the last step.
  [[nodiscard]] virtual const PerSide<SoleLoad>& loads() const noexcept = 0;

  /// How deep the corners of a robot at rest lie below the floor's surface.
  [[nodiscard]] virtual double resting_depth_m(double total_mass_kg) const noexcept = 0;

  /// The same floor with all that it remembers; none of a floor that is one with its robot.
  [[nodiscard]] virtual std::unique_ptr<Floor> copy() const { return nullptr; }
};

/// Owns a floor; a copy owns a copy of it. Not to be copied where `Floor::copy` gives none.
class OwnFloor {
 public:
  explicit OwnFloor(std::unique_ptr<Floor> floor) noexcept : floor_(std::move(floor)) {}
  OwnFloor(const OwnFloor& other) : floor_(other.floor_->copy()) {}
  OwnFloor& operator=(const OwnFloor&) = delete;
  ~OwnFloor() = default;

  [[nodiscard]] Floor* operator->() noexcept { return floor_.get(); }
  [[nodiscard]] const Floor* operator->() const noexcept { return floor_.get(); }

 private:
  std::unique_ptr<Floor> floor_;
};

}  // namespace surefoot::sim_hw
