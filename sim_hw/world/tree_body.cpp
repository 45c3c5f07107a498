#include "sim_hw/world/tree_body.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr double kMaxCoordinateVelocity = 1.0e4;  // Bullet clamps at 100 unless told

}  // namespace

TreeBody::TreeBody(const TreeBody& other) : TreeBody(other.getNumLinks(), other.getBaseMass(), other.getBaseInertia()) {
  for (int i = 0; i < other.getNumLinks(); ++i) {
    const btMultibodyLink& link = other.getLink(i);
    setupRevolute(i, link.m_mass, link.m_inertiaLocal, link.m_parent, link.m_zeroRotParentToThis, link.getAxisTop(0),
                  link.m_eVector, link.m_dVector);  // makes room for its coordinate
    getLink(i) = link;
    getLink(i).m_collider = nullptr;
  }
  finish();
  setBasePos(other.getBasePos());
  setWorldToBaseRot(other.getWorldToBaseRot());
  setBaseVel(other.getBaseVel());
  setBaseOmega(other.getBaseOmega());
  for (int i = 0; i < other.getNumLinks(); ++i) setJointVel(i, other.getJointVel(i));
}

void TreeBody::finish() {
  finalizeMultiDof();
  setLinearDamping(0.0);
  setAngularDamping(0.0);
  setUseGyroTerm(true);
  setHasSelfCollision(false);
  setMaxCoordinateVelocity(kMaxCoordinateVelocity);
  useRK4Integration(false);
  useGlobalVelocities(false);
}

}  // namespace surefoot::sim_hw
