#pragma once

#include <cstdint>
#include <vector>

#include "sim_hw/world/world.hpp"

namespace surefoot::sim_hw {

/// What happens to the robot on the scenario's clock: boxes hung on and taken off, pushes. All of it begins with the
/// physics step whose begin is nearest. Does not allocate after construction.
class Disturbances {
 public:
  explicit Disturbances(const SimConfig&);

  /// Before a step that begins at `time_s`: boxes that are due come on or off, pushes that are due begin.
  void begin_due(double time_s, World&) noexcept;

  /// Before every step: gives it its share of the pushes that act.
  void push(World&) noexcept;

  /// Bit i: push i of the scenario has begun; it acts no more. So far, both.
  [[nodiscard]] std::uint32_t pushes_begun() const noexcept { return begun_; }
  [[nodiscard]] std::uint32_t pushes_ended() const noexcept { return ended_; }

 private:
  struct Push {
    double at_s;
    geometry::Vector3 force_world_n;  ///< scaled to whole steps
    geometry::Vector3 point_body_m;
    std::int64_t steps_left;
  };

  std::vector<PayloadConfig> payloads_;  ///< by the time at which they are hung on
  std::vector<std::size_t> removals_;    ///< places in `payloads_`, by the time at which they are taken off
  std::vector<Push> pushes_;
  double half_step_s_;
  std::size_t next_payload_ = 0;
  std::size_t next_removal_ = 0;
  std::uint32_t begun_ = 0;
  std::uint32_t ended_ = 0;
};

}  // namespace surefoot::sim_hw
