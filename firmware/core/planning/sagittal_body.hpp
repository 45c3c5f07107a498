#pragma once

#include <array>
#include <optional>

#include "firmware/core/planning/step_plan.hpp"

namespace surefoot::planning {

/// The robot in the sagittal plane: trunk upright on the hip, two legs of equal shank and thigh. Masses at the links'
/// middles, the foot's at its ankle. The paper's ankle lies on the sole and its centre of mass in the hip; real robots
/// have neither, so that three heights are told apart: a gait's H is that of the centre of mass above the ankles, the
/// hip is lower by `com_above_hip_m`, and the floor, where the ZMP is, lies `ankle_height_m` below the ankles.
struct SagittalBody {
  double link_m = 0.455;         ///< l, of thigh and of shank
  double ankle_height_m = 0.0;   ///< above the sole; a foot that pitches takes its ankle along
  double com_above_hip_m = 0.0;  ///< of the whole body, standing
  double trunk_com_m = 0.0;      ///< centre of the trunk above the hip
  double trunk_kg = 40.0;
  double thigh_kg = 6.0;
  double shank_kg = 4.0;
  double foot_kg = 1.0;
  double thigh_inertia_kg_m2 = 0.10;  ///< about the link's own centre, pitch
  double shank_inertia_kg_m2 = 0.07;

  [[nodiscard]] double mass_kg() const noexcept { return trunk_kg + 2.0 * (thigh_kg + shank_kg + foot_kg); }
  /// Of the hip above the floor, for a gait's H.
  [[nodiscard]] double hip_height_m(double com_height_m) const noexcept {
    return com_height_m - com_above_hip_m + ankle_height_m;
  }
};

/// What the floor does to the feet, and where.
struct StepLoads {
  double zmp_x_m = 0.0;              ///< of the bodies in motion, eq. (44)
  std::array<double, 2> normal_n{};  ///< on the stance foot and on the other one, eqs. (41), (42)
  std::array<double, 2> tangential_n{};
};

/// Where the ankle is, of a foot whose path is that of the point of its sole below the ankle.
struct AnklePoint {
  gait::ScalarMotion x_m;
  gait::ScalarMotion z_m;
};

[[nodiscard]] AnklePoint ankle_of(const SagittalBody&, const FootPoint&) noexcept;

/// Share of its length, 2 l, to which a leg is stretched, D / (2 l): stance leg, swing leg; eqs. (36), (37). Below 1.
/// @param hip_height_m  above the floor, constant
[[nodiscard]] std::array<double, 2> stretch(const SagittalBody&, double hip_height_m, const StepInstant&) noexcept;

/// @param double_support_share  time since the landing over T_d, held in [0, 1]: how much of the load the stance foot
/// has
/// @return nothing where a leg is too short: its knee would be stretched
[[nodiscard]] std::optional<StepLoads> loads(const SagittalBody&, double hip_height_m, const StepInstant&,
                                             double double_support_share) noexcept;

/// Edges of the support polygon, x: from the rear edge of the rearmost foot that touches to the front edge of the
/// foremost; a foot on its toe or heel touches there alone, eq. (43).
struct SupportEdges {
  double rear_m = 0.0;
  double front_m = 0.0;
};

[[nodiscard]] SupportEdges support_edges(const FootStep&, const StepInstant&) noexcept;

}  // namespace surefoot::planning
