#pragma once

#include <algorithm>

#include "firmware/core/stabilizer/walk_view.hpp"

/// What keeps an ankle from tipping its own foot: a sole that stands on its edge follows the ankle and moves the body
/// no more, so that each further turn only lifts it further off the floor.
namespace surefoot::stabilizer {

/// How near the ZMP of a foot may come to its edges.
struct EdgeLimits {
  double margin_m = 0.01;  ///< from the edge: nothing may push the ZMP further from there on
  double band_m = 0.07;    ///< before that: what may still be done fades from all to nothing
};

/// Share of an action that is left toward each edge, 0 to 1.
struct EdgeRoom {
  double front = 1.0;
  double rear = 1.0;
  double left = 1.0;
  double right = 1.0;

  [[nodiscard]] double along() const noexcept { return std::min(front, rear); }
  [[nodiscard]] double across() const noexcept { return std::min(left, right); }
};

/// All of it for a foot that does not carry.
[[nodiscard]] inline EdgeRoom edge_room(const EdgeLimits& limits, const SoleSize& sole,
                                        const estimation::AnkleLoad& load) noexcept {
  if (!load.carries()) return {};
  const auto share = [&](double way_m) noexcept {
    return way_m > limits.margin_m ? std::min(1.0, (way_m - limits.margin_m) / std::max(limits.band_m, 1e-3)) : 0.0;
  };
  const double x_m = load.zmp_x_foot_m();
  const double y_m = load.zmp_y_foot_m();
  return {.front = share(sole.toe_m - x_m),
          .rear = share(sole.heel_m + x_m),
          .left = share(sole.half_width_m - y_m),
          .right = share(sole.half_width_m + y_m)};
}

}  // namespace surefoot::stabilizer
