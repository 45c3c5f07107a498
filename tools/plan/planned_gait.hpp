#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/plan/request.hpp"

namespace surefoot::plan {

/// A gait and how it fares.
struct CheckedGait {
  planning::StepPlan plan;
  planning::StepMargins margins;
  double joining_double_support_s = 0.0;  ///< T_d that would join the supports
  double gap_m = 0.0;                     ///< step of the centre of mass where single support begins
  double least_clearance_m = 0.0;         ///< lowest edge of the foot in the air; negative: it would scrape

  /// "none", `planning::name` of what is broken, "joint" where the supports do not join, "clearance" where the foot in
  /// the air scrapes.
  [[nodiscard]] std::string broken() const;
  [[nodiscard]] bool is_feasible() const { return broken() == "none"; }
};

/// Checks a gait as it stands.
[[nodiscard]] CheckedGait check(const PlanRequest& request, const planning::StepPlan& plan);

/// A value that makes a gait feasible: by itself, or together with the others; everything else as asked.
struct Remedy {
  std::string key;  ///< "gait.com_height_m"
  double value = 0.0;
  bool is_at_most = false;  ///< the largest that does; otherwise the smallest
  bool is_exact = false;    ///< neither: this one
  bool needs_the_others = false;
};

/// What came of a request.
struct PlanResult {
  PlanRequest request;
  CheckedGait before;
  Compensation compensation;    ///< without turns where only a check was asked for
  CheckedGait after;            ///< as `before` where only a check was asked for
  std::vector<Remedy> nearest;  ///< where it is not feasible: values each of which alone makes it so
  std::optional<double> wanted_speed_m_s;

  [[nodiscard]] bool is_feasible() const { return after.is_feasible(); }
};

/// How a request is answered.
struct PlanOptions {
  bool compensates = true;
  std::optional<double> speed_m_s = std::nullopt;  ///< T_s, T_d, p and, for the knees, H are solved for it
  bool chooses_step = false;  ///< with `speed_m_s`: the step's length too, next to the one asked for
};

/// Whether a request has an answer. Where only a check is asked for, T_d and p are taken to join the supports with the
/// share of double support that the request's times have.
[[nodiscard]] bool is_possible(const PlanRequest& request, const PlanOptions& options);

[[nodiscard]] PlanResult plan_gait(const PlanRequest& request, const PlanOptions& options = {});

}  // namespace surefoot::plan
