#include "firmware/core/gait/floor_walk.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::gait {
namespace {

using decision::WalkEvent;
using decision::WalkStage;
using stabilizer::Adjustment;
using stabilizer::WalkView;

constexpr double kGravity_m_s2 = 9.81;
constexpr double kLeastRemainingShare = 0.5;  // of a lowering that is to end earlier

void move_on(FloorWalkState& state, WalkEvent event) noexcept {
  const auto next = decision::next_stage(state.stage, event);
  if (!next) return;
  state.stage = *next;
  state.time_in_stage_s = 0.0;
}

double natural_rate_rad_s(const FourFactorParameters& pattern) noexcept {
  return std::sqrt(kGravity_m_s2 / pattern.com_height_m);
}

double shift_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.shift_steps * walk.step_s() - 0.5 * walk.double_support_s;
}

/// With the durations of the stride that is walked, or will be first.
WalkParameters timed(WalkParameters walk, const FourFactorParameters& pattern, const FloorWalkState& state) noexcept {
  if (pattern.gaits.is_empty()) return walk;
  const planning::GaitFactors& gait = pattern.gaits.of_step(state.steps > 0 ? state.steps - 1 : 0).gait;
  walk.single_support_s = gait.single_support_s;
  walk.double_support_s = gait.double_support_s;
  return walk;
}

/// Time in which the pressure centre goes from foot to foot.
double transfer_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.gaits.is_empty() ? pattern.transfer_s : walk.double_support_s;
}

LateralPendulum lateral_pendulum(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  const double transfer = transfer_s(walk, pattern);
  return {walk.foot_offset_y_m, natural_rate_rad_s(pattern), walk.step_s() - transfer, transfer};
}

/// 0 to 1 without velocity at either end.
double smooth(double share) noexcept {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3.0 - 2.0 * s);
}

/// How much of the sway there is.
double sway_share(const WalkParameters& walk, const FourFactorParameters& pattern,
                  const FloorWalkState& state) noexcept {
  switch (state.stage) {
    case WalkStage::kStanding:
      return 0.0;
    case WalkStage::kShifting:
      return smooth(1.0 + state.step_time_s / shift_s(walk, pattern));
    case WalkStage::kLanding:  // a planned walk comes to rest by itself
      return pattern.gaits.is_empty() ? 1.0 - smooth(state.time_in_stage_s / walk.step_s()) : 1.0;
    default:
      return 1.0;
  }
}

/// Pelvis over the middle of the feet, without what fades it in and out.
double full_sway_y_m(const WalkParameters& walk, const FourFactorParameters& pattern, const FloorWalkState& state,
                     double added_m) noexcept {
  if (pattern.gaits.is_empty() && pattern.sway_profile == SwayProfile::kSine) {
    return sway_y_m(walk, walk.sway_m + added_m, state.moving, state.step_time_s);
  }
  const double share = 1.0 / pattern.com_share + added_m / state.com_y.amplitude_m();
  const double earlier_s = 0.5 * (walk.double_support_s - transfer_s(walk, pattern));
  const bool comes_to_rest = !pattern.gaits.is_empty() && state.stage == WalkStage::kLanding;
  const double own_y_m = comes_to_rest ? 0.0 : state.com_y.at(state.step_time_s - earlier_s).position;
  const double com_y_m = own_y_m + quintic(state.sway_join_m, 0.0, walk.step_s(), state.step_time_s).position;
  return -lateral_sign(state.moving) * share * com_y_m;
}

bool is_in_air(const FloorWalkState& state, const WalkParameters& walk) noexcept {
  return decision::is_lifting(state.stage) ||
         (decision::is_lowering(state.stage) && state.step_time_s >= walk.double_support_s);
}

