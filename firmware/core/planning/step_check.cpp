#include "firmware/core/planning/step_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace surefoot::planning {
namespace {

constexpr double kGravity_m_s2 = 9.81;
constexpr double kCarriesShare = 0.01;  // of the weight

StepConstraint first_broken(const StepLimits& limits, const StepMargins& margins) noexcept {
  if (!(margins.least_normal_n > 0.0)) return StepConstraint::kLift;
  if (!(margins.greatest_friction <= limits.friction)) return StepConstraint::kFriction;
  if (!(margins.least_zmp_margin_m >= limits.zmp_margin_m)) return StepConstraint::kZmp;
  return StepConstraint::kNone;
}

}  // namespace

const char* name(StepConstraint constraint) noexcept {
  constexpr std::array kNames{"none", "determined", "knee", "lift", "friction", "zmp"};
  const auto place = static_cast<std::size_t>(constraint);
  return place < kNames.size() ? kNames[place] : "unknown";
}

StepMargins check_step(const SagittalBody& body, const StepLimits& limits, const PlannedStep& step, double hip_height_m,
                       int samples) noexcept {
  StepMargins margins;
  if (!step.is_determined() || samples < 1) {
    margins.broken = StepConstraint::kDetermined;
    return margins;
  }
  const GaitFactors& gait = step.plan().gait;
  const auto instant_s = [&](int i) { return (i + 0.5) * gait.step_s() / samples; };
  for (int i = 0; i < samples; ++i) {
    const std::array<double, 2> stretched = stretch(body, hip_height_m, step.at(instant_s(i)));
    margins.greatest_stretch = std::max({margins.greatest_stretch, stretched[0], stretched[1]});
  }
  if (!(margins.greatest_stretch <= limits.most_stretch)) {
    margins.broken = StepConstraint::kKnee;
    return margins;
  }

  margins.least_normal_n = std::numeric_limits<double>::infinity();
  margins.least_zmp_margin_m = std::numeric_limits<double>::infinity();
  int outside = 0;
  for (int i = 0; i < samples; ++i) {
    const StepInstant instant = step.at(instant_s(i));
    const std::optional<StepLoads> found = loads(body, hip_height_m, instant, instant_s(i) / gait.double_support_s);
    if (!found) {
      margins.least_normal_n = 0.0;
      break;
    }
    const double weight_n = body.mass_kg() * kGravity_m_s2;
    for (std::size_t foot = 0; foot < found->normal_n.size(); ++foot) {
      if (found->normal_n[foot] < kCarriesShare * weight_n) continue;
      margins.least_normal_n = std::min(margins.least_normal_n, found->normal_n[foot]);
      margins.greatest_friction =
          std::max(margins.greatest_friction, std::abs(found->tangential_n[foot]) / found->normal_n[foot]);
    }
    const SupportEdges edges = support_edges(step.plan().foot, instant);
    const double margin_m = std::min(found->zmp_x_m - edges.rear_m, edges.front_m - found->zmp_x_m);
    if (margin_m < 0.0) ++outside;
    if (margin_m < margins.least_zmp_margin_m) {
      margins.least_zmp_margin_m = margin_m;
      margins.least_zmp_margin_at_s = instant_s(i);
    }
  }
  margins.zmp_outside_share = static_cast<double>(outside) / samples;
  margins.broken = first_broken(limits, margins);
  return margins;
}

}  // namespace surefoot::planning
