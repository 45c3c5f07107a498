#include <numbers>

#include "tools/scenario/field_builders.hpp"
#include "tools/scenario/field_table.hpp"
#include "tools/scenario/planned_gait.hpp"

namespace surefoot::scenario {
namespace {

// In the order of the enumerators.
constexpr std::array kPatterns{"flat_feet", "rolled_together", "rolled_in_turn"};
constexpr std::array kComMethods{"shared_pressure", "hanging_pendulum", "mirrored_acceleration"};

}  // namespace

std::vector<Field> fields(PlannedGaitConfig& config) {
  planning::GaitFactors& gait = config.gait;
  return {
      Field{"steps", &config.steps, {0.0, 1e6}, "steps", "steps until the next gait or the end, 0 for no end"},
      choice_field("pattern", config.pattern, kPatterns, "way the feet roll in double support"),
      choice_field("com_method", config.com_method, kComMethods, "way of the centre of mass through double support"),
      flag_field("lands_hard", config.lands_hard, "a foot that lands with speed"),
      Field{"com_height_m", &gait.com_height_m, {0.0, 3.0, true}, "m", "height of the centre of mass above the ankles"},
      Field{"step_length_m", &gait.step_length_m, {0.0, 1.0, true}, "m", "way of the centre of mass in a step"},
      Field{"single_support_share",
            &gait.single_support_share,
            {0.01, 0.99},
            "1",
            "share of that way that is covered in single support"},
      Field{"single_support_s", &gait.single_support_s, {0.05, 60.0}, "s", "time on one foot"},
      Field{"double_support_s", &gait.double_support_s, {0.01, 60.0}, "s", "time on both feet"},
      Field{"toe_angle_deg", &config.toe_angle_deg, {0.0, 60.0}, "deg", "pitch of a foot when it is lifted, heel up"},
      Field{"heel_angle_deg", &config.heel_angle_deg, {0.0, 60.0}, "deg", "pitch of a foot when it lands, toe up"},
      Field{"top_share", &config.top_share, {0.05, 0.95}, "1", "share of the swing after which its top is passed"},
      Field{"top_x_m", &config.top_x_m, {-1.0, 1.0}, "m", "place of the top, from the middle of the foot's way"},
      Field{"top_z_m", &config.top_z_m, {0.005, 0.5}, "m", "height of the top"}};
}

gait::PlannedGait planned_gait(const PlannedGaitConfig& config, const geometry::RobotGeometry& robot) {
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  gait::PlannedGait gait;
  gait.steps = config.steps;
  gait.plan.pattern = config.pattern;
  gait.plan.com_method = config.com_method;
  gait.plan.lands_hard = config.lands_hard;
  gait.plan.gait = config.gait;
  planning::FootStep& foot = gait.plan.foot;
  foot.top_share = config.top_share;
  foot.top_x_m = config.top_x_m;
  foot.top_z_m = config.top_z_m;
  foot.toe_angle_rad = config.toe_angle_deg * kRadPerDeg;
  foot.heel_angle_rad = config.heel_angle_deg * kRadPerDeg;
  foot.toe_m = robot.sole_toe_m;
  foot.heel_m = robot.sole_heel_m;
  return gait;
}

}  // namespace surefoot::scenario
