#pragma once

#include <string>
#include <vector>

#include "firmware/core/planning/step_check.hpp"

namespace surefoot::plan {

/// How a gait that is not feasible may be changed.
struct CompensationRules {
  double height_step_m = 0.005;  ///< the hip is lowered by so much where a knee is stretched
  double slower = 1.1;           ///< factor of T_s where a foot slips or pulls, or the ZMP leaves
  double longest_single_support_s = 2.0;
  double shorter = 0.95;              ///< factor of S once T_s has reached its longest
  double shortest_step_m = 0.1;       ///< shorter ones are no walk
  double double_support_share = 0.2;  ///< of the step's time: T_d = T_s / 4
  int most_iterations = 200;
};

/// One turn of the algorithm: what was tried, how it fared, and what is changed therefore.
struct CompensationTurn {
  planning::GaitFactors gait;
  planning::StepMargins margins;
  std::string change;  ///< in words; empty in the last turn
};

struct Compensation {
  std::vector<CompensationTurn> turns;  ///< the last one is the result

  [[nodiscard]] const CompensationTurn& last() const { return turns.back(); }
  [[nodiscard]] bool is_feasible() const { return last().margins.broken == planning::StepConstraint::kNone; }
};

/// The length of double support with which a method joins the supports.
[[nodiscard]] double joining_double_support_s(planning::ComMethod method, const planning::GaitFactors& gait);

/// Sets p and T_d: p so that methods 1 and 2 join their supports with this share of double support in the step's time,
/// T_d to what joins those of the method.
/// @return false where no p does; the gait is then as good as it was
bool settle_times(double double_support_share, planning::ComMethod method, planning::GaitFactors& gait);

/// Changes height, durations and step length until every constraint holds (Al-Shuka et al. 2014, Fig. 7, whose boxes
/// are lost: the rules are ours). The share of single support follows from T_d = T_s / 4 each time; method 3 then takes
/// its own T_d.
///
/// @return the turns, at least one; the last one names the constraint that could not be met
[[nodiscard]] Compensation compensate(const planning::SagittalBody&, const planning::StepLimits&,
                                      const planning::StepPlan&, const CompensationRules& = {});

}  // namespace surefoot::plan
