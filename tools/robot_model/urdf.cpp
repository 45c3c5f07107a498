#include "tools/robot_model/urdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace surefoot::robot_model {
namespace {

using geometry::Vector3;

constexpr double kBracketKg = 0.1;  // lighter links are brackets between two axes, without a shape worth showing
constexpr double kBracketRadiusM = 0.035;

// fmt's shortest form that reads back to the same bits.
std::string xyz(const Vector3& v) { return fmt::format("{} {} {}", v.x(), v.y(), v.z()); }

struct Shape {
  std::string geometry;
  Vector3 centre_m;
  std::string_view colour;
};

std::string box(const Vector3& size_m) { return fmt::format("<box size=\"{}\"/>", xyz(size_m)); }

Shape shape_of(const Link& link, const sim_hw::SimConfig& config) {
  const Vector3 size_m = equivalent_box_m(link);
  if (link.parent.empty()) return {box(size_m), {0.0, 0.0, 0.5 * size_m.z()}, "trunk"};
  if (link.mass_kg < kBracketKg) {
    return {fmt::format("<sphere radius=\"{}\"/>", kBracketRadiusM), Vector3::Zero(), "joint"};
  }
  const bool is_foot = link.name.ends_with("foot");
  if (!is_foot) return {box(size_m), link.com_m, "leg"};
  // The foot's centre of mass is not its middle.
  const geometry::RobotGeometry& robot = config.geometry;
  return {box({robot.sole_heel_m + robot.sole_toe_m, robot.sole_width_m, size_m.z()}),
          {0.5 * (robot.sole_toe_m - robot.sole_heel_m), 0.0, link.com_m.z()},
          "foot"};
}

std::string link_text(const Link& link, const sim_hw::SimConfig& config) {
  const Shape shape = shape_of(link, config);
  const std::string place = fmt::format("<origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <geometry>{}</geometry>",
                                        xyz(shape.centre_m), shape.geometry);
  std::string text = fmt::format(
      "  <link name=\"{}\">\n    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{}\"/>\n"
      "      <inertia ixx=\"{}\" ixy=\"0\" ixz=\"0\" iyy=\"{}\" iyz=\"0\" izz=\"{}\"/>\n    </inertial>\n"
      "    <visual>\n      {}\n      <material name=\"{}\"/>\n    </visual>\n",
      link.name, xyz(link.com_m), link.mass_kg, link.inertia_kg_m2.x(), link.inertia_kg_m2.y(), link.inertia_kg_m2.z(),
      place, shape.colour);
  // Nothing but the feet touches anything in the simulator.
  if (shape.colour == "foot") text += fmt::format("    <collision>\n      {}\n    </collision>\n", place);
  return text + "  </link>\n";
}

/// @param number  of the joint in a leg, hip yaw first
std::string joint_text(const Link& link, std::size_t number, const safety::OutputGateConfig& gate) {
  return fmt::format(
      "  <joint name=\"{}\" type=\"revolute\">\n    <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n    <parent link=\"{}\"/>\n"
      "    <child link=\"{}\"/>\n    <axis xyz=\"{}\"/>\n"
      "    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n  </joint>\n",
      link.joint, xyz(link.joint_m), link.parent, link.name, xyz(link.axis), gate.angle_min_rad[number],
      gate.angle_max_rad[number], gate.torque_limit_nm, gate.joint_rate_limit_rad_s);
}

std::string sole_text(const FixedFrame& sole) {
  return fmt::format(
      "  <link name=\"{0}\"/>\n  <joint name=\"{0}_frame\" type=\"fixed\">\n    <origin xyz=\"{1}\" rpy=\"0 0 0\"/>\n"
      "    <parent link=\"{2}\"/>\n    <child link=\"{0}\"/>\n  </joint>\n",
      sole.name, xyz(sole.place_m), sole.parent);
}

}  // namespace

std::string to_urdf(const std::string& name, const LinkTree& tree, const sim_hw::SimConfig& config,
                    const safety::OutputGateConfig& gate) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<!-- Written by `surefoot model`. Masses, inertias and joints are the simulator's.\n"
      "     Not in it: reflected rotor inertia (the largest is {} kg m2), friction of the joints, payloads. Limits are\n"
      "     the firmware's; the simulated joints have no stops. -->\n<robot name=\"{}\">\n",
      config.drive.rotor_inertia_kg_m2 * *std::ranges::max_element(config.drive.rotor_share), name);
  constexpr std::array<std::array<std::string_view, 2>, 4> kColours{{{"trunk", "0.16 0.33 0.47 1"},
                                                                     {"leg", "0.72 0.75 0.78 1"},
                                                                     {"joint", "0.25 0.27 0.30 1"},
                                                                     {"foot", "0.85 0.55 0.22 1"}}};
  for (const auto& [colour, rgba] : kColours) {
    text += fmt::format("  <material name=\"{}\"><color rgba=\"{}\"/></material>\n", colour, rgba);
  }
  std::size_t joints = 0;
  for (const Link& link : tree.links) {
    text += link_text(link, config);
    if (!link.joint.empty()) text += joint_text(link, joints++ % kJointsPerLeg, gate);
  }
  for (const FixedFrame& sole : tree.soles) text += sole_text(sole);
  return text + "</robot>\n";
}

}  // namespace surefoot::robot_model
