#pragma once

#include <cstdint>

#include "firmware/core/planning/com_path.hpp"
#include "firmware/core/planning/foot_path.hpp"

namespace surefoot::planning {

/// Walking pattern (Al-Shuka et al. 2014, Fig. 1).
enum class WalkingPattern : std::uint8_t {
  kFlatFeet,        ///< 1: soles stay level
  kRolledTogether,  ///< 2: in double support the rear foot rolls over its toe while the front foot rolls over its heel
  kRolledInTurn,    ///< 3: first the front foot comes flat, then the heel of the rear one rises
};

/// How a step is walked: all of it.
struct StepPlan {
  WalkingPattern pattern = WalkingPattern::kRolledInTurn;
  ComMethod com_method = ComMethod::kSharedPressure;
  bool lands_hard = false;  ///< cases 2 and 4 of the feet instead of 1 and 3
  GaitFactors gait;
  FootStep foot;  ///< its step length and durations follow from `gait` and `pattern`
};

/// The sagittal plane at one instant. Origin: the floor in the middle between the ankles in double support; x forward.
struct StepInstant {
  bool is_double_support = true;
  gait::ScalarMotion com_x_m;
  FootPoint stance;  ///< ahead in double support, carries alone afterwards
  FootPoint swing;   ///< behind in double support, then in the air
};

/// A step that repeats: double support, then single support in which the foot that was behind goes ahead by 2 S.
class PlannedStep {
 public:
  explicit PlannedStep(const StepPlan&) noexcept;

  /// Whether factors and feet are possible; if not, `at` rests.
  [[nodiscard]] bool is_determined() const noexcept;
  [[nodiscard]] const StepPlan& plan() const noexcept { return plan_; }

  /// @param time_s  since the foot ahead landed; in [0, T_d + T_s]
  [[nodiscard]] StepInstant at(double time_s) const noexcept;

 private:
  StepPlan plan_;
  FootPath foot_;
};

}  // namespace surefoot::planning
