#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/core/gait/motion_profile.hpp"
#include "firmware/core/planning/step_plan.hpp"

namespace surefoot::gait {

/// A gait, and how long it is walked.
struct PlannedGait {
  planning::StepPlan plan{};
  std::uint32_t steps = 0;  ///< until the next gait; of the last one, until the feet close; 0: to the end
};

inline constexpr std::size_t kMostPlannedGaits = 8;

/// Gaits that are walked one after the other. Source of a gait: Al-Shuka et al. 2014; the joins are ours.
struct PlannedGaits {
  std::array<PlannedGait, kMostPlannedGaits> gait{};
  std::size_t count = 0;  ///< 0: the walk is no planned one

  [[nodiscard]] bool is_empty() const noexcept { return count == 0; }
  /// The gait of a step, counted from 0.
  [[nodiscard]] const planning::StepPlan& of_step(std::uint32_t step) const noexcept;
  /// Steps of all gaits together, the one that closes the feet not counted; 0: without end.
  [[nodiscard]] std::uint32_t steps() const noexcept;
};

/// What a stride finds when it begins, seen from the ankle of the foot that has landed, and what it shall leave.
struct StrideBorders {
  double from_m = 0.0;         ///< the other foot is so far behind; 0: side by side
  double to_m = 0.0;           ///< it shall land so far ahead; 0: it closes
  ScalarMotion com_x_m;        ///< of the centre of mass
  bool comes_to_rest = false;  ///< the stride shall end with the centre of mass at rest over the foot that carries
};

/// The sagittal plane during a stride. Origin: the ankle of the foot that carries, while it is flat.
struct StrideInstant {
  ScalarMotion com_x_m;
  planning::FootPoint stance;  ///< first comes flat from its heel, if it landed on it
  planning::FootPoint swing;   ///< first on its toe, then in the air
};

/// One stride of a planned walk: double support, then single support. In the middle of a gait it is that gait's step;
/// where it begins, ends or changes the gait it is the step plus what joins both ends to the strides beside it without
/// a step in position, velocity or acceleration: fifth-degree polynomials that have faded out at the other end.
class PlannedStride {
 public:
  /// Both feet stand side by side, at rest.
  PlannedStride() noexcept;

  /// Cost: three small systems of linear equations.
  PlannedStride(const planning::StepPlan&, const StrideBorders&, const PlannedStride& before) noexcept;

  /// @param time_s  since it began; held in [0, duration]
  [[nodiscard]] StrideInstant at(double time_s) const noexcept;

  [[nodiscard]] double double_support_s() const noexcept { return step_.plan().gait.double_support_s; }
  [[nodiscard]] double single_support_s() const noexcept { return step_.plan().gait.single_support_s; }
  [[nodiscard]] double duration_s() const noexcept { return step_.plan().gait.step_s(); }
  [[nodiscard]] const StrideBorders& borders() const noexcept { return borders_; }

 private:
  planning::PlannedStep step_;  ///< of the gait: the centre of mass
  planning::PlannedStep feet_;  ///< the same with the way that the foot has
  planning::PlannedStep feet_before_;
  StrideBorders borders_;
  ScalarMotion join_at_begin_;  ///< what the gait's own step lacks there
  ScalarMotion join_at_end_;    ///< with its time turned round
  bool walks_ = false;
  bool walked_before_ = false;
};

}  // namespace surefoot::gait
