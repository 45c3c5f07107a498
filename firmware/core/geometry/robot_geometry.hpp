#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "firmware/core/joints.hpp"

namespace surefoot::geometry {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

inline constexpr std::size_t kCornersPerFoot = 4;

/// Corners of a sole, each over one load cell; the order of the CAN frames and of all arrays.
enum class Corner : std::size_t { kFrontLeft, kFrontRight, kRearLeft, kRearRight };

/// Lengths that the firmware and the simulated robot share. Masses, friction and contact
/// constants are not here: the firmware must not know them.
///
/// Frames: *body* sits at the bottom-face centre of the trunk, x forward, y left, z up
/// (El-Kahlout 2003, section 3.2; both statements on the frame hold only there). *Foot* is the
/// ankle projected onto the sole, axes parallel to the body's in the zero pose.
///
/// Source: the thesis prints none of these numbers. Thigh and calf lengths follow later papers
/// of the same group; ankle height and hip position are assumptions that make the gait reachable
/// and put the standing ZMP where the thesis prints it (-0.035 m).
struct RobotGeometry {
  double hip_x_body_m = -0.0245;  ///< all three hip axes meet here, at body-frame height
  double hip_y_body_m = 0.11;     ///< left hip; the right one is mirrored
  double thigh_m = 0.27;          ///< hip to knee
  double calf_m = 0.22;           ///< knee to ankle
  double ankle_height_m = 0.10;   ///< ankle axes above the sole
  double sole_heel_m = 0.08;      ///< foot frame to rear corners
  double sole_toe_m = 0.17;       ///< foot frame to front corners
  double sole_width_m = 0.138;    ///< left to right corners

  /// Hip centre in the body frame.
  [[nodiscard]] Vector3 hip_body_m(Side side) const noexcept {
    return {hip_x_body_m, lateral_sign(side) * hip_y_body_m, 0.0};
  }

  /// Corner of the sole in the foot frame.
  [[nodiscard]] Vector3 corner_foot_m(Corner corner) const noexcept {
    const bool front = corner == Corner::kFrontLeft || corner == Corner::kFrontRight;
    const bool left = corner == Corner::kFrontLeft || corner == Corner::kRearLeft;
    return {front ? sole_toe_m : -sole_heel_m, (left ? 0.5 : -0.5) * sole_width_m, 0.0};
  }
};

}  // namespace surefoot::geometry
