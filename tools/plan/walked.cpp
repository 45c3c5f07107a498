#include "tools/plan/walked.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "firmware/core/kinematics/leg_kinematics.hpp"
#include "firmware/host/firmware_node.hpp"
#include "firmware/host/memory_bus.hpp"
#include "sim_hw/inclination.hpp"
#include "sim_hw/simulated_robot.hpp"
#include "tools/plan/request.hpp"
#include "tools/plan/robot_body.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/standing_pose.hpp"

namespace surefoot::plan {
namespace {

using geometry::Vector3;

constexpr double kDegPerRad = 180.0 / std::numbers::pi;
constexpr double kCarries_n = 1.0;
constexpr std::size_t kSettling = 3;  // steps until a walk has found its rhythm
constexpr std::size_t kPictured = 4;
constexpr double kSample_s = 0.01;

/// A step as it goes on: where its foot stands is known once the other one is lifted.
struct OpenStep {
  std::vector<ZmpSample> samples;  // measured ones from the world's origin
  std::vector<std::array<double, 2>> foot_m;
  std::optional<std::size_t> carrier;
  std::size_t lift = 0;

  /// From the foothold, or nothing where no foot was lifted.
  [[nodiscard]] std::vector<ZmpSample> closed() const {
    if (!carrier) return {};
    const double foothold_m = foot_m[lift][*carrier];
    std::vector<ZmpSample> moved = samples;
    for (ZmpSample& sample : moved) {
      for (double* place : {&sample.measured_m, &sample.rear_m, &sample.front_m}) *place -= foothold_m;
    }
    return moved;
  }
};

std::optional<double> planned_margin_m(const scenario::Scenario& scenario) {
  const planning::SagittalBody body = sagittal_body(scenario);
  const gait::PlannedGaits& gaits = scenario.firmware.floor.pattern.gaits;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < gaits.count; ++i) {
    const planning::StepPlan& plan = gaits.gait.at(i).plan;
    const planning::StepMargins margins =
        planning::check_step(body, {}, planning::PlannedStep(plan), scenario.firmware.walk.body_height_m);
    if (margins.broken == planning::StepConstraint::kKnee || margins.broken == planning::StepConstraint::kDetermined) {
      return std::nullopt;
    }
    least_m = std::min(least_m, margins.least_zmp_margin_m);
  }
  return least_m;
}

std::string pattern_of(const gait::PlannedGaits& gaits) {
  const planning::WalkingPattern first = gaits.gait[0].plan.pattern;
  const bool differs = std::any_of(gaits.gait.begin(), gaits.gait.begin() + static_cast<std::ptrdiff_t>(gaits.count),
                                   [&](const gait::PlannedGait& gait) { return gait.plan.pattern != first; });
  return differs ? "several" : kPatterns.at(static_cast<std::size_t>(first));
}

}  // namespace

std::optional<TruePressure> true_pressure(const geometry::RobotGeometry& robot, const sim_hw::GroundTruth& truth) {
  const geometry::Matrix3 rotation =
      (Eigen::AngleAxisd(truth.yaw_rad, Vector3::UnitZ()) * Eigen::AngleAxisd(truth.pitch_rad, Vector3::UnitY()) *
       Eigen::AngleAxisd(truth.roll_rad, Vector3::UnitX()))
          .toRotationMatrix();
  const Vector3 ahead{std::cos(truth.yaw_rad), std::sin(truth.yaw_rad), 0.0};
  const Vector3 body{truth.body_position_world_m[0], truth.body_position_world_m[1], truth.body_position_world_m[2]};
  TruePressure pressure{.rear_m = std::numeric_limits<double>::infinity(),
                        .front_m = -std::numeric_limits<double>::infinity()};
  double force_n = 0.0;
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    const kinematics::FootPose foot = kinematics::forward(robot, side, truth.angle_rad[i]);
    pressure.foot_m.at(i) = ahead.dot(body + rotation * foot.position_body_m);
    for (std::size_t corner = 0; corner < geometry::kCornersPerFoot; ++corner) {
      const double corner_n = truth.corner_force_n[i].at(corner);
      if (corner_n < kCarries_n) continue;
      const Vector3 corner_foot_m = robot.corner_foot_m(static_cast<geometry::Corner>(corner));
      const double x_m =
          ahead.dot(body + rotation * (foot.position_body_m + foot.rotation_body_from_foot * corner_foot_m));
      pressure.zmp_m += corner_n * x_m;
      force_n += corner_n;
      pressure.rear_m = std::min(pressure.rear_m, x_m);
      pressure.front_m = std::max(pressure.front_m, x_m);
    }
  }
  if (force_n == 0.0) return std::nullopt;
  pressure.zmp_m /= force_n;
  return pressure;
}

