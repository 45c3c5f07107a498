#pragma once

#include <array>
#include <string>
#include <vector>

#include "firmware/core/geometry/robot_geometry.hpp"
#include "sim_hw/plant_config.hpp"

namespace surefoot::robot_model {

/// One rigid body and the joint that carries it. All frames are parallel in the zero pose; a link's frame sits on its
/// joint's axis, that of the root is the body frame.
struct Link {
  std::string name;
  std::string parent;         ///< empty: the root
  std::string joint;          ///< name of the revolute joint to the parent; empty: the root
  geometry::Vector3 joint_m;  ///< in the parent's frame
  geometry::Vector3 axis;     ///< of the joint
  double mass_kg = 0.0;
  geometry::Vector3 com_m;          ///< in the link's frame
  geometry::Vector3 inertia_kg_m2;  ///< about the centre of mass, along the link's axes
};

/// A frame of interest that carries no mass.
struct FixedFrame {
  std::string name;
  std::string parent;
  geometry::Vector3 place_m;
};

/// The simulated robot as other programs describe robots.
struct LinkTree {
  std::vector<Link> links;        ///< the root first, then right leg and left leg from hip to foot
  std::vector<FixedFrame> soles;  ///< right and left foot frame
};

/// Takes the tree from the simulator's own body, so that no number stands twice. The reflected rotor inertia that the
/// simulator adds to links is left out: other programs have a place of their own for it.
[[nodiscard]] LinkTree link_tree(const sim_hw::SimConfig&);

/// Angles of all joints in rad, right leg then left leg, in the order of `LegJoint`.
using JointAngles = PerSide<LegVector>;

/// Where the simulator's bodies are in one pose, in the body frame.
struct SimulatedPose {
  double mass_kg = 0.0;
  geometry::Vector3 com_body_m;
  std::vector<geometry::Vector3> link_com_body_m;  ///< in the order of `LinkTree::links`
  PerSide<geometry::Vector3> sole_body_m;          ///< origins of the foot frames
  PerSide<geometry::Matrix3> rotation_body_from_sole;
};

/// Asks the simulator's body, not the tree: what another program makes of the URDF can be held against it.
[[nodiscard]] SimulatedPose simulated_pose(const sim_hw::SimConfig&, const JointAngles&);

/// Size of the uniform box that has this mass and inertia.
[[nodiscard]] geometry::Vector3 equivalent_box_m(const Link&);

}  // namespace surefoot::robot_model
