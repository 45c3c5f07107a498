#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace surefoot {

/// The two legs; also the index into every `PerSide` array.
enum class Side : std::uint8_t { kRight = 0, kLeft = 1 };

inline constexpr std::array<Side, 2> kSides{Side::kRight, Side::kLeft};

/// One value for each leg or foot, indexed by `index(Side)`.
template <typename T>
using PerSide = std::array<T, 2>;

[[nodiscard]] constexpr std::size_t index(Side side) noexcept { return static_cast<std::size_t>(side); }

[[nodiscard]] constexpr Side opposite(Side side) noexcept { return side == Side::kRight ? Side::kLeft : Side::kRight; }

/// +1 on the left, -1 on the right: the sign of the body's y axis (y points left).
[[nodiscard]] constexpr double lateral_sign(Side side) noexcept { return side == Side::kLeft ? 1.0 : -1.0; }

/// Joints of one leg, from the torso to the sole. Axes in the zero pose, in the body frame:
/// yaw about z (up), roll about x (forward), pitch about y (left); right-handed, so that a
/// positive knee angle bends the shank backwards.
enum class LegJoint : std::uint8_t { kHipYaw, kHipRoll, kHipPitch, kKneePitch, kAnklePitch, kAnkleRoll };

inline constexpr std::size_t kJointsPerLeg = 6;

/// One value for each joint of a leg, indexed by `index(LegJoint)`.
using LegVector = std::array<double, kJointsPerLeg>;

[[nodiscard]] constexpr std::size_t index(LegJoint joint) noexcept { return static_cast<std::size_t>(joint); }

/// Names as they appear in logs, plots and messages.
inline constexpr std::array<const char*, kJointsPerLeg> kLegJointNames{"hip_yaw",    "hip_roll",    "hip_pitch",
                                                                       "knee_pitch", "ankle_pitch", "ankle_roll"};

}  // namespace surefoot
