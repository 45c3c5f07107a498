#include "sim_hw/world/bullet_terrain.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::sim_hw {
namespace {

constexpr double kPlainCellM = 1.0;   // of a floor without tiles: seams between its plates and patches are rare
constexpr double kBottomM = -0.1;     // of every block, below the plane
constexpr double kSheetM = 2.0e-4;    // of a friction patch, so that it and not the floor below is touched
constexpr double kMarginM = 1.0e-3;   // Bullet's own of 40 mm is more than half a tile
constexpr double kFarthestM = 1.0e6;  // a foot that has flown off needs no floor

}  // namespace

BulletTerrain::BulletTerrain(const TerrainConfig& config, double friction, btDynamicsWorld& world)
    : terrain_(config, friction), world_(world), cell_edge_m_(terrain_.has_tiles() ? config.tile_edge_m : kPlainCellM) {
  if (terrain_.has_tiles()) return;
  add_body(std::make_unique<btStaticPlaneShape>(btVector3{0, 0, 1}, 0.0), {0, 0, 0}, friction);
}

BulletTerrain::~BulletTerrain() {
  for (const Solid& solid : solids_) world_.removeRigidBody(solid.body.get());
}

void BulletTerrain::reach(double x_m, double y_m, double reach_m) {
  const bool is_near = std::abs(x_m) < kFarthestM && std::abs(y_m) < kFarthestM;  // false for NaN
  if (terrain_.is_plane() || !is_near) return;
  const GridCell first = grid_cell(x_m - reach_m, y_m - reach_m, cell_edge_m_);
  const GridCell last = grid_cell(x_m + reach_m, y_m + reach_m, cell_edge_m_);
  for (std::int64_t x = first.x; x <= last.x; ++x) {
    for (std::int64_t y = first.y; y <= last.y; ++y) {
      if (cells_.emplace(x, y).second) add_cell({x, y});
    }
  }
}

void BulletTerrain::add_cell(GridCell cell) {
  const std::array<double, 2> corner{cell_edge_m_ * static_cast<double>(cell.x),
                                     cell_edge_m_ * static_cast<double>(cell.y)};
  const Rectangle area{corner, {corner[0] + cell_edge_m_, corner[1] + cell_edge_m_}};
  const double base_m = terrain_.has_tiles() ? terrain_.tile_height_m(cell) : 0.0;
  if (terrain_.has_tiles()) add_block(area, base_m, base_m);
  if (terrain_.config().plates_per_m2 > 0.0) add_plates(area, base_m);
  for (const PatchConfig& patch : terrain_.config().patches) add_patch(patch, area, base_m);
}

void BulletTerrain::add_plates(const Rectangle& cell, double base_m) {
  const double edge_m = terrain_.config().plate_edge_m;
  const double half_m = 0.5 * edge_m;
  const GridCell first = grid_cell(cell.least_m[0] - half_m, cell.least_m[1] - half_m, edge_m);
  const GridCell last = grid_cell(cell.most_m[0] + half_m, cell.most_m[1] + half_m, edge_m);
  for (std::int64_t x = first.x; x <= last.x; ++x) {
    for (std::int64_t y = first.y; y <= last.y; ++y) {
      const auto centre = terrain_.plate_centre_m({x, y});
      if (!centre) continue;
      Rectangle area{{(*centre)[0] - half_m, (*centre)[1] - half_m}, {(*centre)[0] + half_m, (*centre)[1] + half_m}};
      const double top_m = base_m + terrain_.config().plate_height_m;
      if (clip(area, cell)) add_block(area, top_m, top_m);
    }
  }
}

void BulletTerrain::add_patch(const PatchConfig& patch, const Rectangle& cell, double base_m) {
  const std::array<double, 2> least{patch.centre_m[0] - 0.5 * patch.size_m[0],
                                    patch.centre_m[1] - 0.5 * patch.size_m[1]};
  Rectangle area{least, {least[0] + patch.size_m[0], least[1] + patch.size_m[1]}};
  if (!clip(area, cell)) return;
  switch (patch.kind) {
    case PatchKind::kPlate:
      add_block(area, base_m + patch.height_m, base_m + patch.height_m);
      break;
    case PatchKind::kRamp: {
      const double slope = patch.height_m / patch.size_m[0];
      add_block(area, base_m + slope * (area.least_m[0] - least[0]), base_m + slope * (area.most_m[0] - least[0]));
      break;
    }
    case PatchKind::kFriction:
      add_block(area, base_m + kSheetM, base_m + kSheetM);
      break;
  }
}

void BulletTerrain::add_block(const Rectangle& area, double near_top_m, double far_top_m) {
  const btVector3 middle{0.5 * (area.least_m[0] + area.most_m[0]), 0.5 * (area.least_m[1] + area.most_m[1]), 0.0};
  const double half_x_m = 0.5 * (area.most_m[0] - area.least_m[0]);
  const double half_y_m = 0.5 * (area.most_m[1] - area.least_m[1]);
  const double friction = terrain_.friction(middle.x(), middle.y());
  if (near_top_m == far_top_m) {
    auto box = std::make_unique<btBoxShape>(btVector3{half_x_m, half_y_m, 0.5 * (near_top_m - kBottomM)});
    box->setMargin(kMarginM);
    return add_body(std::move(box), {middle.x(), middle.y(), 0.5 * (near_top_m + kBottomM)}, friction);
  }
  auto wedge = std::make_unique<btConvexHullShape>();
  for (const double y_m : {-half_y_m, half_y_m}) {
    for (const double z_m : {kBottomM, near_top_m}) wedge->addPoint({-half_x_m, y_m, z_m}, false);
    for (const double z_m : {kBottomM, far_top_m}) wedge->addPoint({half_x_m, y_m, z_m}, false);
  }
  wedge->recalcLocalAabb();
  wedge->setMargin(0.0);  // it would be added around the points
  add_body(std::move(wedge), middle, friction);
}

void BulletTerrain::add_body(std::unique_ptr<btCollisionShape> shape, const btVector3& origin_m, double friction) {
  btRigidBody::btRigidBodyConstructionInfo info(0.0, nullptr, shape.get());
  info.m_startWorldTransform.setOrigin(origin_m);
  info.m_friction = friction;
  auto body = std::make_unique<btRigidBody>(info);
  world_.addRigidBody(body.get());
  solids_.push_back({std::move(shape), std::move(body)});
}

bool BulletTerrain::clip(Rectangle& area, const Rectangle& to) noexcept {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    area.least_m[axis] = std::max(area.least_m[axis], to.least_m[axis]);
    area.most_m[axis] = std::min(area.most_m[axis], to.most_m[axis]);
    if (area.most_m[axis] - area.least_m[axis] < 2.0 * kMarginM) return false;  // a sliver
  }
  return true;
}

}  // namespace surefoot::sim_hw
