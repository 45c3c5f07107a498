#include "tools/robot_model/link_tree.hpp"

#include <cmath>
#include <cstddef>

#include "sim_hw/world/robot_model.hpp"

namespace surefoot::robot_model {
namespace {

using geometry::Vector3;

constexpr const char* kRootName = "body";
constexpr std::array<const char*, kJointsPerLeg> kLinkNames{"hip_yaw_link", "hip_roll_link", "thigh",
                                                            "calf",         "ankle",         "foot"};

std::string of_side(Side side, const char* name) {
  return std::string(side == Side::kRight ? "right_" : "left_") + name;
}

sim_hw::RobotModel without_rotors(const sim_hw::SimConfig& config) {
  sim_hw::DriveConfig drive = config.drive;
  drive.rotor_inertia_kg_m2 = 0.0;
  return {config.geometry, config.mass, drive};
}

}  // namespace

LinkTree link_tree(const sim_hw::SimConfig& config) {
  sim_hw::RobotModel robot = without_rotors(config);
  const sim_hw::TrunkMass& trunk = robot.trunk();
  LinkTree tree;
  tree.links.push_back(
      {kRootName, "", "", Vector3::Zero(), Vector3::Zero(), trunk.mass_kg, trunk.com_body_m, trunk.inertia_kg_m2});
  for (const Side side : kSides) {
    Vector3 parent_com_m = trunk.com_body_m;
    std::string parent = kRootName;
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const btMultibodyLink& link =
          robot.multi_body().getLink(sim_hw::RobotModel::link(side, static_cast<LegJoint>(joint)));
      const Vector3 com_m = sim_hw::from_bullet(link.m_dVector);
      tree.links.push_back({of_side(side, kLinkNames[joint]), parent, of_side(side, kLegJointNames[joint]),
                            parent_com_m + sim_hw::from_bullet(link.m_eVector), sim_hw::from_bullet(link.getAxisTop(0)),
                            link.m_mass, com_m, sim_hw::from_bullet(link.m_inertiaLocal)});
      parent = tree.links.back().name;
      parent_com_m = com_m;
    }
    tree.soles.push_back(
        {of_side(side, "sole"), parent, parent_com_m + sim_hw::from_bullet(robot.foot_frame_from_com_m())});
  }
  return tree;
}

SimulatedPose simulated_pose(const sim_hw::SimConfig& config, const JointAngles& angle_rad) {
  sim_hw::RobotModel robot{config.geometry, config.mass, config.drive};
  robot.set_joints(angle_rad, {});
  const auto motions = robot.motions();
  SimulatedPose pose;
  pose.mass_kg = robot.total_mass_kg();
  const auto add = [&pose](const sim_hw::BodyMotion& body, double mass_kg) {
    pose.link_com_body_m.push_back(sim_hw::from_bullet(body.position_m));
    pose.com_body_m += mass_kg / pose.mass_kg * pose.link_com_body_m.back();
  };
  pose.com_body_m = Vector3::Zero();
  add(motions[sim_hw::RobotModel::kLinks], robot.multi_body().getBaseMass());
  for (int i = 0; i < sim_hw::RobotModel::kLinks; ++i) {
    add(motions[static_cast<std::size_t>(i)], robot.multi_body().getLinkMass(i));
  }
  for (const Side side : kSides) {
    const sim_hw::BodyMotion foot = robot.foot_motion(side);
    pose.sole_body_m[index(side)] = sim_hw::from_bullet(foot.position_m);
    pose.rotation_body_from_sole[index(side)] = sim_hw::from_bullet(foot.rotation_world_from_body);
  }
  return pose;
}

// A box's I_x = m/12 (W^2 + H^2) and so on, solved for the squares of its edges.
Vector3 equivalent_box_m(const Link& link) {
  const Vector3& inertia = link.inertia_kg_m2;
  const double half_trace = 0.5 * inertia.sum();
  Vector3 edge_m;
  for (int axis = 0; axis < 3; ++axis) {
    edge_m[axis] = std::sqrt(std::fmax(0.0, 12.0 / link.mass_kg * (half_trace - inertia[axis])));
  }
  return edge_m;
}

}  // namespace surefoot::robot_model
