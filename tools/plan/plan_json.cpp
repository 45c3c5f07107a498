#include "tools/plan/plan_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/plan/comparison.hpp"
#include "tools/plan/plan_text.hpp"
#include "tools/plan/samples.hpp"

namespace surefoot::plan {
namespace {

using Json = nlohmann::ordered_json;
using planning::StepConstraint;

constexpr double kDegPerRad = 180.0 / M_PI;

Json json_of(const planning::GaitFactors& gait) {
  return {{"com_height_m", gait.com_height_m},
          {"step_length_m", gait.step_length_m},
          {"single_support_share", gait.single_support_share},
          {"single_support_s", gait.single_support_s},
          {"double_support_s", gait.double_support_s},
          {"speed_m_s", gait.speed_m_s()}};
}

/// What depends on loads is null where there are none.
Json json_of(const planning::StepMargins& margins) {
  const bool is_known = margins.broken != StepConstraint::kKnee && margins.broken != StepConstraint::kDetermined;
  const auto known = [&](double value) { return is_known ? Json(value) : Json(nullptr); };
  return {{"greatest_stretch", margins.greatest_stretch},
          {"least_normal_n", known(margins.least_normal_n)},
          {"greatest_friction", known(margins.greatest_friction)},
          {"least_zmp_margin_m", known(margins.least_zmp_margin_m)},
          {"least_zmp_margin_at_s", known(margins.least_zmp_margin_at_s)},
          {"zmp_outside_share", known(margins.zmp_outside_share)}};
}

Json json_of(const CheckedGait& gait) {
  return {{"pattern", kPatterns.at(static_cast<std::size_t>(gait.plan.pattern))},
          {"com_method", kComMethods.at(static_cast<std::size_t>(gait.plan.com_method))},
          {"gait", json_of(gait.plan.gait)},
          {"margins", json_of(gait.margins)},
          {"joining_double_support_s", gait.joining_double_support_s},
          {"gap_m", gait.gap_m},
          {"least_clearance_m", gait.least_clearance_m},
          {"point_mass_friction", planning::least_friction(gait.plan.gait)},
          {"broken", gait.broken()}};
}

Json json_of(const PlanResult& result) {
  const PlanRequest& request = result.request;
  Json turns = Json::array();
  for (const CompensationTurn& turn : result.compensation.turns) {
    turns.push_back({{"gait", json_of(turn.gait)},
                     {"margins", json_of(turn.margins)},
                     {"broken", planning::name(turn.margins.broken)},
                     {"change", turn.change}});
  }
  Json nearest = Json::array();
  for (const Remedy& remedy : result.nearest) {
    nearest.push_back({{"key", remedy.key},
                       {"value", remedy.value},
                       {"bound", remedy.is_exact     ? "exactly"
                                 : remedy.is_at_most ? "at_most"
                                                     : "at_least"},
                       {"needs_the_others", remedy.needs_the_others}});
  }
  return {{"picture", "walking_plan"},
          {"robot", request.robot},
          {"pattern", kPatterns.at(static_cast<std::size_t>(request.plan.pattern))},
          {"com_method", kComMethods.at(static_cast<std::size_t>(request.plan.com_method))},
          {"lands_hard", request.plan.lands_hard},
          {"toe_angle_deg", request.toe_angle_deg},
          {"heel_angle_deg", request.heel_angle_deg},
          {"wanted_speed_m_s", result.wanted_speed_m_s ? Json(*result.wanted_speed_m_s) : Json(nullptr)},
          {"is_feasible", result.is_feasible()},
          {"broken", result.after.broken()},
          {"reason", complaint(request, result.after)},
          {"nearest_feasible", nearest},
          {"turns", turns},
          {"before", json_of(result.before)},
          {"after", json_of(result.after)}};
}

/// A foot's columns: the point of the sole below the ankle, and the ankle.
Json foot_json(const PlanRequest& request, const std::vector<PlanSample>& samples,
               planning::FootPoint planning::StepInstant::*foot) {
  Json columns;
  for (const PlanSample& sample : samples) {
    const planning::FootPoint& point = sample.instant.*foot;
    const planning::AnklePoint ankle = planning::ankle_of(request.body, point);
    columns["x_m"].push_back(point.x_m.position);
    columns["z_m"].push_back(point.z_m.position);
    columns["pitch_deg"].push_back(point.pitch_rad.position * kDegPerRad);
    columns["ankle_x_m"].push_back(ankle.x_m.position);
    columns["ankle_z_m"].push_back(ankle.z_m.position);
  }
  return columns;
}

Json samples_json(const PlanRequest& request, const CheckedGait& gait) {
  constexpr int kSamples = 301;
  const std::vector<PlanSample> samples = samples_of(request, gait.plan, kSamples);
  Json columns = json_of(gait);
  for (const PlanSample& sample : samples) {
    const gait::ScalarMotion& com = sample.instant.com_x_m;
    columns["time_s"].push_back(sample.time_s);
    columns["com_x_m"].push_back(com.position);
    columns["com_x_m_s"].push_back(com.velocity);
    columns["com_x_m_s2"].push_back(com.acceleration);
    columns["ideal_zmp_m"].push_back(sample.ideal_zmp_m);
    columns["real_zmp_m"].push_back(sample.loads ? Json(sample.loads->zmp_x_m) : Json(nullptr));
    columns["support_rear_m"].push_back(sample.edges.rear_m);
    columns["support_front_m"].push_back(sample.edges.front_m);
  }
  columns["stance"] = foot_json(request, samples, &planning::StepInstant::stance);
  columns["swing"] = foot_json(request, samples, &planning::StepInstant::swing);
  columns["hip_height_m"] = request.body.hip_height_m(gait.plan.gait.com_height_m);
  return columns;
}

}  // namespace

std::string to_json(const PlanResult& result) { return json_of(result).dump(2) + "\n"; }

std::string picture_json(const PlanResult& result) {
  const PlanRequest& request = result.request;
  Json json = json_of(result);
  json["link_m"] = request.body.link_m;
  json["toe_m"] = request.plan.foot.toe_m;
  json["heel_m"] = request.plan.foot.heel_m;
  json["before"] = samples_json(request, result.before);
  json["after"] = samples_json(request, result.after);
  for (const CheckedGait& gait : compare(request, result.after.plan.gait)) {
    if (gait.plan.com_method == request.plan.com_method) json["patterns"].push_back(samples_json(request, gait));
  }
  return json.dump() + "\n";
}

std::string to_json(std::span<const CheckedGait> gaits) {
  Json json = Json::array();
  for (const CheckedGait& gait : gaits) json.push_back(json_of(gait));
  return json.dump(2) + "\n";
}

std::string to_json(std::span<const PlanResult> gaits) {
  Json json = Json::array();
  for (const PlanResult& gait : gaits) json.push_back(json_of(gait));
  return json.dump(2) + "\n";
}

}  // namespace surefoot::plan
