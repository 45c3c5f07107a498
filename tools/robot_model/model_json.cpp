#include "tools/robot_model/model_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <istream>
#include <stdexcept>
#include <vector>

#include "tools/robot_model/urdf.hpp"

namespace surefoot::robot_model {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kJoints = 2 * kJointsPerLeg;

Json array_of(const geometry::Vector3& v) { return {v.x(), v.y(), v.z()}; }

Json matrix_of(const geometry::Matrix3& m) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) rows.push_back({m(row, 0), m(row, 1), m(row, 2)});
  return rows;
}

Json payloads_of(const sim_hw::SimConfig& config) {
  Json payloads = Json::array();
  for (const sim_hw::PayloadConfig& payload : config.payloads) {
    const bool stays = std::isinf(payload.removed_at_s);
    payloads.push_back({{"mass_kg", payload.mass_kg},
                        {"at_s", payload.at_s},
                        {"removed_at_s", stays ? Json(nullptr) : Json(payload.removed_at_s)},
                        {"position_body_m", payload.position_m},
                        {"edge_m", payload.edge_m}});
  }
  return payloads;
}

Json pushes_of(const sim_hw::SimConfig& config) {
  Json pushes = Json::array();
  for (const sim_hw::PushConfig& push : config.pushes) {
    pushes.push_back({{"at_s", push.at_s},
                      {"duration_s", push.duration_s},
                      {"force_world_n", push.force_n},
                      {"point_body_m", push.point_body_m}});
  }
  return pushes;
}

JointAngles pose_of(const Json& entry, std::size_t place) {
  if (!entry.is_array() || entry.size() != kJoints) {
    throw std::invalid_argument(
        fmt::format("poses[{}] is no array of {} angles\n  remedy: right leg then left leg, hip yaw to ankle roll, rad",
                    place, kJoints));
  }
  JointAngles angle_rad;
  for (std::size_t i = 0; i < kJoints; ++i) {
    if (!entry[i].is_number()) {
      throw std::invalid_argument(
          fmt::format("poses[{}][{}] is {}\n  remedy: give an angle in rad", place, i, entry[i].dump()));
    }
    angle_rad[i / kJointsPerLeg][i % kJointsPerLeg] = entry[i].get<double>();
  }
  return angle_rad;
}

}  // namespace

nlohmann::ordered_json model_json(const scenario::Scenario& scenario, const Extent& extent) {
  const LinkTree tree = link_tree(scenario.sim);
  Json joints = Json::array();
  Json masses = Json::object();
  for (const Link& link : tree.links) {
    if (!link.joint.empty()) joints.push_back(link.joint);
    masses[link.name] = link.mass_kg;
  }
  Json corners = Json::array();
  for (std::size_t corner = 0; corner < geometry::kCornersPerFoot; ++corner) {
    corners.push_back(array_of(scenario.sim.geometry.corner_foot_m(static_cast<geometry::Corner>(corner))));
  }
  return {{"robot", scenario.robot},
          {"urdf", to_urdf(scenario.robot, tree, scenario.sim, scenario.firmware.gate)},
          {"joint_names", joints},
          {"foot_links", {"right_sole", "left_sole"}},
          {"link_mass_kg", masses},
          {"sole_corners_foot_m", corners},
          {"payloads", payloads_of(scenario.sim)},
          {"pushes", pushes_of(scenario.sim)},
          {"floor", floor_json(scenario.sim, extent)}};
}

nlohmann::ordered_json poses_json(const sim_hw::SimConfig& config, std::span<const JointAngles> poses) {
  const LinkTree tree = link_tree(config);
  Json all = Json::array();
  for (const JointAngles& angle_rad : poses) {
    const SimulatedPose pose = simulated_pose(config, angle_rad);
    Json links = Json::object();
    for (std::size_t i = 0; i < tree.links.size(); ++i) links[tree.links[i].name] = array_of(pose.link_com_body_m[i]);
    Json soles = Json::object();
    for (const Side side : kSides) {
      soles[tree.soles[index(side)].name] = {
          {"place_body_m", array_of(pose.sole_body_m[index(side)])},
          {"rotation_body_from_sole", matrix_of(pose.rotation_body_from_sole[index(side)])}};
    }
    all.push_back({{"mass_kg", pose.mass_kg},
                   {"com_body_m", array_of(pose.com_body_m)},
                   {"link_com_body_m", links},
                   {"soles", soles}});
  }
  return all;
}

std::vector<JointAngles> read_poses(std::istream& input) {
  const Json document = Json::parse(input, nullptr, /*allow_exceptions=*/false);
  if (!document.is_array()) {
    throw std::invalid_argument(
        fmt::format("poses: no JSON array\n  remedy: give an array of arrays of {} angles", kJoints));
  }
  std::vector<JointAngles> poses;
  for (std::size_t place = 0; place < document.size(); ++place) poses.push_back(pose_of(document[place], place));
  return poses;
}

}  // namespace surefoot::robot_model
