#include "firmware/core/gait/floor_walk.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/gait/floor_sway.hpp"
#include "firmware/core/gait/planned_walk.hpp"

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
  const double sway_m = pelvis_sway_y_m(walk, pattern, state, adjust.sway_m);
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