void plan_step(const WalkParameters& walk, const FourFactorParameters& pattern, FloorWalkState& state) noexcept {
  const double natural_rate = natural_rate_rad_s(pattern);
  const geometry::Vector3& stance_m = state.foothold_m[index(opposite(state.moving))];
  const PathPoint begin = state.steps == 0 ? PathPoint{pattern.pelvis_x_m, 0.0} : state.pelvis_x.at(walk.step_s());
  const double length_m = state.stops ? 0.0 : pattern.step_length_m;
  const double half = 0.5 * natural_rate * walk.step_s();
  const PathPoint end{stance_m.x() + 0.5 * length_m + pattern.pelvis_x_m,
                      0.5 * length_m * natural_rate / std::tanh(half)};
  state.pelvis_x = PendulumPath(begin, end, walk.step_s(), natural_rate);
  state.centre_from_y_m = state.centre_to_y_m;
  state.centre_to_y_m = stance_m.y() + lateral_sign(state.moving) * walk.foot_offset_y_m;
  state.target_m = {stance_m.x() + length_m, state.centre_to_y_m + lateral_sign(state.moving) * walk.foot_offset_y_m,
                    0.0};
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

void begin_step(const WalkParameters& walk, const FourFactorParameters& pattern, FloorWalkState& state) noexcept {
  // The four-factor walk begins its first step on the tick; a planned one keeps what the tick is late.
  const bool goes_on = state.steps == 0 && !pattern.gaits.is_empty();
  if (!goes_on) state.step_time_s = std::max(0.0, state.step_time_s - walk.step_s());
  state.clock_rate = 1.0;
  state.waited_s = 0.0;
  state.held_share.reset();
  plan_step(walk, pattern, state);
  if (!pattern.gaits.is_empty()) plan_stride(walk, pattern, state);
  ++state.steps;
}

/// The clock runs faster through the rest of a lowering that shall end earlier.
double clock_rate(const WalkParameters& walk, const FloorWalkState& state, const Adjustment& last) noexcept {
  if (!decision::is_lowering(state.stage) || last.earlier_landing_s <= 0.0) return state.clock_rate;
  const double remaining_s = walk.step_s() - state.step_time_s;
  const double wanted_s = std::max(remaining_s - last.earlier_landing_s, kLeastRemainingShare * remaining_s);
  return state.clock_rate > 1.0 || wanted_s <= 0.0 ? state.clock_rate : remaining_s / wanted_s;
}

void run_clock(const WalkParameters& walk, const FourFactorParameters& pattern, FloorWalkState& state,
               const Adjustment& last, double period_s) noexcept {
  state.clock_rate = clock_rate(walk, state, last);
  const bool waits =
      is_in_air(state, walk) && last.waits_for_contact && !state.has_landed && state.waited_s < pattern.longest_wait_s;
  const double next_s = state.step_time_s + state.clock_rate * period_s;
  if (waits && next_s >= walk.step_s()) {
    state.step_time_s = walk.step_s();
    state.waited_s += period_s;
  } else {
    state.step_time_s = next_s;
  }
}

/// A planned walk has taken its last step, the one that closes the feet.
bool has_closed(const FourFactorParameters& pattern, const FloorWalkState& state) noexcept {
  const std::uint32_t steps = pattern.gaits.steps();
  return steps > 0 && state.steps > steps;
}

/// Where a foot of a planned stride is, seen from its foothold.
struct FootOffset {
  double x_m = 0.0;
  double z_m = 0.0;
  double pitch_rad = 0.0;
};

FootOffset offset_of(const planning::FootPoint& foot, double flat_x_m) noexcept {
  return {foot.x_m.position - flat_x_m, foot.z_m.position, foot.pitch_rad.position};
}

/// A foot in the air is seen from the straight way of its foothold to the next one.
PerSide<FootOffset> planned_offsets(const WalkParameters& walk, const FloorWalkState& state) noexcept {
  const StrideBorders& borders = state.stride.borders();
  const StrideInstant now = state.stride.at(state.step_time_s);
  PerSide<FootOffset> offset{};
  offset[index(opposite(state.moving))] = offset_of(now.stance, 0.0);
  if (state.stage == WalkStage::kLanding) return offset;  // nobody lifts a foot any more
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

/// A foot whose lowering was stopped stands as high as it was then.
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

WalkView view_of(const WalkParameters& walk, const FloorWalkState& state) noexcept {
  const bool swings = is_in_air(state, walk);
  const bool steps = swings || decision::is_lowering(state.stage);
  WalkView view;
  view.stage = state.stage;
  view.is_double_support = !swings;
  view.moving = swings ? state.moving : opposite(state.moving);
  view.swing_share = swings ? swing_share(walk, state.step_time_s) : 1.0;
  view.step_time_s = std::max(0.0, state.step_time_s);
  view.step_share = steps ? std::clamp(view.step_time_s / walk.step_s(), 0.0, 1.0) : 0.0;
  view.has_landed = state.has_landed;
  view.since_landing_s = state.since_landing_s;
  view.is_waiting = state.waited_s > 0.0;
  return view;
}

}  // namespace

WalkView advance(const WalkParameters& given, const FourFactorParameters& pattern, FloorWalkState& state,
                 const PerSide<estimation::AnkleLoad>& ankle, const Adjustment& last, bool stops,
                 double period_s) noexcept {
  const WalkParameters walk = timed(given, pattern, state);
  if (!state.is_set_up) {
    state.is_set_up = true;
    for (const Side side : kSides) {
      state.foothold_m[index(side)] = {0.0, lateral_sign(side) * walk.foot_offset_y_m, 0.0};
    }
    state.pelvis_x = PendulumPath({pattern.pelvis_x_m, 0.0}, {pattern.pelvis_x_m, 0.0}, walk.step_s(), 1.0);
    state.com_y = lateral_pendulum(walk, pattern);
  }
  state.stops = state.stops || stops;
  state.time_in_stage_s += period_s;
  state.since_landing_s += period_s;
  for (const Side side : kSides) {
    if (!is_in_air(state, walk) || side != state.moving) {
      state.foothold_m[index(side)].z() *= std::exp(-period_s / pattern.height_settling_s);
    }
  }

  bool begins = false;
  switch (state.stage) {
    case WalkStage::kStanding:
      if (!state.stops && state.time_in_stage_s >= pattern.standing_s) {
        move_on(state, WalkEvent::kWalkOrdered);
        state.moving = Side::kLeft;
        state.step_time_s = -shift_s(walk, pattern);
      }
      break;
    case WalkStage::kShifting:
      if (state.stops) {
        move_on(state, WalkEvent::kStopOrdered);
        break;
      }
      run_clock(walk, pattern, state, last, period_s);
      begins = state.steps == 0 && state.step_time_s >= 0.0;
      if (begins) begin_step(walk, pattern, state);
      if (state.step_time_s >= walk.double_support_s && ankle[index(Side::kRight)].carries()) {
        move_on(state, WalkEvent::kLiftBegins);
        state.has_landed = false;
      }
      break;
    case WalkStage::kLiftLeft:
    case WalkStage::kLiftRight:
      run_clock(walk, pattern, state, last, period_s);
      if (swing_share(walk, state.step_time_s) >= 0.5) move_on(state, WalkEvent::kTopReached);
      break;
    case WalkStage::kLowerLeft:
    case WalkStage::kLowerRight: {
      const bool was_in_air = is_in_air(state, walk);
      run_clock(walk, pattern, state, last, period_s);
      if (was_in_air) {
        if (!state.has_landed && ankle[index(state.moving)].carries()) {
          state.has_landed = true;
          state.since_landing_s = 0.0;
        }
        if (last.holds_lowering && !state.held_share) state.held_share = swing_share(walk, state.step_time_s);
        const bool waits = last.waits_for_contact && !state.has_landed && state.waited_s < pattern.longest_wait_s;
        if (state.step_time_s >= walk.step_s() && !waits) {
          if (!state.has_landed) state.since_landing_s = 0.0;
          state.has_landed = true;
          if (!pattern.gaits.is_empty()) keep_held_height(walk, state);
          state.moving = opposite(state.moving);
          state.stops = state.stops || has_closed(pattern, state);
          begins = true;
          begin_step(walk, pattern, state);
          if (state.stops) move_on(state, WalkEvent::kStopOrdered);
        }
      } else if (state.step_time_s >= walk.double_support_s) {
        move_on(state, WalkEvent::kLiftBegins);
        state.has_landed = false;
      }
      break;
    }
    case WalkStage::kLanding:
      run_clock(walk, pattern, state, last, period_s);
      if (state.time_in_stage_s >= walk.step_s()) move_on(state, WalkEvent::kCameToRest);
      break;
  }
  WalkView view = view_of(timed(given, pattern, state), state);
  view.begins_step = begins;
  return view;
}

FootReference foot_reference(const WalkParameters& given, const FourFactorParameters& pattern, FloorWalkState& state,
                             const Adjustment& adjust) noexcept {
  const WalkParameters walk = timed(given, pattern, state);
  const double step_time_s = std::clamp(state.step_time_s, 0.0, walk.step_s());
  const bool is_planned = !pattern.gaits.is_empty();
  PerSide<FootOffset> offset{};
  if (is_in_air(state, walk)) {
    const double share = state.held_share.value_or(swing_share(walk, state.step_time_s));
    geometry::Vector3& foot_m = state.foothold_m[index(state.moving)];
    const geometry::Vector3 landing_m = state.target_m + geometry::Vector3(adjust.landing_x_m, adjust.landing_y_m, 0.0);
    foot_m = state.lifted_m + swing_progress(share) * (landing_m - state.lifted_m);
    if (!is_planned) foot_m.z() += swing_height_m(walk, share);
  } else {
    state.lifted_m = state.foothold_m[index(state.moving)];
  }
  if (is_planned && state.steps > 0) offset = planned_offsets(walk, state);

  const double centre_y_m =
      state.centre_from_y_m + smooth(step_time_s / walk.step_s()) * (state.centre_to_y_m - state.centre_from_y_m);
  const double sway_m = sway_share(walk, pattern, state) * full_sway_y_m(walk, pattern, state, adjust.sway_m);
  const double pelvis_x_m = is_planned ? planned_pelvis_x_m(pattern, state) : state.pelvis_x.at(step_time_s).position_m;
  const geometry::Vector3 pelvis_m{pelvis_x_m + adjust.sway_centre_x_m + adjust.pelvis_x_m,
                                   centre_y_m + sway_m + adjust.sway_centre_y_m + adjust.pelvis_y_m,
                                   walk.body_height_m + adjust.pelvis_z_m};
  FootReference feet;
  for (const Side side : kSides) {
    const FootOffset& from_foothold = offset[index(side)];
    geometry::Vector3& position_m = feet[index(side)].position_body_m;
    position_m = state.foothold_m[index(side)] - pelvis_m;
    position_m.x() += from_foothold.x_m;
    position_m.z() += from_foothold.z_m - adjust.leg_length_m[index(side)];
    feet[index(side)].pitch_rad = from_foothold.pitch_rad;
  }
  return feet;
}

double planned_zmp_x_foot_m(const FourFactorParameters& pattern, const FloorWalkState& state,
                            double ankle_height_m) noexcept {
  if (pattern.gaits.is_empty() || state.steps == 0) return 0.0;
  const ScalarMotion com_x_m = state.stride.at(state.step_time_s).com_x_m;
  const double height_m = pattern.gaits.of_step(state.steps - 1).gait.com_height_m + ankle_height_m;
  return com_x_m.position - height_m / kGravity_m_s2 * com_x_m.acceleration;
}

double start_up_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.standing_s + shift_s(walk, pattern) + walk.double_support_s;
}

}  // namespace surefoot::gait