void sum_up(std::span<const std::vector<ZmpSample>> steps, Walked& walked) {
  std::vector<double> margins_m;
  double squares_m2 = 0.0;
  double most_m = 0.0;
  for (std::size_t step = kSettling; step < steps.size(); ++step) {
    for (const ZmpSample& sample : steps[step]) {
      margins_m.push_back(std::min(sample.measured_m - sample.rear_m, sample.front_m - sample.measured_m));
      const double difference_m = sample.measured_m - sample.planned_m;
      squares_m2 += difference_m * difference_m;
      most_m = std::max(most_m, std::abs(difference_m));
    }
  }
  if (margins_m.empty()) return;
  const double count = static_cast<double>(margins_m.size());
  std::sort(margins_m.begin(), margins_m.end());
  walked.least_margin_m = margins_m.front();
  walked.fifth_margin_m = margins_m[static_cast<std::size_t>(0.05 * (count - 1.0))];
  walked.rms_difference_m = std::sqrt(squares_m2 / count);
  walked.most_difference_m = most_m;
}

Walked walk(const std::string& file, const scenario::Scenario& given) {
  const scenario::Scenario scenario = run::scheduled(given);
  const run::Schedule schedule = run::schedule_of(scenario);
  host::MemoryBus bus;
  host::FirmwareNode firmware(scenario.firmware);
  sim_hw::SimulatedRobot robot(scenario.sim, run::standing_pose(scenario.firmware));
  const gait::PlannedGaits& gaits = scenario.firmware.floor.pattern.gaits;
  Walked walked{.file = file, .robot = scenario.robot, .pattern = pattern_of(gaits)};
  walked.planned_margin_m = planned_margin_m(scenario);
  const auto last = static_cast<int>(gaits.steps());
  std::vector<std::vector<ZmpSample>> steps;
  OpenStep open;
  for (std::int64_t tick = 0; tick < schedule.ticks && !walked.has_fallen && !walked.has_fault; ++tick) {
    firmware.begin_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    static_cast<void>(firmware.collect(bus.controller_end()));
    const TickOutput& output = firmware.finish_tick(bus.controller_end());
    robot.serve(bus.robot_end());
    const sim_hw::GroundTruth& truth = robot.truth();
    walked.has_fallen = truth.has_fallen;
    walked.has_fault = output.fault != safety::Fault::kNone;
    const sim_hw::Inclination torso = sim_hw::inclination(truth, scenario.sim.contact);
    walked.greatest_roll_deg = std::max(walked.greatest_roll_deg, std::abs(torso.roll_rad) * kDegPerRad);
    walked.greatest_pitch_deg = std::max(walked.greatest_pitch_deg, std::abs(torso.pitch_rad) * kDegPerRad);
    const stabilizer::WalkView& view = output.floor.input.walk;
    if (view.begins_step) {
      if (walked.steps > 0) steps.push_back(open.closed());
      open = {};
      ++walked.steps;
    }
    const std::optional<TruePressure> pressure = true_pressure(scenario.firmware.geometry, truth);
    const bool stands = last > 0 && walked.steps > last + 1;
    if (walked.steps == 0 || stands || !pressure) continue;
    if (view.is_swinging() && !open.carrier) {
      open.carrier = index(view.support());
      open.lift = open.samples.size();
    }
    open.samples.push_back({.time_s = static_cast<double>(tick - schedule.zero_tick) * scenario.firmware.period_s,
                            .planned_m = output.floor.planned_zmp_x_foot_m,
                            .measured_m = pressure->zmp_m,
                            .rear_m = pressure->rear_m,
                            .front_m = pressure->front_m});
    open.foot_m.push_back(pressure->foot_m);
  }
  if (last == 0 || walked.steps <= last) steps.push_back(open.closed());
  sum_up(steps, walked);
  const auto every = static_cast<std::size_t>(std::max(std::llround(kSample_s / scenario.firmware.period_s), 1LL));
  for (std::size_t step = kSettling + 1; step < std::min(kSettling + 1 + kPictured, steps.size()); ++step) {
    for (std::size_t i = 0; i < steps[step].size(); i += every) walked.picture.push_back(steps[step][i]);
  }
  return walked;
}

}  // namespace surefoot::plan
