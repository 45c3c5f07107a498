#include "firmware/core/planning/sagittal_body.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/core/planning/motion_algebra.hpp"

namespace surefoot::planning {
namespace {

constexpr double kGravity_m_s2 = 9.81;
constexpr double kFlat_rad = 1e-9;  // of pitch, within which a sole touches with its whole length

struct Point {
  ScalarMotion x;
  ScalarMotion z;
};

Point middle(const Point& a, const Point& b) noexcept { return {0.5 * (a.x + b.x), 0.5 * (a.z + b.z)}; }

/// The knee in front of the line from hip to ankle.
Point knee_of(double link_m, const Point& hip, const Point& ankle) noexcept {
  const ScalarMotion dx = ankle.x - hip.x;
  const ScalarMotion dz = ankle.z - hip.z;
  const ScalarMotion square = dx * dx + dz * dz;
  const ScalarMotion height = square_root(resting(link_m * link_m) - 0.25 * square);
  const ScalarMotion per_length = inverse(square_root(square));
  const Point between = middle(hip, ankle);
  return {between.x - height * dz * per_length, between.z + height * dx * per_length};
}

/// Sums of eq. (44).
struct Balance {
  double mass_kg = 0.0;
  double moment_nm = 0.0;     ///< sum m ((z'' + g) x - x'' z) - sum I theta''
  double normal_n = 0.0;      ///< sum m (z'' + g)
  double tangential_n = 0.0;  ///< sum m x''

  void add(double kg, const Point& at) noexcept {
    mass_kg += kg;
    normal_n += kg * (at.z.acceleration + kGravity_m_s2);
    tangential_n += kg * at.x.acceleration;
    moment_nm += kg * ((at.z.acceleration + kGravity_m_s2) * at.x.position - at.x.acceleration * at.z.position);
  }

  /// @param pitch  of the link, positive forward
  void turn(double inertia_kg_m2, const ScalarMotion& pitch) noexcept {
    moment_nm -= inertia_kg_m2 * pitch.acceleration;
  }
};

}  // namespace

AnklePoint ankle_of(const SagittalBody& body, const FootPoint& foot) noexcept {
  return {foot.x_m + body.ankle_height_m * sine(foot.pitch_rad),
          foot.z_m + body.ankle_height_m * cosine(foot.pitch_rad)};
}

std::array<double, 2> stretch(const SagittalBody& body, double hip_height_m, const StepInstant& instant) noexcept {
  std::array<double, 2> share{};
  const std::array feet{&instant.stance, &instant.swing};
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const AnklePoint ankle = ankle_of(body, *feet[i]);
    share[i] = std::hypot(instant.com_x_m.position - ankle.x_m.position, hip_height_m - ankle.z_m.position) /
               (2.0 * body.link_m);
  }
  return share;
}

std::optional<StepLoads> loads(const SagittalBody& body, double hip_height_m, const StepInstant& instant,
                               double double_support_share) noexcept {
  const std::array<double, 2> stretched = stretch(body, hip_height_m, instant);
  if (!(std::max(stretched[0], stretched[1]) < 1.0)) return std::nullopt;
  const Point hip{instant.com_x_m, resting(hip_height_m)};
  Balance balance;
  balance.add(body.trunk_kg, {hip.x, resting(hip_height_m + body.trunk_com_m)});
  for (const FootPoint* foot : {&instant.stance, &instant.swing}) {
    const AnklePoint at = ankle_of(body, *foot);
    const Point ankle{at.x_m, at.z_m};
    const Point knee = knee_of(body.link_m, hip, ankle);
    balance.add(body.thigh_kg, middle(hip, knee));
    balance.add(body.shank_kg, middle(knee, ankle));
    balance.add(body.foot_kg, ankle);
    balance.turn(body.thigh_inertia_kg_m2, pitch_of(hip.x - knee.x, hip.z - knee.z));
    balance.turn(body.shank_inertia_kg_m2, pitch_of(knee.x - ankle.x, knee.z - ankle.z));
  }
  if (!(balance.normal_n > 0.0)) return std::nullopt;
  StepLoads found{.zmp_x_m = balance.moment_nm / balance.normal_n};
  const double share = instant.is_double_support ? std::clamp(double_support_share, 0.0, 1.0) : 1.0;
  found.normal_n = {share * balance.normal_n, (1.0 - share) * balance.normal_n};
  found.tangential_n = {share * balance.tangential_n, (1.0 - share) * balance.tangential_n};
  return found;
}

SupportEdges support_edges(const FootStep& foot, const StepInstant& instant) noexcept {
  const auto rear_of = [&](const FootPoint& at) {
    const double pitch = at.pitch_rad.position;
    return at.x_m.position + (pitch > kFlat_rad ? foot.toe_m * std::cos(pitch) : -foot.heel_m * std::cos(pitch));
  };
  const auto front_of = [&](const FootPoint& at) {
    const double pitch = at.pitch_rad.position;
    return at.x_m.position + (pitch < -kFlat_rad ? -foot.heel_m * std::cos(pitch) : foot.toe_m * std::cos(pitch));
  };
  SupportEdges edges{rear_of(instant.stance), front_of(instant.stance)};
  if (!instant.is_double_support) return edges;
  edges.rear_m = std::min(edges.rear_m, rear_of(instant.swing));
  edges.front_m = std::max(edges.front_m, front_of(instant.swing));
  return edges;
}

}  // namespace surefoot::planning
