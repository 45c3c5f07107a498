#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "tools/robot_model/floor_view.hpp"
#include "tools/robot_model/link_tree.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::robot_model {

/// All that is needed to draw a scenario: the robot as URDF, names of its joints in the order of telemetry, corners of
/// the soles, payloads, pushes, floor. An instant that never comes is null.
[[nodiscard]] nlohmann::ordered_json model_json(const scenario::Scenario&, const Extent&);

/// Where the simulator's bodies are in each pose, body frame: mass, centre of mass, each link's, and the foot frames.
[[nodiscard]] nlohmann::ordered_json poses_json(const sim_hw::SimConfig&, std::span<const JointAngles>);

/// Reads poses: a JSON array of arrays of 12 angles in rad, right leg then left leg from hip yaw to ankle roll.
/// @throws std::invalid_argument naming the pose, the value and the remedy
[[nodiscard]] std::vector<JointAngles> read_poses(std::istream& input);

}  // namespace surefoot::robot_model
