#include "firmware/core/gait/planned_walk.hpp"

#include "firmware/core/gait/floor_sway.hpp"
#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::gait {
namespace {

FootOffset offset_of(const planning::FootPoint& foot, double flat_x_m) noexcept {
  return {foot.x_m.position - flat_x_m, foot.z_m.position, foot.pitch_rad.position};
}

}  // namespace

WalkParameters timed(WalkParameters walk, const FourFactorParameters& pattern, const FloorWalkState& state) noexcept {
  if (pattern.gaits.is_empty()) return walk;
  const planning::GaitFactors& gait = pattern.gaits.of_step(state.steps > 0 ? state.steps - 1 : 0).gait;
  walk.single_support_s = gait.single_support_s;
  walk.double_support_s = gait.double_support_s;
  return walk;
}

void plan_stride(const WalkParameters& before, const FourFactorParameters& pattern, FloorWalkState& state) noexcept {
  using planning::operator-;
  const std::uint32_t steps = pattern.gaits.steps();
  const bool closes = steps > 0 && state.steps >= steps;
  const double stance_x_m = state.foothold_m[index(opposite(state.moving))].x();
  const planning::StepPlan& plan = pattern.gaits.of_step(state.steps);
  StrideBorders borders;
  borders.from_m = state.stride.borders().to_m;
  borders.to_m = state.stops || closes ? 0.0 : plan.gait.step_length_m;
  borders.comes_to_rest = state.stops || closes;
  if (state.steps > 0) {
    borders.com_x_m = state.stride.at(state.stride.duration_s()).com_x_m;
    borders.com_x_m.position += state.stride_origin_x_m - stance_x_m;
  }
  state.stride = PlannedStride(plan, borders, state.stride);
  state.stride_origin_x_m = stance_x_m;
  state.target_m.x() = stance_x_m + borders.to_m;

  const LateralPendulum sway_before = state.com_y;
  WalkParameters walk = before;
  walk.single_support_s = plan.gait.single_support_s;
  walk.double_support_s = plan.gait.double_support_s;
  state.com_y = lateral_pendulum(walk, pattern);
  const ScalarMotion own = state.stops ? ScalarMotion{} : state.com_y.at(0.0);
  state.sway_join_m = ScalarMotion{} - sway_before.at(before.step_s()) - own;
}

bool has_closed(const FourFactorParameters& pattern, const FloorWalkState& state) noexcept {
  const std::uint32_t steps = pattern.gaits.steps();
  return steps > 0 && state.steps > steps;
}

PerSide<FootOffset> planned_offsets(const WalkParameters& walk, const FloorWalkState& state) noexcept {
  const StrideBorders& borders = state.stride.borders();
  const StrideInstant now = state.stride.at(state.step_time_s);
  PerSide<FootOffset> offset{};
  offset[index(opposite(state.moving))] = offset_of(now.stance, 0.0);
  if (state.stage == decision::WalkStage::kLanding) return offset;  // nobody lifts a foot any more
  const double progress = swing_progress(state.held_share.value_or(swing_share(walk, state.step_time_s)));
  const double straight_x_m = -borders.from_m + progress * (borders.from_m + borders.to_m);
  FootOffset& swing = offset[index(state.moving)];
  swing = offset_of(now.swing, straight_x_m);
  if (state.held_share) {
    const double held_s = walk.double_support_s + *state.held_share * walk.single_support_s;
    swing.z_m = state.stride.at(held_s).swing.z_m.position;
  }
  return offset;
}

void keep_held_height(const WalkParameters& walk, FloorWalkState& state) noexcept {
  if (!state.held_share) return;
  const double held_s = walk.double_support_s + *state.held_share * walk.single_support_s;
  state.foothold_m[index(state.moving)].z() +=
      state.stride.at(held_s).swing.z_m.position - state.stride.at(walk.step_s()).swing.z_m.position;
}

double planned_pelvis_x_m(const FourFactorParameters& pattern, const FloorWalkState& state) noexcept {
  if (state.steps == 0) return pattern.pelvis_x_m;
  return state.stride_origin_x_m + state.stride.at(state.step_time_s).com_x_m.position + pattern.pelvis_x_m;
}

}  // namespace surefoot::gait
