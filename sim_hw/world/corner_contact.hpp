#pragma once

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/floor.hpp"

namespace surefoot::sim_hw {

/// A sole's load with the whole wrench on the foot.
struct SoleWrench {
  SoleLoad load;
  btVector3 force_world_n{0, 0, 0};
  btVector3 torque_world_nm{0, 0, 0};  ///< about the foot frame's origin
};

/// One sole on a flat floor at z = 0: a spring and a damper under each corner, and Coulomb friction
/// with a sticking point.
///
/// Normal: kn depth - cn speed upwards, never negative; nothing above the floor.
/// Tangential: a spring to the anchor, the place where the corner first touched, and a damper;
/// together at most mu times the normal force. The spring alone is also held to that limit by
/// dragging the anchor along, so a corner that slid comes to rest where it stops.
class CornerContact {
 public:
  CornerContact(const geometry::RobotGeometry&, const ContactConfig&) noexcept;

  /// Force on the sole for this motion of the foot frame. Remembers the anchors.
  [[nodiscard]] SoleWrench step(const BodyMotion& foot) noexcept;

 private:
  struct Anchor {
    double x_m = 0.0;
    double y_m = 0.0;
    bool touches = false;
  };

  ContactConfig config_;
  std::array<btVector3, geometry::kCornersPerFoot> corner_foot_m_;
  std::array<Anchor, geometry::kCornersPerFoot> anchor_{};
};

}  // namespace surefoot::sim_hw
