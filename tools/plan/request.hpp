#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/core/planning/step_check.hpp"
#include "tools/plan/compensation.hpp"
#include "tools/scenario/field.hpp"

namespace surefoot::plan {

inline constexpr std::array kBodies{"paper", "khr2", "elkahlout"};
inline constexpr std::array kPatterns{"flat_feet", "rolled_together", "rolled_in_turn"};
inline constexpr std::array kComMethods{"shared_pressure", "hanging_pendulum", "mirrored_acceleration"};

/// A gait as somebody wants it: whose it is, what it is made of, what it may not exceed, how it may be changed.
struct PlanRequest {
  std::string robot = "paper";
  planning::StepPlan plan;  ///< its feet's angles and durations are not read: see below
  double toe_angle_deg = 12.0;
  double heel_angle_deg = 12.0;
  planning::SagittalBody body;
  planning::StepLimits limits;
  CompensationRules rules;

  /// The plan with its feet's angles in radians.
  [[nodiscard]] planning::StepPlan step_plan() const;
};

/// The request that a file starts from. "paper": Al-Shuka et al. 2014, Table 3 before compensation; lengths and masses
/// that it does not print are assumptions. "khr2", "elkahlout": lengths and masses of the scenarios' robots, and a
/// gait that they can walk.
/// @param robot  a name that does not exist counts as "paper"
[[nodiscard]] PlanRequest preset_request(const std::string& robot);

/// Every key of a request, in the order in which they are shown.
[[nodiscard]] std::vector<scenario::Field> fields(PlanRequest& request);

/// Reads a request. Precedence: `--set`, the file, the robot's preset. A p that is not given follows from H, T_s and
/// T_d where one of these is.
/// @throws scenario::ScenarioError with every problem found: unknown keys, wrong types, impossible values
[[nodiscard]] PlanRequest load_request(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same for text that is at hand; empty text is the preset.
[[nodiscard]] PlanRequest load_request_text(const std::string& name, std::string_view text,
                                            std::span<const std::string> overrides = {});

/// What `surefoot plan --keys` prints: every key with its kind, unit, range, default and meaning.
[[nodiscard]] std::string describe_request_keys();

}  // namespace surefoot::plan
