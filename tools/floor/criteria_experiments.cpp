#include <fmt/format.h>

#include "tools/floor/criteria.hpp"

namespace surefoot::floor {
namespace {

using stabilizer::Controller;

constexpr int kPushInstants = 8;  // of a gait cycle
constexpr double kCycle_s = 1.9;
constexpr double kPushesFrom_s = 4.0;

using Overrides = std::vector<std::string>;

Wanted near(double value, double tolerance) { return {Wanted::Kind::kNear, value, tolerance}; }

Overrides walk_of(double duration_s, const Overrides& more = {}) {
  Overrides overrides{"pattern.standing_s=2", fmt::format("duration_s={}", duration_s)};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return overrides;
}

Overrides tiles_of(int height_mm) { return walk_of(10.0, {fmt::format("floor.tile_height_m={}", 1e-3 * height_mm)}); }

std::vector<batch::Trial> each_seed(const std::vector<std::uint64_t>& seeds) {
  std::vector<batch::Trial> walks;
  for (const std::uint64_t seed : seeds) walks.push_back({{fmt::format("floor.tile_seed={}", seed)}});
  return walks;
}

/// To the left and to the right, at instants all over a gait cycle.
std::vector<batch::Trial> pushes_of(int impulse_n_s) {
  std::vector<batch::Trial> walks;
  for (int i = 0; i < kPushInstants; ++i) {
    for (const int side : {1, -1}) {
      walks.push_back({{fmt::format("push.0.at_s={}", kPushesFrom_s + kCycle_s * i / kPushInstants),
                        "push.0.duration_s=0.1", "push.0.point_body_m=[0.0, 0.0, 0.25]",
                        fmt::format("push.0.force_n=[0.0, {}.0, 0.0]", side * impulse_n_s * 10)}});
    }
  }
  return walks;
}

std::string pushed(int impulse_n_s) { return fmt::format("flat, {} N s to either side", impulse_n_s); }

/// Slow steps, the trunk's centre at the right: it stands on its right leg while the left one is lifted for 2 s, and
/// the contact's release sets that one swinging on its flexible hip at the paper's 4.35 Hz.
Overrides one_leg_rig() {
  return walk_of(2.1,
                 {"mass.trunk_com_body_m=[0.0, -0.1, 0.25]", "gait.sway_m=0.01", "gait.single_support_s=4",
                  "detector.learning_s=12", "payload_shift.measuring_s=12", "plausibility.foot_frozen_loaded_s=600",
                  "plausibility.imu_frozen_s=600", "drive.hip_roll_stiffness_nm_per_rad=3600"});
}

std::vector<Experiment> all_experiments(const std::vector<std::uint64_t>& seeds) {
  const std::vector<batch::Trial> once{{}};
  const std::vector<batch::Trial> tiles = each_seed(seeds);
  const Wanted less{};
  const Overrides pushed_walk = walk_of(kPushesFrom_s + kCycle_s + 2.5);
  return {
      {Controller::kUprightPose,
       "off",
       "standing on 3 deg across, after 15 s",
       {"floor.slope_roll_deg=3", "pattern.standing_s=16", "duration_s=0.1"},
       once,
       {{"leg correction, commanded", "mm", commanded_leg_correction_mm, near(3.72, 0.1)},
        {"leg correction, of the joints", "mm", true_leg_correction_mm, near(3.72, 0.1)},
        {"ankles' roll, commanded", "deg", commanded_ankle_roll_deg, near(3.0, 0.1)},
        {"ankles' roll, of the joints", "deg", true_ankle_roll_deg, near(3.0, 0.1)},
        {"torso's roll", "deg", torso_lean_deg, less}}},
      {Controller::kLandingMomentum,
       "off",
       "tiles of 4 mm",
       tiles_of(4),
       tiles,
       {{"momentum's error after its window", "N m s", landed_momentum_error_nms, less}}},
      {Controller::kShockAbsorber,
       "off",
       "tiles of 8 mm",
       tiles_of(8),
       tiles,
       {{"peak force of early landings", "N", early_landing_peak_n, {Wanted::Kind::kBelow, 30.0, 0.0}}}},
      {Controller::kShockAbsorber,
       "extended",
       "tiles of 8 mm",
       tiles_of(8),
       tiles,
       {{"peak force of early landings", "N", early_landing_peak_n, {Wanted::Kind::kBelow, 30.0, 0.0}}}},
      {Controller::kLandingTiming,
       "off",
       "tiles of 4 mm",
       tiles_of(4),
       tiles,
       {{"contact to end of lowering", "ms", landing_error_ms, less},
        {"steps begun before the contact", "%", landed_late_percent, less}}},
      {Controller::kLandingPosition,
       "off",
       pushed(5),
       pushed_walk,
       pushes_of(5),
       {{"landing point against eq. (15)", "mm", landing_position_error_mm, less},
        {"largest roll after the push", "deg", roll_after_push_deg, less}}},
      {Controller::kVibrationReduction,
       "off",
       "on one leg, flexible hips",
       one_leg_rig(),
       once,
       {{"hip's vibration left after 1 s", "%", vibration_left_percent, {Wanted::Kind::kAtMost, 1.0, 0.0}}}},
      {Controller::kDamping,
       "off",
       pushed(5),
       pushed_walk,
       pushes_of(5),
       {{"torso's roll rate after the push", "deg/s", rate_after_push_deg_s, less}}},
      {Controller::kZmpCompensator,
       "off",
       "tiles of 2 mm",
       tiles_of(2),
       tiles,
       {{"ZMP's error", "mm", zmp_error_mm, less}}},
      {Controller::kZmpCompensator,
       "extended",
       "tiles of 4 mm",
       tiles_of(4),
       tiles,
       {{"ZMP's error", "mm", zmp_error_mm, less}}},
      {Controller::kSoftLanding,
       "off",
       "tiles of 4 mm",
       tiles_of(4),
       tiles,
       {{"peak moment on the landing foot", "N m", landing_moment_peak_nm, less}}},
      {Controller::kSwayAmplitude,
       "off",
       "flat, sway of 55 mm instead of 60",
       walk_of(20.0, {"gait.sway_m=0.055"}),
       once,
       {{"ZMP's outermost place, error", "mm", zmp_peak_error_mm, less}}},
      {Controller::kTorsoTilt,
       "off",
       "slope of 2 deg, roll and pitch",
       walk_of(20.0, {"floor.slope_roll_deg=2", "floor.slope_pitch_deg=2"}),
       once,
       {{"mean tilt of two gait cycles", "deg", mean_tilt_deg, less}}},
      {Controller::kTiltOver,
       "off",
       pushed(10),
       pushed_walk,
       pushes_of(10),
       {{"largest roll after the push", "deg", roll_after_push_deg, less}}},
      {Controller::kTiltLandingPosition,
       "off",
       pushed(10),
       pushed_walk,
       pushes_of(10),
       {{"largest roll after the push", "deg", roll_after_push_deg, less}}},
  };
}

}  // namespace

std::vector<Experiment> criterion_experiments(const std::vector<std::uint64_t>& seeds, const std::string& controller) {
  std::vector<Experiment> experiments = all_experiments(seeds);
  if (!controller.empty()) {
    std::erase_if(experiments, [&](const Experiment& one) { return stabilizer::name(one.controller) != controller; });
  }
  return experiments;
}

}  // namespace surefoot::floor
