#include "tools/run/stabilizer_message.hpp"

#include <cstddef>

namespace surefoot::run {
namespace {

constexpr float single(double value) noexcept { return static_cast<float>(value); }

void put(const PerSide<double>& source, float (&target)[2]) noexcept {
  for (const Side side : kSides) target[index(side)] = single(source[index(side)]);
}

void put_walk(const stabilizer::WalkView& walk, stabilizer_t& message) noexcept {
  message.stage = static_cast<std::int8_t>(walk.stage);
  message.moving = static_cast<std::int8_t>(walk.moving);
  message.is_double_support = walk.is_double_support ? 1 : 0;
  message.has_landed = walk.has_landed ? 1 : 0;
  message.is_waiting = walk.is_waiting ? 1 : 0;
  message.step_share = single(walk.step_share);
  message.swing_share = single(walk.swing_share);
}

void put_sensors(const stabilizer::StabilizerInput& input, stabilizer_t& message) noexcept {
  message.torso_roll_rad = single(input.measured.torso_roll_rad);
  message.torso_pitch_rad = single(input.measured.torso_pitch_rad);
  message.torso_roll_rate_rad_s = single(input.measured.torso_roll_rate_rad_s);
  message.torso_pitch_rate_rad_s = single(input.measured.torso_pitch_rate_rad_s);
  message.nominal_roll_rad = single(input.nominal.torso_roll_rad);
  message.nominal_pitch_rad = single(input.nominal.torso_pitch_rad);
  put(input.hip_roll_rate_rad_s, message.hip_roll_rate_rad_s);
  put(input.foot_roll_rad, message.foot_roll_rad);
  put(input.foot_pitch_rad, message.foot_pitch_rad);
  for (const Side side : kSides) {
    const std::size_t i = index(side);
    message.ankle_force_n[i] = single(input.ankle[i].normal_force_n);
    message.ankle_roll_moment_nm[i] = single(input.ankle[i].roll_moment_nm);
    message.ankle_pitch_moment_nm[i] = single(input.ankle[i].pitch_moment_nm);
    message.zmp_x_foot_m[i] = single(input.ankle[i].zmp_x_foot_m());
    message.zmp_y_foot_m[i] = single(input.ankle[i].zmp_y_foot_m());
  }
}

void put_adjustment(const stabilizer::Adjustment& adjustment, std::size_t row, stabilizer_t& message) noexcept {
  message.pelvis_m[row][0] = single(adjustment.pelvis_x_m);
  message.pelvis_m[row][1] = single(adjustment.pelvis_y_m);
  message.pelvis_m[row][2] = single(adjustment.pelvis_z_m);
  put(adjustment.leg_length_m, message.leg_length_m[row]);
  put(adjustment.ankle_roll_rad, message.ankle_roll_rad[row]);
  put(adjustment.ankle_pitch_rad, message.ankle_pitch_rad[row]);
  put(adjustment.hip_roll_rad, message.hip_roll_rad[row]);
  message.landing_m[row][0] = single(adjustment.landing_x_m);
  message.landing_m[row][1] = single(adjustment.landing_y_m);
  message.sway_m[row] = single(adjustment.sway_m);
  message.sway_centre_m[row][0] = single(adjustment.sway_centre_x_m);
  message.sway_centre_m[row][1] = single(adjustment.sway_centre_y_m);
  message.earlier_landing_s[row] = single(adjustment.earlier_landing_s);
  message.holds_lowering[row] = adjustment.holds_lowering ? 1 : 0;
  message.waits_for_contact[row] = adjustment.waits_for_contact ? 1 : 0;
}

}  // namespace

stabilizer_t stabilizer_message(std::int64_t utime_us, const stabilizer::Switches& is_on,
                                const TickOutput& output) noexcept {
  const stabilizer::StabilizerInput& input = output.floor.input;
  stabilizer_t message{};
  message.utime = utime_us;
  message.tick = output.tick;
  put_walk(input.walk, message);
  put_sensors(input, message);
  for (const stabilizer::ActivationRow& row : stabilizer::kActivation) {
    const auto i = static_cast<std::size_t>(row.controller);
    message.is_on[i] = is_on[i] ? 1 : 0;
    message.is_active[i] = is_on[i] && stabilizer::is_active(row.controller, input.walk) ? 1 : 0;
    put_adjustment(output.floor.adjustment.of[i], i, message);
  }
  put_adjustment(output.floor.adjustment.total, stabilizer_t::TOTAL, message);
  return message;
}

StabilizerTelemetry::StabilizerTelemetry(const ControllerConfig& config) noexcept
    : walks_on_floors_(config.method == WalkMethod::kFloorWalk), is_on_(config.floor.stabilizer.is_on) {}

void StabilizerTelemetry::push(host::RunRecorder& recorder, std::int64_t utime_us,
                               const TickOutput& output) const noexcept {
  if (!walks_on_floors_) return;
  recorder.push(host::Channel::kStabilizer, utime_us, stabilizer_message(utime_us, is_on_, output));
}

}  // namespace surefoot::run
