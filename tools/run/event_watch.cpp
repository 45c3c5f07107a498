#include "tools/run/event_watch.hpp"

#include "surefoot/event_t.hpp"

namespace surefoot::run {

std::span<const RunEvent> EventWatch::observe(const TickOutput& output, const sim_hw::GroundTruth& truth) noexcept {
  count_ = 0;
  const decision::Decision& decision = output.decision;
  if (truth.payloads_hung != payloads_hung_) {
    add(event_t::PAYLOAD_ATTACHED, "payload_attached", truth.payload_kg - payload_kg_);
  }
  if (decision.event) {
    add(static_cast<std::int8_t>(*decision.event), decision::name(*decision.event), decision.time_in_phase_s);
  } else if (decision.is_payload_seen) {
    add(event_t::PAYLOAD_SEEN, "payload_seen", output.estimate.filtered_force_n);
  }
  if (!output.joint_reference.is_reachable && is_reachable_) {
    add(event_t::REACH_LOST, "reach_lost", decision.reference_x_body_m);
  }
  if (truth.has_fallen && !has_fallen_) add(event_t::FELL, "fell", truth.pitch_rad);
  if (output.fault != fault_) {
    add(event_t::FAULT_LATCHED, safety::name(output.fault), static_cast<double>(output.fault));
  }
  payloads_hung_ = truth.payloads_hung;
  payload_kg_ = truth.payload_kg;
  is_reachable_ = output.joint_reference.is_reachable;
  has_fallen_ = truth.has_fallen;
  fault_ = output.fault;
  return {events_.data(), count_};
}

}  // namespace surefoot::run
