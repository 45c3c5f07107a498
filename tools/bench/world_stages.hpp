#pragma once

#include "tools/scenario/scenario.hpp"

namespace surefoot::bench {

/// Bullet's articulated body alone, in free fall from the standing pose: the steps of one tick. What no contact, node,
/// codec or controller can go below.
[[nodiscard]] double bare_bullet_us(const scenario::Scenario& scenario, double seconds);

/// The same with floor contact, joint friction and motors that hold the standing pose.
[[nodiscard]] double world_us(const scenario::Scenario& scenario, double seconds);

}  // namespace surefoot::bench
