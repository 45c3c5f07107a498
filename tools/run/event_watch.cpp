#include "tools/run/event_watch.hpp"

#include <bit>

#include "surefoot/event_t.hpp"

namespace surefoot::run {
namespace {

constexpr const char* kPayloadSeen = "payload_seen";
constexpr const char* kPayloadAttached = "payload_attached";
constexpr const char* kPayloadRemoved = "payload_removed";
constexpr const char* kPushBegins = "push_begins";
constexpr const char* kPushEnds = "push_ends";
constexpr const char* kFell = "fell";
constexpr const char* kFaultInjected = "fault_injected";
constexpr const char* kFaultEnded = "fault_ended";
constexpr const char* kReachLost = "reach_lost";

}  // namespace

const char* event_name(std::int8_t code, double value) noexcept {
  for (const decision::ReflexEvent event : decision::kReflexEvents) {
    if (code == static_cast<std::int8_t>(event)) return decision::name(event);
  }
  switch (code) {
    case event_t::PAYLOAD_SEEN:
      return kPayloadSeen;
    case event_t::PAYLOAD_ATTACHED:
      return kPayloadAttached;
    case event_t::PAYLOAD_REMOVED:
      return kPayloadRemoved;
    case event_t::PUSH_BEGINS:
      return kPushBegins;
    case event_t::PUSH_ENDS:
      return kPushEnds;
    case event_t::FELL:
      return kFell;
    case event_t::FAULT_INJECTED:
      return kFaultInjected;
    case event_t::FAULT_ENDED:
      return kFaultEnded;
    case event_t::FAULT_LATCHED:
      return safety::name(static_cast<safety::Fault>(value));
    case event_t::REACH_LOST:
      return kReachLost;
    default:
      return "unknown";
  }
}

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
  watch_faults(truth.faults_active);
  watch_payloads(truth);
  watch_pushes(truth);
  if (truth.has_fallen && !has_fallen_) add(event_t::FELL, kFell, truth.pitch_rad);
  has_fallen_ = truth.has_fallen;
}

void EventWatch::watch_payloads(const sim_hw::GroundTruth& truth) noexcept {
  if (truth.payloads_hung != payloads_hung_) {
    add(event_t::PAYLOAD_ATTACHED, kPayloadAttached, truth.payload_kg - payload_kg_);
  }
  if (truth.payloads_removed != payloads_removed_) {
    add(event_t::PAYLOAD_REMOVED, kPayloadRemoved, truth.removed_kg - removed_kg_);
  }
  payloads_hung_ = truth.payloads_hung;
  payload_kg_ = truth.payload_kg;
  payloads_removed_ = truth.payloads_removed;
  removed_kg_ = truth.removed_kg;
}

void EventWatch::watch_pushes(const sim_hw::GroundTruth& truth) noexcept {
  for (std::uint32_t begun = truth.pushes_begun & ~pushes_begun_; begun != 0; begun &= begun - 1) {
    add(event_t::PUSH_BEGINS, kPushBegins, std::countr_zero(begun));
  }
  for (std::uint32_t ended = truth.pushes_ended & ~pushes_ended_; ended != 0; ended &= ended - 1) {
    add(event_t::PUSH_ENDS, kPushEnds, std::countr_zero(ended));
  }
  pushes_begun_ = truth.pushes_begun;
  pushes_ended_ = truth.pushes_ended;
}

void EventWatch::watch_faults(std::uint32_t active) noexcept {
  for (std::uint32_t changed = active ^ faults_active_; changed != 0; changed &= changed - 1) {
    const int place = std::countr_zero(changed);
    const bool is_on = ((active >> place) & 1U) != 0;
    add(is_on ? event_t::FAULT_INJECTED : event_t::FAULT_ENDED, is_on ? kFaultInjected : kFaultEnded, place);
  }
  faults_active_ = active;
}

void EventWatch::watch(const TickOutput& output) noexcept {
  const decision::Decision& decision = output.decision;
  if (decision.event) {
    add(static_cast<std::int8_t>(*decision.event), decision::name(*decision.event), decision.time_in_phase_s);
  } else if (decision.is_payload_seen) {
    add(event_t::PAYLOAD_SEEN, kPayloadSeen, output.estimate.filtered_force_n);
  }
  if (!output.joint_reference.is_reachable && is_reachable_) {
    add(event_t::REACH_LOST, kReachLost, decision.reference_x_body_m);
  }
  if (output.fault != fault_) {
    add(event_t::FAULT_LATCHED, safety::name(output.fault), static_cast<double>(output.fault));
  }
  is_reachable_ = output.joint_reference.is_reachable;
  fault_ = output.fault;
}

}  // namespace surefoot::run
