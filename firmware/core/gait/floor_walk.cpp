#include "firmware/core/gait/floor_walk.hpp"

#include <algorithm>
#include <cmath>

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
    case WalkStage::kLanding:
      return 1.0 - smooth(state.time_in_stage_s / walk.step_s());
    default:
      return 1.0;
  }
}

/// Pelvis over the middle of the feet, without what fades it in and out.
double full_sway_y_m(const WalkParameters& walk, const FourFactorParameters& pattern, const FloorWalkState& state,
                     double added_m) noexcept {
  if (pattern.sway_profile == SwayProfile::kSine) {
    return sway_y_m(walk, walk.sway_m + added_m, state.moving, state.step_time_s);
  }
  const double share = 1.0 / pattern.com_share + added_m / state.com_y.amplitude_m();
  return -lateral_sign(state.moving) * share *
         state.com_y.at(state.step_time_s - 0.5 * (walk.double_support_s - pattern.transfer_s)).position;
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
  state.step_time_s = std::max(0.0, state.step_time_s - walk.step_s());
  state.clock_rate = 1.0;
  state.waited_s = 0.0;
  state.held_share.reset();
  plan_step(walk, pattern, state);
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

WalkView advance(const WalkParameters& walk, const FourFactorParameters& pattern, FloorWalkState& state,
                 const PerSide<estimation::AnkleLoad>& ankle, const Adjustment& last, bool stops,
                 double period_s) noexcept {
  if (!state.is_set_up) {
    state.is_set_up = true;
    for (const Side side : kSides) {
      state.foothold_m[index(side)] = {0.0, lateral_sign(side) * walk.foot_offset_y_m, 0.0};
    }
    state.pelvis_x = PendulumPath({pattern.pelvis_x_m, 0.0}, {pattern.pelvis_x_m, 0.0}, walk.step_s(), 1.0);
    state.com_y = LateralPendulum(walk.foot_offset_y_m, natural_rate_rad_s(pattern), walk.step_s() - pattern.transfer_s,
                                  pattern.transfer_s);
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
          state.moving = opposite(state.moving);
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
  WalkView view = view_of(walk, state);
  view.begins_step = begins;
  return view;
}

FootReference foot_reference(const WalkParameters& walk, const FourFactorParameters& pattern, FloorWalkState& state,
                             const Adjustment& adjust) noexcept {
  const double step_time_s = std::clamp(state.step_time_s, 0.0, walk.step_s());
  if (is_in_air(state, walk)) {
    const double share = state.held_share.value_or(swing_share(walk, state.step_time_s));
    geometry::Vector3& foot_m = state.foothold_m[index(state.moving)];
    const geometry::Vector3 landing_m = state.target_m + geometry::Vector3(adjust.landing_x_m, adjust.landing_y_m, 0.0);
    foot_m = state.lifted_m + swing_progress(share) * (landing_m - state.lifted_m);
    foot_m.z() += swing_height_m(walk, share);
  } else {
    state.lifted_m = state.foothold_m[index(state.moving)];
  }

  const double centre_y_m =
      state.centre_from_y_m + smooth(step_time_s / walk.step_s()) * (state.centre_to_y_m - state.centre_from_y_m);
  const double sway_m = sway_share(walk, pattern, state) * full_sway_y_m(walk, pattern, state, adjust.sway_m);
  const geometry::Vector3 pelvis_m{
      state.pelvis_x.at(step_time_s).position_m + adjust.sway_centre_x_m + adjust.pelvis_x_m,
      centre_y_m + sway_m + adjust.sway_centre_y_m + adjust.pelvis_y_m, walk.body_height_m + adjust.pelvis_z_m};
  FootReference feet;
  for (const Side side : kSides) {
    geometry::Vector3& position_m = feet[index(side)].position_body_m;
    position_m = state.foothold_m[index(side)] - pelvis_m;
    position_m.z() -= adjust.leg_length_m[index(side)];
  }
  return feet;
}

double start_up_s(const WalkParameters& walk, const FourFactorParameters& pattern) noexcept {
  return pattern.standing_s + shift_s(walk, pattern) + walk.double_support_s;
}

}  // namespace surefoot::gait
