#include "tools/plan/request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/plan/robot_body.hpp"
#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/field_reader.hpp"
#include "tools/scenario/preset.hpp"
#include "tools/scenario/toml_reader.hpp"

namespace surefoot::plan {
namespace {

using scenario::Field;

constexpr double kRadPerDeg = M_PI / 180.0;

void append_gait(std::vector<Field>& table, PlanRequest& request) {
  planning::GaitFactors& gait = request.plan.gait;
  table.insert(
      table.end(),
      {Field{"gait.com_height_m",
             &gait.com_height_m,
             {0.05, 3.0},
             "m",
             "H, height of the centre of mass above the ankles, constant"},
       Field{"gait.step_length_m", &gait.step_length_m, {0.01, 2.0}, "m", "S, way of the centre of mass in a step"},
       Field{"gait.single_support_share",
             &gait.single_support_share,
             {0.01, 0.99},
             "1",
             "p, share of single support in that way; where it is left out but H, T_s or T_d is given, what joins the "
             "supports"},
       Field{"gait.single_support_s", &gait.single_support_s, {0.05, 10.0}, "s", "T_s, length of single support"},
       Field{"gait.double_support_s", &gait.double_support_s, {0.01, 10.0}, "s", "T_d, length of double support"}});
}

void append_foot(std::vector<Field>& table, PlanRequest& request) {
  planning::FootStep& foot = request.plan.foot;
  table.insert(
      table.end(),
      {Field{"foot.toe_angle_deg", &request.toe_angle_deg, {0.0, 45.0}, "deg", "pitch at lift, heel up"},
       Field{"foot.heel_angle_deg", &request.heel_angle_deg, {0.0, 45.0}, "deg", "pitch at landing, toe up"},
       Field{"foot.toe_m", &foot.toe_m, {0.0, 0.5}, "m", "l_a, from the ankle to the toe's tip along the sole"},
       Field{"foot.heel_m", &foot.heel_m, {0.0, 0.5}, "m", "l_b, from the ankle to the heel"},
       Field{"foot.top_share", &foot.top_share, {0.05, 0.95}, "1", "share of the swing at which the top is passed"},
       Field{"foot.top_x_m", &foot.top_x_m, {-1.0, 1.0}, "m", "place of the top, from the middle of the foot's way"},
       Field{"foot.top_z_m", &foot.top_z_m, {0.0, 0.5}, "m", "height of the ankle over the sole's plane at the top"}});
}

void append_body(std::vector<Field>& table, PlanRequest& request) {
  planning::SagittalBody& body = request.body;
  table.insert(
      table.end(),
      {Field{"body.link_m", &body.link_m, {0.02, 2.0}, "m", "l, length of thigh and of shank"},
       Field{"body.ankle_height_m", &body.ankle_height_m, {0.0, 0.5}, "m", "height of the ankle above the sole"},
       Field{"body.com_above_hip_m", &body.com_above_hip_m, {-1.0, 1.0}, "m", "centre of mass of all above the hip"},
       Field{"body.trunk_com_m", &body.trunk_com_m, {-1.0, 1.0}, "m", "centre of mass of the trunk above the hip"},
       Field{"body.trunk_kg", &body.trunk_kg, {0.01, 500.0}, "kg", "mass of the trunk"},
       Field{"body.thigh_kg", &body.thigh_kg, {0.0, 100.0}, "kg", "mass of a thigh"},
       Field{"body.shank_kg", &body.shank_kg, {0.0, 100.0}, "kg", "mass of a shank"},
       Field{"body.foot_kg", &body.foot_kg, {0.0, 100.0}, "kg", "mass of a foot"},
       Field{"body.thigh_inertia_kg_m2",
             &body.thigh_inertia_kg_m2,
             {0.0, 100.0},
             "kg m2",
             "pitch inertia of a thigh about its centre"},
       Field{"body.shank_inertia_kg_m2",
             &body.shank_inertia_kg_m2,
             {0.0, 100.0},
             "kg m2",
             "pitch inertia of a shank about its centre"}});
}

void append_rules(std::vector<Field>& table, PlanRequest& request) {
  planning::StepLimits& limits = request.limits;
  CompensationRules& rules = request.rules;
  table.insert(
      table.end(),
      {Field{"limits.friction", &limits.friction, {0.0, 5.0}, "1", "mu, friction of sole and floor"},
       Field{"limits.zmp_margin_m", &limits.zmp_margin_m, {0.0, 0.5}, "m", "least way from ZMP to edge of support"},
       Field{"limits.most_stretch", &limits.most_stretch, {0.1, 0.9999}, "1", "largest stretch of a leg, D / (2 l)"},
       Field{"compensation.height_step_m",
             &rules.height_step_m,
             {1e-4, 0.1},
             "m",
             "step by which H is lowered where a knee is stretched"},
       Field{"compensation.slower",
             &rules.slower,
             {1.001, 2.0},
             "1",
             "factor of T_s where a foot slips or pulls, or the ZMP leaves"},
       Field{"compensation.longest_single_support_s",
             &rules.longest_single_support_s,
             {0.05, 10.0},
             "s",
             "longest T_s; then the step is shortened"},
       Field{"compensation.shorter", &rules.shorter, {0.5, 0.999}, "1", "factor of S once T_s is at its longest"},
       Field{"compensation.shortest_step_m", &rules.shortest_step_m, {0.01, 2.0}, "m", "shortest S that is a walk"},
       Field{"compensation.double_support_share",
             &rules.double_support_share,
             {0.02, 0.8},
             "1",
             "share of double support in the step's time; p follows"}});
}

void set_robot(const std::string& robot, PlanRequest& request) {
  const scenario::Scenario scenario = scenario::preset({.robot = robot, .plant = "nominal"});
  request.robot = robot;
  request.body = sagittal_body(scenario);
  request.plan.foot.toe_m = scenario.firmware.geometry.sole_toe_m;
  request.plan.foot.heel_m = scenario.firmware.geometry.sole_heel_m;
  request.plan.foot.top_z_m = 0.05;
  request.toe_angle_deg = request.heel_angle_deg = 8.0;
  request.limits.friction = scenario.sim.contact.friction;
  request.limits.zmp_margin_m = 0.03;
  request.limits.most_stretch = 0.97;  // the sway to the sides stretches the legs too
  planning::GaitFactors& gait = request.plan.gait;
  gait.com_height_m = 0.01 * std::floor(200.0 * 0.97 * request.body.link_m + 100.0 * request.body.com_above_hip_m);
  gait.step_length_m = robot == "khr2" ? 0.15 : 0.1;
  gait.single_support_s = 1.0;
  settle_times(request.rules.double_support_share, request.plan.com_method, gait);
}

/// The share that joins the supports, where there is one.
void join_supports(PlanRequest& request) {
  planning::GaitFactors& gait = request.plan.gait;
  gait.single_support_share =
      planning::continuous_single_support_share(gait.com_height_m, gait.single_support_s, gait.double_support_s)
          .value_or(gait.single_support_share);
}

}  // namespace

planning::StepPlan PlanRequest::step_plan() const {
  planning::StepPlan step = plan;
  step.foot.toe_angle_rad = kRadPerDeg * toe_angle_deg;
  step.foot.heel_angle_rad = kRadPerDeg * heel_angle_deg;
  return step;
}

PlanRequest preset_request(const std::string& robot) {
  PlanRequest request;
  if (robot == "khr2" || robot == "elkahlout") {
    set_robot(robot, request);
    return request;
  }
  request.plan.gait = {.com_height_m = 0.88,
                       .step_length_m = 0.5,
                       .single_support_share = 0.7575,
                       .single_support_s = 0.5,
                       .double_support_s = 0.125};
  // Not printed. Chosen, in the knowledge of it, so that the compensation ends near the paper's gait.
  request.body.link_m = 0.465;
  request.plan.foot.top_z_m = 0.1;
  request.limits.zmp_margin_m = 0.046;
  request.limits.most_stretch = 0.997;
  return request;
}

std::vector<Field> fields(PlanRequest& request) {
  std::vector<Field> table{
      scenario::name_field("robot", request.robot, kBodies, "robot whose lengths and masses are meant"),
      scenario::choice_field("pattern", request.plan.pattern, kPatterns, "walking pattern 1, 2 or 3"),
      scenario::choice_field("com_method", request.plan.com_method, kComMethods,
                             "way of the centre of mass in double support, 1, 2 or 3"),
      scenario::flag_field("lands_hard", request.plan.lands_hard, "foot cases 2 and 4 instead of 1 and 3")};
  append_gait(table, request);
  append_foot(table, request);
  append_body(table, request);
  append_rules(table, request);
  return table;
}

PlanRequest load_request(const std::filesystem::path& file, std::span<const std::string> overrides) {
  return load_request_text(file.string(), scenario::read_text(file), overrides);
}

PlanRequest load_request_text(const std::string& name, std::string_view text, std::span<const std::string> overrides) {
  scenario::Document document = scenario::parse(name, text);
  scenario::apply_overrides(document, overrides);
  PlanRequest defaults = preset_request(document.root.at_path("robot").value_or(std::string("paper")));
  PlanRequest request = defaults;
  const std::vector<Field> known = fields(request);
  scenario::FieldReader reader(document, "surefoot plan --keys shows every key");
  reader.know(known);
  reader.read_table(document.root, "", known, fields(defaults));
  reader.throw_problems();
  const auto was_given = [&](const char* key) { return reader.was_given(key); };
  constexpr std::array kDecideShare{"gait.com_height_m", "gait.single_support_s", "gait.double_support_s"};
  if (!was_given("gait.single_support_share") && std::ranges::any_of(kDecideShare, was_given)) join_supports(request);
  return request;
}

std::string describe_request_keys() {
  PlanRequest defaults = preset_request("paper");
  std::string text = "Keys of a request for a gait, and of --set KEY=VALUE. Defaults are the paper's case.\n\n";
  for (const Field& field : fields(defaults)) text += scenario::description(field.key, field);
  return text;
}

}  // namespace surefoot::plan
