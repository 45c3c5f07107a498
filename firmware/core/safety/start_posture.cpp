#include "firmware/core/safety/start_posture.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace surefoot::safety {
namespace {

constexpr double kGravity_m_s2 = 9.81;

bool has_answered(const SensorSnapshot& sensors) noexcept {
  const auto is_fresh = [](const auto& node) { return node.freshness.is_fresh(); };
  return std::ranges::all_of(sensors.leg, is_fresh) && std::ranges::all_of(sensors.foot, is_fresh) &&
         is_fresh(sensors.torso);
}

bool is_near(const StartPostureConfig& config, const SensorSnapshot& sensors, const JointReference& standing) noexcept {
  bool near = true;
  for (std::size_t leg = 0; leg < kSides.size(); ++leg) {
    for (std::size_t joint = 0; joint < kJointsPerLeg; ++joint) {
      const double error_rad = sensors.leg[leg].angle_rad[joint] - standing.angle_rad[leg][joint];
      near = near && std::abs(error_rad) <= config.joint_tolerance_rad;
    }
  }
  return near;
}

bool is_upright(const StartPostureConfig& config, const ImuSensors& torso) noexcept {
  const geometry::Vector3& force_m_s2 = torso.specific_force_body_m_s2;
  const double size_m_s2 = force_m_s2.norm();
  const bool is_at_rest = size_m_s2 >= 0.5 * kGravity_m_s2 && size_m_s2 <= 1.5 * kGravity_m_s2;
  return is_at_rest && force_m_s2.z() >= std::cos(config.max_tilt_rad) * size_m_s2;
}

bool is_loaded(const StartPostureConfig& config, const FootSensors& foot) noexcept {
  const auto& corners_n = foot.corner_force_n;
  return std::accumulate(corners_n.begin(), corners_n.end(), 0.0) >= config.min_foot_force_n;
}

}  // namespace

bool is_ready_to_stand(const StartPostureConfig& config, const SensorSnapshot& sensors,
                       const JointReference& standing) noexcept {
  return has_answered(sensors) && is_near(config, sensors, standing) && is_upright(config, sensors.torso) &&
         is_loaded(config, sensors.foot[0]) && is_loaded(config, sensors.foot[1]);
}

}  // namespace surefoot::safety
