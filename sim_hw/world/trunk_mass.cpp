#include "sim_hw/world/trunk_mass.hpp"

namespace surefoot::sim_hw {
namespace {

/// Diagonal of the parallel-axis term of a point mass at `offset_m`.
geometry::Vector3 parallel_axes(double mass_kg, const geometry::Vector3& offset_m) noexcept {
  const geometry::Vector3 squared = offset_m.cwiseProduct(offset_m);
  return mass_kg * (geometry::Vector3::Constant(squared.sum()) - squared);
}

}  // namespace

geometry::Vector3 box_inertia(double mass_kg, const geometry::Vector3& size_m) noexcept {
  return parallel_axes(mass_kg / 12.0, size_m);
}

TrunkMass unloaded_trunk(const MassConfig& mass) noexcept {
  return {
      .mass_kg = mass.trunk_kg,
      .com_body_m = {mass.trunk_com_body_m[0], mass.trunk_com_body_m[1], mass.trunk_com_body_m[2]},
      .inertia_kg_m2 = box_inertia(mass.trunk_kg, {mass.trunk_size_m[0], mass.trunk_size_m[1], mass.trunk_size_m[2]})};
}

TrunkMass hang_payload(const TrunkMass& trunk, const PayloadConfig& payload) noexcept {
  const geometry::Vector3 position{payload.position_m[0], payload.position_m[1], payload.position_m[2]};
  TrunkMass loaded;
  loaded.mass_kg = trunk.mass_kg + payload.mass_kg;  // eq. (3.10)
  loaded.com_body_m =
      (trunk.mass_kg * trunk.com_body_m + payload.mass_kg * position) / loaded.mass_kg;  // eq. (3.9), with the old m_b
  switch (payload.inertia) {
    case PayloadInertia::kThesis:  // eq. (3.8), with the old m_b
      loaded.inertia_kg_m2 = trunk.inertia_kg_m2 * (loaded.mass_kg / trunk.mass_kg);
      break;
    case PayloadInertia::kExact:
      loaded.inertia_kg_m2 = trunk.inertia_kg_m2 + parallel_axes(trunk.mass_kg, trunk.com_body_m - loaded.com_body_m) +
                             box_inertia(payload.mass_kg, geometry::Vector3::Constant(payload.edge_m)) +
                             parallel_axes(payload.mass_kg, position - loaded.com_body_m);
      break;
  }
  return loaded;
}

}  // namespace surefoot::sim_hw
