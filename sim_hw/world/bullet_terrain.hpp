#pragma once

#include <btBulletDynamicsCommon.h>

#include <array>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "sim_hw/world/terrain.hpp"

namespace surefoot::sim_hw {

/// A rough floor in a Bullet world, as static boxes that are added where a foot comes and stay: a box for each tile,
/// further ones on it for what plates and patches cover of it, wedges for ramps. Without tiles the floor is a plane
/// and only plates and patches are bodies. The order in which they come depends on the feet's way alone.
///
/// A box has one friction, that of the floor at its middle. A friction patch is a sheet of 0.2 mm on the tiles; on
/// plates and ramps it has no body.
class BulletTerrain {
 public:
  /// @param world  outlives this object
  BulletTerrain(const TerrainConfig&, double friction, btDynamicsWorld& world);
  ~BulletTerrain();
  BulletTerrain(const BulletTerrain&) = delete;
  BulletTerrain& operator=(const BulletTerrain&) = delete;

  /// Adds what lies within `reach_m` of a place and is not there yet.
  void reach(double x_m, double y_m, double reach_m);

 private:
  struct Solid {
    std::unique_ptr<btCollisionShape> shape;
    std::unique_ptr<btRigidBody> body;
  };
  struct Rectangle {
    std::array<double, 2> least_m;
    std::array<double, 2> most_m;
  };

  void add_cell(GridCell);
  void add_plates(const Rectangle& cell, double base_m);
  void add_patch(const PatchConfig&, const Rectangle& cell, double base_m);
  /// A block down to below the plane, its top at a height at its near end and another at its far one.
  void add_block(const Rectangle& area, double near_top_m, double far_top_m);
  void add_body(std::unique_ptr<btCollisionShape>, const btVector3& origin_m, double friction);
  static bool clip(Rectangle& area, const Rectangle& to) noexcept;

  Terrain terrain_;
  btDynamicsWorld& world_;
  double cell_edge_m_;
  std::set<std::pair<std::int64_t, std::int64_t>> cells_;
  std::vector<Solid> solids_;
};

}  // namespace surefoot::sim_hw
