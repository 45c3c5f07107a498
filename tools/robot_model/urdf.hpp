#pragma once

#include <string>

#include "firmware/core/safety/output_gate.hpp"
#include "tools/robot_model/link_tree.hpp"

namespace surefoot::robot_model {

/// The robot as URDF (http://wiki.ros.org/urdf/XML): masses, centres of mass, inertias and joints of the simulated one
/// to the last bit, boxes to look at. The root link is the body frame; fixed links `right_sole` and `left_sole` are the
/// foot frames. Reflected rotor inertia, friction of the joints and payloads are not in it.
///
/// @param name  of the robot
/// @param gate  the firmware's, whose ranges stand as the joints' limits: the simulated joints have no stops
[[nodiscard]] std::string to_urdf(const std::string& name, const LinkTree&, const sim_hw::SimConfig&,
                                  const safety::OutputGateConfig& gate);

}  // namespace surefoot::robot_model
