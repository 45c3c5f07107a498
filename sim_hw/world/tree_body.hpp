#pragma once

#include <BulletDynamics/Featherstone/btMultiBody.h>

namespace surefoot::sim_hw {

/// Bullet's articulated body with a floating base, in reduced coordinates, free of everything that a game wants of
/// it: damping, sleep, clamped speeds. Its links are added with `setupRevolute`, then `finish`.
///
/// Unlike Bullet's it can be copied between two steps: original and copy take the same steps from then on, to the
/// last bit. Colliders do not come along.
class TreeBody final : public btMultiBody {
 public:
  TreeBody(int links, double base_kg, const btVector3& base_inertia_kg_m2)
      : btMultiBody(links, base_kg, base_inertia_kg_m2, /*fixedBase=*/false, /*canSleep=*/false) {}
  TreeBody(const TreeBody&);
  TreeBody& operator=(const TreeBody&) = delete;
  ~TreeBody() override = default;

  /// After the last link.
  void finish();
};

}  // namespace surefoot::sim_hw
