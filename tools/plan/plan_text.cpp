#include "tools/plan/plan_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

namespace surefoot::plan {
namespace {

using planning::GaitFactors;
using planning::StepConstraint;
using planning::StepMargins;

bool has_loads(const CheckedGait& gait) {
  return gait.margins.broken != StepConstraint::kKnee && gait.margins.broken != StepConstraint::kDetermined;
}

std::string heading(const PlanResult& result) {
  const PlanRequest& request = result.request;
  const auto pattern = static_cast<std::size_t>(request.plan.pattern);
  const auto method = static_cast<std::size_t>(request.plan.com_method);
  return fmt::format("Gait for {}: pattern {}, {}; centre of mass by method {}, {}; feet {:g} and {:g} degrees\n",
                     request.robot, pattern + 1, kPatterns.at(pattern), method + 1, kComMethods.at(method),
                     request.toe_angle_deg, request.heel_angle_deg);
}

std::string turn_text(std::size_t number, const CompensationTurn& turn) {
  const GaitFactors& gait = turn.gait;
  const StepMargins& margins = turn.margins;
  std::string text = fmt::format("  {:>3}  {:.3f}  {:.3f}  {:.4f}  {:.4f}  {:.4f}  {:7.4f}", number, gait.com_height_m,
                                 gait.step_length_m, gait.single_support_share, gait.single_support_s,
                                 gait.double_support_s, margins.greatest_stretch);
  const bool is_known = margins.broken != StepConstraint::kKnee && margins.broken != StepConstraint::kDetermined;
  text += is_known ? fmt::format("  {:8.3f}  {:7.1f}", margins.greatest_friction, 1e3 * margins.least_zmp_margin_m)
                   : fmt::format("  {:>8}  {:>7}", "-", "-");
  return text + fmt::format("  {:<10}  {}\n", planning::name(margins.broken), turn.change);
}

/// One row of the table before and after.
struct Row {
  std::string_view what;
  double (*value)(const CheckedGait&);
  int digits;
  bool needs_loads;
};

constexpr Row kRows[] = {
    {"H, height of the centre of mass, m", [](const CheckedGait& g) { return g.plan.gait.com_height_m; }, 4, false},
    {"S, step, m", [](const CheckedGait& g) { return g.plan.gait.step_length_m; }, 4, false},
    {"p, share of single support", [](const CheckedGait& g) { return g.plan.gait.single_support_share; }, 4, false},
    {"T_s, single support, s", [](const CheckedGait& g) { return g.plan.gait.single_support_s; }, 4, false},
    {"T_d, double support, s", [](const CheckedGait& g) { return g.plan.gait.double_support_s; }, 4, false},
    {"T_d that joins the supports, s", [](const CheckedGait& g) { return g.joining_double_support_s; }, 5, false},
    {"speed, m/s", [](const CheckedGait& g) { return g.plan.gait.speed_m_s(); }, 4, false},
    {"greatest stretch of a leg", [](const CheckedGait& g) { return g.margins.greatest_stretch; }, 4, false},
    {"lowest edge of the foot in the air, mm", [](const CheckedGait& g) { return 1e3 * g.least_clearance_m; }, 1,
     false},
    {"friction, of the point mass", [](const CheckedGait& g) { return planning::least_friction(g.plan.gait); }, 4,
     false},
    {"friction, of the body", [](const CheckedGait& g) { return g.margins.greatest_friction; }, 4, true},
    {"ZMP to edge of support, least, mm", [](const CheckedGait& g) { return 1e3 * g.margins.least_zmp_margin_m; }, 1,
     true},
    {"  at, s after the landing", [](const CheckedGait& g) { return g.margins.least_zmp_margin_at_s; }, 3, true},
    {"  outside, share of the time", [](const CheckedGait& g) { return g.margins.zmp_outside_share; }, 3, true},
};

std::string cell(const Row& row, const CheckedGait& gait) {
  if (row.needs_loads && !has_loads(gait)) return fmt::format("  {:>9}", "-");
  return fmt::format("  {:>9.{}f}", row.value(gait) + 0.0, row.digits);
}

std::string table_text(const PlanResult& result) {
  const bool has_after = !result.compensation.turns.empty();
  std::string text = has_after ? fmt::format("  {:<40}  {:>9}  {:>9}\n", "", "before", "after") : "";
  for (const Row& row : kRows) {
    text += fmt::format("  {:<40}", row.what) + cell(row, result.before);
    text += (has_after ? cell(row, result.after) : "") + "\n";
  }
  text += fmt::format("  {:<40}  {:>9}", "broken", result.before.broken());
  return text + (has_after ? fmt::format("  {:>9}\n", result.after.broken()) : "\n");
}

}  // namespace

std::string complaint(const PlanRequest& request, const CheckedGait& gait) {
  const StepMargins& margins = gait.margins;
  const planning::StepLimits& limits = request.limits;
  const std::string broken = gait.broken();
  if (broken == "knee") {
    return fmt::format("a leg is too short: stretched to {:.4f} of its {:.3f} m, limits.most_stretch is {}",
                       margins.greatest_stretch, 2.0 * request.body.link_m, limits.most_stretch);
  }
  if (broken == "lift") return "a foot would have to pull on the floor";
  if (broken == "friction") {
    return fmt::format("a foot slips: it needs a friction of {:.4f}, limits.friction is {}", margins.greatest_friction,
                       limits.friction);
  }
  if (broken == "zmp") {
    return fmt::format(
        "the ZMP is {:.1f} mm {} the edge of its support {:.3f} s after the landing, limits.zmp_margin_m "
        "is {}",
        1e3 * std::abs(margins.least_zmp_margin_m), margins.least_zmp_margin_m < 0.0 ? "outside" : "inside",
        margins.least_zmp_margin_at_s, limits.zmp_margin_m);
  }
  if (broken == "joint") {
    return fmt::format(
        "the supports do not join: T_d is {:.5g} s, {:.5g} s would; the centre of mass jumps by {:.1f} mm",
        gait.plan.gait.double_support_s, gait.joining_double_support_s, 1e3 * gait.gap_m);
  }
  if (broken == "clearance") {
    return fmt::format("the foot in the air scrapes: its lowest edge is {:.1f} mm below the floor",
                       -1e3 * gait.least_clearance_m);
  }
  return broken == "none" ? "every constraint holds" : "these durations and lengths are no possible step";
}

std::string remedy_text(const PlanResult& result) {
  if (result.nearest.empty()) return "nothing near it is feasible: ask for shorter or slower steps, or other limits";
  std::string text = result.nearest.front().needs_the_others ? "nearest feasible, all of these together:"
                                                             : "nearest feasible, any one of these alone:";
  for (const Remedy& remedy : result.nearest) {
    text += fmt::format("{} {} {}{:.6g}", &remedy == &result.nearest.front() ? "" : ",", remedy.key,
                        remedy.is_exact     ? ""
                        : remedy.is_at_most ? "at most "
                                            : "at least ",
                        remedy.value);
  }
  return text;
}

std::string plan_text(const PlanResult& result) {
  std::string text = heading(result);
  if (result.wanted_speed_m_s) text += fmt::format("Wanted: {:g} m/s\n", *result.wanted_speed_m_s);
  if (!result.compensation.turns.empty()) {
    text += fmt::format("\n  {:>3}  {:<5}  {:<5}  {:<6}  {:<6}  {:<6}  {:>7}  {:>8}  {:>7}  {:<10}  {}\n", "", "H", "S",
                        "p", "T_s", "T_d", "stretch", "friction", "ZMP, mm", "broken", "what is changed");
    for (std::size_t i = 0; i < result.compensation.turns.size(); ++i) {
      text += turn_text(i + 1, result.compensation.turns[i]);
    }
  }
  text += "\n" + table_text(result);
  return text + fmt::format("\n{}: {}\n", result.is_feasible() ? "Feasible" : "Infeasible",
                            complaint(result.request, result.after));
}

std::string comparison_text(std::span<const CheckedGait> gaits) {
  std::string text = fmt::format("  {:<17} {:<22} {:>7} {:>7} {:>8} {:>8} {:>8} {:>8} {:>8}  {}\n", "pattern", "method",
                                 "T_d, s", "stretch", "friction", "ZMP, mm", "at, s", "outside", "clear mm", "broken");
  for (const CheckedGait& gait : gaits) {
    const StepMargins& margins = gait.margins;
    fmt::format_to(std::back_inserter(text), "  {:<17} {:<22} {:>7.4f} {:>7.4f} ",
                   fmt::format("{} {}", static_cast<int>(gait.plan.pattern) + 1,
                               kPatterns.at(static_cast<std::size_t>(gait.plan.pattern))),
                   kComMethods.at(static_cast<std::size_t>(gait.plan.com_method)), gait.plan.gait.double_support_s,
                   margins.greatest_stretch);
    text += has_loads(gait) ? fmt::format("{:>8.4f} {:>8.1f} {:>8.3f} {:>8.3f}", margins.greatest_friction,
                                          1e3 * margins.least_zmp_margin_m, margins.least_zmp_margin_at_s,
                                          margins.zmp_outside_share)
                            : fmt::format("{:>8} {:>8} {:>8} {:>8}", "-", "-", "-", "-");
    text += fmt::format(" {:>8.1f}  {}\n", 1e3 * gait.least_clearance_m + 0.0, gait.broken());
  }
  return text;
}

std::string library_text(std::span<const PlanResult> gaits) {
  std::string text = heading(gaits.front());
  text += fmt::format("  {:>6}  {:<6}  {:<6}  {:<6}  {:<6}  {:<6}  {:>7}  {:>8}  {:>7}  {}\n", "m/s", "H", "S", "p",
                      "T_s", "T_d", "stretch", "friction", "ZMP, mm", "broken");
  for (const PlanResult& result : gaits) {
    const GaitFactors& gait = result.after.plan.gait;
    const StepMargins& margins = result.after.margins;
    text += fmt::format("  {:>6.3f}  {:.4f}  {:.4f}  {:.4f}  {:.4f}  {:.4f}  {:7.4f}", gait.speed_m_s(),
                        gait.com_height_m, gait.step_length_m, gait.single_support_share, gait.single_support_s,
                        gait.double_support_s, margins.greatest_stretch);
    text += has_loads(result.after)
                ? fmt::format("  {:8.4f}  {:7.1f}", margins.greatest_friction, 1e3 * margins.least_zmp_margin_m)
                : fmt::format("  {:>8}  {:>7}", "-", "-");
    text += fmt::format("  {}\n", result.after.broken());
  }
  return text;
}

}  // namespace surefoot::plan
