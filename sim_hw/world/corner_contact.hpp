#pragma once

#include <limits>

#include "sim_hw/plant_config.hpp"
#include "sim_hw/world/floor.hpp"
#include "sim_hw/world/terrain.hpp"

namespace surefoot::sim_hw {

/// A sole's load with the whole wrench on the foot.
struct SoleWrench {
  SoleLoad load;
  btVector3 force_world_n{0, 0, 0};
  btVector3 torque_world_nm{0, 0, 0};  ///< about the foot frame's origin
};

/// One sole on the floor: a spring and a damper under each corner, and Coulomb friction with a sticking point.
///
/// Normal: kn depth - cn speed away from the surface, never negative; nothing above it.
/// Tangential: a spring to the anchor, the place where the corner first touched, and a damper;
/// together at most mu times the normal force. The spring alone is also held to that limit by
/// dragging the anchor along, so a corner that slid comes to rest where it stops.
///
/// On a rough floor a corner keeps the surface that it met until it leaves it: one that slides over the edge of a tile
/// feels no step. One that comes in at the side of a tile, below its top, finds the surface where it is: a force that
/// jumped to a whole tile's depth would give the robot energy.
class CornerContact {
 public:
  CornerContact(const geometry::RobotGeometry&, const ContactConfig&, const TerrainConfig& = {});

  /// Force on the sole for this motion of the foot frame. Remembers anchors and surfaces.
  [[nodiscard]] SoleWrench step(const BodyMotion& foot) noexcept;

 private:
  /// z = offset + slope x, and the cosine and sine of the slope's angle.
  struct Plane {
    double offset_m = 0.0;
    double slope = 0.0;
    double cosine = 1.0;
    double sine = 0.0;
  };

  struct Anchor {
    double along_m = 0.0;  ///< ahead, along the surface
    double y_m = 0.0;
    bool touches = false;
    Plane surface{};
    double free_x_m = 0.0;  ///< where the corner was last seen above the surface
    double free_z_m = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] Plane surface_under(const Anchor&, const btVector3& corner_m) const noexcept;

  ContactConfig config_;
  Terrain terrain_;
  std::array<btVector3, geometry::kCornersPerFoot> corner_foot_m_;
  std::array<Anchor, geometry::kCornersPerFoot> anchor_{};
};

}  // namespace surefoot::sim_hw
