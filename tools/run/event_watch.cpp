#include "tools/run/event_watch.hpp"

#include "surefoot/event_t.hpp"

namespace surefoot::run {

std::span<const RunEvent> EventWatch::observe(const TickOutput& output, const sim_hw::GroundTruth& truth) noexcept {
  count_ = 0;
  watch(truth);
  watch(output);
  return {events_.data(), count_};
}

std::span<const RunEvent> EventWatch::observe_world(const sim_hw::GroundTruth& truth) noexcept {
  count_ = 0;
  watch(truth);
  return {events_.data(), count_};
}

std::span<const RunEvent> EventWatch::observe_firmware(const TickOutput& output) noexcept {
  count_ = 0;
  watch(output);
  return {events_.data(), count_};
}

void EventWatch::watch(const sim_hw::GroundTruth& truth) noexcept {
  if (truth.payloads_hung != payloads_hung_) {
    add(event_t::PAYLOAD_ATTACHED, "payload_attached", truth.payload_kg - payload_kg_);
  }
  if (truth.has_fallen && !has_fallen_) add(event_t::FELL, "fell", truth.pitch_rad);
  payloads_hung_ = truth.payloads_hung;
  payload_kg_ = truth.payload_kg;
  has_fallen_ = truth.has_fallen;
}

void EventWatch::watch(const TickOutput& output) noexcept {
  const decision::Decision& decision = output.decision;
  if (decision.event) {
    add(static_cast<std::int8_t>(*decision.event), decision::name(*decision.event), decision.time_in_phase_s);
  } else if (decision.is_payload_seen) {
    add(event_t::PAYLOAD_SEEN, "payload_seen", output.estimate.filtered_force_n);
  }
  if (!output.joint_reference.is_reachable && is_reachable_) {
    add(event_t::REACH_LOST, "reach_lost", decision.reference_x_body_m);
  }
  if (output.fault != fault_) {
    add(event_t::FAULT_LATCHED, safety::name(output.fault), static_cast<double>(output.fault));
  }
  is_reachable_ = output.joint_reference.is_reachable;
  fault_ = output.fault;
}

}  // namespace surefoot::run
