#include "tools/plan/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tools/plan/speeds.hpp"

namespace surefoot::plan {
namespace {

using scenario::Field;

/// What is asked, with the speed as one of its values.
struct Question {
  PlanRequest request;
  PlanOptions options;
};

/// A value that may be moved away from what was asked for.
struct Candidate {
  std::string key;
  double step;  ///< of the first try; later ones are wider
  bool goes_up;
  bool goes_down;
};

double* value_of(Question& question, const std::string& key) {
  if (key == "speed") return question.options.speed_m_s ? &*question.options.speed_m_s : nullptr;
  for (const Field& field : fields(question.request)) {
    if (field.key != key) continue;
    if (auto* const* number = std::get_if<double*>(&field.target)) return *number;
  }
  return nullptr;
}

scenario::Range range_of(Question& question, const std::string& key) {
  for (const Field& field : fields(question.request)) {
    if (field.key == key) return field.range;
  }
  return {.min = kSlowest_m_s, .max = kFastest_m_s};
}

bool is_feasible_with(Question question, const std::string& key, double value) {
  *value_of(question, key) = value;
  return is_possible(question.request, question.options);
}

/// Nearest value in one direction: tries that grow, then halvings, then a round number on the safe side.
std::optional<double> nearest(const Question& asked, const Candidate& candidate, double sign) {
  constexpr int kTries = 24;
  constexpr double kWider = 1.35;
  constexpr int kHalvings = 12;
  constexpr double kRound = 1e-4;
  Question question = asked;
  const double wanted = *value_of(question, candidate.key);
  const scenario::Range range = range_of(question, candidate.key);
  double broken = wanted;
  for (int i = 0; i < kTries; ++i) {
    double tried = std::clamp(wanted + sign * candidate.step * std::pow(kWider, i), range.min, range.max);
    if (tried == broken) return std::nullopt;
    if (!is_feasible_with(asked, candidate.key, tried)) {
      broken = tried;
      continue;
    }
    for (int halving = 0; halving < kHalvings; ++halving) {
      const double middle = 0.5 * (broken + tried);
      (is_feasible_with(asked, candidate.key, middle) ? tried : broken) = middle;
    }
    const double round =
        (sign > 0.0 ? std::ceil(tried / kRound) : std::floor(tried / kRound)) / std::round(1.0 / kRound);
    return is_feasible_with(asked, candidate.key, round) ? round : tried;
  }
  return std::nullopt;
}

/// What may be moved where this constraint is broken.
std::vector<Candidate> candidates_of(const PlanOptions& options, const std::string& broken) {
  if (broken == "clearance") return {{"foot.top_z_m", 0.002, true, false}};
  std::vector<Candidate> list;
  if (options.speed_m_s) {
    list = {{"speed", 0.01, true, true}};
    if (!options.chooses_step) list.push_back({"gait.step_length_m", 0.005, true, true});
  } else if (!options.compensates) {
    list = {{"gait.com_height_m", 0.005, true, true},
            {"gait.step_length_m", 0.005, true, true},
            {"gait.single_support_s", 0.02, true, true}};
  } else if (broken != "knee") {
    list = {{"compensation.longest_single_support_s", 0.05, true, false},
            {"compensation.shortest_step_m", 0.005, false, true}};
  }
  if (broken == "knee") list.push_back({"body.link_m", 0.005, true, false});
  if (broken == "friction") list.push_back({"limits.friction", 0.01, true, false});
  if (broken == "zmp") list.push_back({"limits.zmp_margin_m", 0.001, false, true});
  return list;
}

/// The limits and the legs, where one of them does not do: each as little as the others' relaxation allows.
std::vector<Remedy> together(const Question& asked) {
  Question question = asked;
  const std::vector<Candidate> order{{"body.link_m", 0.005, true, false},
                                     {"limits.friction", 0.01, true, false},
                                     {"limits.zmp_margin_m", 0.001, false, true}};
  const double friction = question.request.limits.friction;
  const double margin_m = question.request.limits.zmp_margin_m;
  question.request.limits.friction = range_of(question, "limits.friction").max;
  question.request.limits.zmp_margin_m = 0.0;
  std::vector<Remedy> remedies;
  for (const Candidate& candidate : order) {
    double& value = *value_of(question, candidate.key);
    if (candidate.key == "limits.friction") value = friction;
    if (candidate.key == "limits.zmp_margin_m") value = margin_m;
    if (is_possible(question.request, question.options)) continue;
    const std::optional<double> found = nearest(question, candidate, candidate.goes_up ? 1.0 : -1.0);
    if (!found) return {};
    value = *found;
    remedies.push_back({candidate.key, *found, !candidate.goes_up, false, true});
  }
  return remedies;
}

Remedy exactly(const char* key, double value) {
  return {.key = key, .value = value, .is_exact = true, .needs_the_others = true};
}

/// p and T_d of a gait whose supports only have to be joined.
std::vector<Remedy> joined(const PlanRequest& request) {
  planning::GaitFactors gait = request.plan.gait;
  settle_times(gait.double_support_s / gait.step_s(), request.plan.com_method, gait);
  return {exactly("gait.single_support_share", gait.single_support_share),
          exactly("gait.double_support_s", gait.double_support_s)};
}

/// What the compensation makes of it.
std::vector<Remedy> compensated(const PlanRequest& request) {
  const PlanOptions options;
  if (!is_possible(request, options)) return {};
  const planning::GaitFactors gait =
      compensate(request.body, request.limits, request.step_plan(), request.rules).last().gait;
  return {exactly("gait.com_height_m", gait.com_height_m), exactly("gait.step_length_m", gait.step_length_m),
          exactly("gait.single_support_share", gait.single_support_share),
          exactly("gait.single_support_s", gait.single_support_s),
          exactly("gait.double_support_s", gait.double_support_s)};
}

}  // namespace

std::vector<Remedy> nearest_feasible(const PlanRequest& request, const PlanOptions& options,
                                     const std::string& broken) {
  if (!options.compensates && is_possible(request, options)) return joined(request);
  const Question asked{request, options};
  std::vector<Remedy> remedies;
  for (const Candidate& candidate : candidates_of(options, broken)) {
    if (candidate.goes_down) {
      const std::optional<double> found = nearest(asked, candidate, -1.0);
      if (found) remedies.push_back({.key = candidate.key, .value = *found, .is_at_most = true});
    }
    if (candidate.goes_up) {
      const std::optional<double> found = nearest(asked, candidate, 1.0);
      if (found) remedies.push_back({.key = candidate.key, .value = *found});
    }
  }
  if (remedies.empty() && !options.compensates) remedies = compensated(request);
  return remedies.empty() ? together(asked) : remedies;
}

}  // namespace surefoot::plan
