#pragma once

#include "firmware/core/geometry/robot_geometry.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::sim_hw {

/// Mass distribution of the trunk with everything that hangs on it.
struct TrunkMass {
  double mass_kg = 0.0;
  geometry::Vector3 com_body_m = geometry::Vector3::Zero();     ///< s in the thesis
  geometry::Vector3 inertia_kg_m2 = geometry::Vector3::Zero();  ///< about the centre of mass, along the body's axes
};

/// A uniform box's principal inertia: (m/12) diag(W^2+H^2, L^2+H^2, L^2+W^2).
[[nodiscard]] geometry::Vector3 box_inertia(double mass_kg, const geometry::Vector3& size_m) noexcept;

/// The trunk as built: a uniform box whose centre of mass is where the configuration says.
[[nodiscard]] TrunkMass unloaded_trunk(const MassConfig&) noexcept;

/// The trunk after a box is hung on it; the box moves with the trunk from then on. May be repeated.
/// Mass and centre of mass: El-Kahlout 2003, eqs. (3.9), (3.10), for a box at any place.
/// Inertia: `kThesis` scales with the mass, eq. (3.8); `kExact` puts trunk and box about their
/// common centre of mass. Products of inertia are dropped (Bullet's base carries a diagonal only);
/// the diagonal alone still belongs to a possible body. A box at the side so turns the trunk no other way than its
/// centre of mass does.
[[nodiscard]] TrunkMass hang_payload(const TrunkMass&, const PayloadConfig&) noexcept;

}  // namespace surefoot::sim_hw
