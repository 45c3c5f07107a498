#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim_hw/ground_truth.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::plan {

/// Pressure centre and support along the direction in which the body looks, on the floor, at one instant.
struct TruePressure {
  double zmp_m = 0.0;              ///< from the world's origin, in that direction
  double rear_m = 0.0;             ///< rearmost corner that carries
  double front_m = 0.0;            ///< foremost one
  std::array<double, 2> foot_m{};  ///< each foot's frame

  /// To the nearer edge; never negative, for a floor only pushes.
  [[nodiscard]] double margin_m() const noexcept { return std::min(zmp_m - rear_m, front_m - zmp_m); }
};

/// From the true forces on the soles' corners. A corner carries from 1 N on.
/// @return nothing where no corner does
[[nodiscard]] std::optional<TruePressure> true_pressure(const geometry::RobotGeometry&, const sim_hw::GroundTruth&);

/// One tick of a walk: planned and measured pressure centre, from the foothold of the foot that landed last.
struct ZmpSample {
  double time_s = 0.0;  ///< scenario clock
  double planned_m = 0.0;
  double measured_m = 0.0;
  double rear_m = 0.0;  ///< true edges
  double front_m = 0.0;
};

/// How a planned gait was walked. What is not known has no value: no step was walked, or the plan stretches a knee.
struct Walked {
  std::string file;
  std::string robot;
  std::string pattern;  ///< of the first gait; "several" where they differ
  bool has_fallen = false;
  bool has_fault = false;
  int steps = 0;  ///< begun
  double greatest_roll_deg = 0.0;
  double greatest_pitch_deg = 0.0;
  std::optional<double> planned_margin_m =
      std::nullopt;  ///< by `planning::check_step` at the walk's pelvis height, least
  std::optional<double> least_margin_m = std::nullopt;     ///< true one, after the first 3 steps
  std::optional<double> fifth_margin_m = std::nullopt;     ///< 5th percentile
  std::optional<double> rms_difference_m = std::nullopt;   ///< measured less planned pressure centre
  std::optional<double> most_difference_m = std::nullopt;  ///< largest magnitude
  std::vector<ZmpSample> picture = {};                     ///< steps 5 to 8, every 10 ms

  [[nodiscard]] const char* verdict() const noexcept { return has_fallen ? "fell" : has_fault ? "fault" : "walked"; }
};

/// Sums up a walk's steps, each from its landing to the next one: those after the first 3 count, of the last only what
/// lies before the run's end. A step in which no foot is lifted is left out.
void sum_up(std::span<const std::vector<ZmpSample>> steps, Walked& walked);

/// Walks a scenario with planned gaits in lockstep, unrecorded.
[[nodiscard]] Walked walk(const std::string& file, const scenario::Scenario& scenario);

[[nodiscard]] std::string walked_text(std::span<const Walked> walks);
[[nodiscard]] std::string walked_json(std::span<const Walked> walks, bool with_samples);

}  // namespace surefoot::plan
