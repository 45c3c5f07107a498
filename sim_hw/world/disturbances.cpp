#include "sim_hw/world/disturbances.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace surefoot::sim_hw {
namespace {

geometry::Vector3 to_vector(const std::array<double, 3>& v) noexcept { return {v[0], v[1], v[2]}; }

}  // namespace

Disturbances::Disturbances(const SimConfig& config)
    : payloads_(config.payloads), removals_(config.payloads.size()), half_step_s_(0.5 * config.physics_step_s) {
  std::ranges::stable_sort(payloads_, {}, &PayloadConfig::at_s);
  std::iota(removals_.begin(), removals_.end(), std::size_t{0});
  std::ranges::stable_sort(removals_, {}, [this](std::size_t place) { return payloads_[place].removed_at_s; });
  pushes_.reserve(config.pushes.size());
  for (const PushConfig& push : config.pushes) {
    const std::int64_t steps = std::max<std::int64_t>(1, std::llround(push.duration_s / config.physics_step_s));
    const double scale = push.duration_s / (static_cast<double>(steps) * config.physics_step_s);
    pushes_.push_back({push.at_s, scale * to_vector(push.force_n), to_vector(push.point_body_m), steps});
  }
}

void Disturbances::begin_due(double time_s, World& world) noexcept {
  const auto is_due = [&](double at_s) { return at_s < time_s + half_step_s_; };
  for (; next_payload_ < payloads_.size() && is_due(payloads_[next_payload_].at_s); ++next_payload_) {
    world.hang(payloads_[next_payload_]);
  }
  for (; next_removal_ < removals_.size() && is_due(payloads_[removals_[next_removal_]].removed_at_s);
       ++next_removal_) {
    world.take_off(removals_[next_removal_]);
  }
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    if (is_due(pushes_[i].at_s)) begun_ |= 1U << i;
  }
}

void Disturbances::push(World& world) noexcept {
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    if ((begun_ & ~ended_ & (1U << i)) == 0) continue;
    if (pushes_[i].steps_left-- > 0) {
      world.push(pushes_[i].force_world_n, pushes_[i].point_body_m);
    } else {
      ended_ |= 1U << i;
    }
  }
}

}  // namespace surefoot::sim_hw
