#include "tools/run/event_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "surefoot/event_t.hpp"

namespace surefoot::run {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class EventWatchTest : public ::testing::Test {
 protected:
  std::vector<std::string> names() {
    std::vector<std::string> seen;
    for (const RunEvent& event : watch.observe(output, truth)) seen.emplace_back(event.name);
    return seen;
  }

  RunEvent only_event() {
    const std::span<const RunEvent> events = watch.observe(output, truth);
    EXPECT_EQ(events.size(), 1U);
    return events.empty() ? RunEvent{} : events.front();
  }

  EventWatch watch;
  TickOutput output;
  sim_hw::GroundTruth truth;
};

TEST_F(EventWatchTest, SeesNothingWhileNothingChanges) {
  EXPECT_THAT(names(), IsEmpty());
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(EventWatchTest, TellsTheMassOfEachPayloadNotTheSum) {
  truth.payloads_hung = 1;
  truth.payload_kg = 5.0;
  const RunEvent first = only_event();
  EXPECT_EQ(first.code, event_t::PAYLOAD_ATTACHED);
  EXPECT_STREQ(first.name, "payload_attached");
  EXPECT_DOUBLE_EQ(first.value, 5.0);
  EXPECT_THAT(names(), IsEmpty()) << "it hangs on, it is not hung on again";
  truth.payloads_hung = 2;
  truth.payload_kg = 7.0;
  EXPECT_DOUBLE_EQ(only_event().value, 2.0);
}

TEST_F(EventWatchTest, TellsTheMassOfWhatIsTakenOff) {
  truth.payloads_hung = 2;
  truth.payload_kg = 12.0;
  EXPECT_THAT(names(), ElementsAre("payload_attached"));
  truth.payloads_removed = 1;
  truth.removed_kg = 7.0;
  const RunEvent removed = only_event();
  EXPECT_EQ(removed.code, event_t::PAYLOAD_REMOVED);
  EXPECT_STREQ(removed.name, event_name(event_t::PAYLOAD_REMOVED, 0.0));
  EXPECT_DOUBLE_EQ(removed.value, 7.0);
  truth.payloads_removed = 2;
  truth.removed_kg = 12.0;
  EXPECT_DOUBLE_EQ(only_event().value, 5.0);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(EventWatchTest, TellsWhichPushesBeginAndEnd) {
  truth.pushes_begun = 0b1001;
  truth.pushes_ended = 0b0001;  // shorter than a tick
  const std::span<const RunEvent> events = watch.observe(output, truth);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events[0].code, event_t::PUSH_BEGINS);
  EXPECT_DOUBLE_EQ(events[0].value, 0.0);
  EXPECT_DOUBLE_EQ(events[1].value, 3.0);
  EXPECT_EQ(events[2].code, event_t::PUSH_ENDS);
  EXPECT_DOUBLE_EQ(events[2].value, 0.0);
  EXPECT_THAT(names(), IsEmpty());
  truth.pushes_ended = 0b1001;
  EXPECT_THAT(names(), ElementsAre("push_ends"));
  EXPECT_STREQ(event_name(event_t::PUSH_BEGINS, 0.0), "push_begins");
  EXPECT_STREQ(event_name(event_t::PUSH_ENDS, 0.0), "push_ends");
}

TEST_F(EventWatchTest, HasRoomForEveryFaultPushAndPayloadInOneTick) {
  truth.payloads_hung = truth.payloads_removed = 16;
  truth.faults_active = (1U << sim_hw::kMaxFaults) - 1U;
  truth.pushes_begun = truth.pushes_ended = (1U << sim_hw::kMaxPushes) - 1U;
  truth.has_fallen = true;
  output.decision.event = decision::ReflexEvent::kPayloadDetected;
  output.joint_reference.is_reachable = false;
  output.fault = safety::Fault::kJointOutOfRange;
  EXPECT_EQ(names().size(), 6 + sim_hw::kMaxFaults + 2 * sim_hw::kMaxPushes);
}

TEST_F(EventWatchTest, PassesEveryStepOfTheSequenceOnUnderItsTelemetryCode) {
  const std::vector<std::int8_t> codes{event_t::STANDING_DONE, event_t::PAYLOAD_DETECTED, event_t::REFLEX_DONE,
                                       event_t::SETTLED,       event_t::SHIFTED,          event_t::RESTORED,
                                       event_t::RESTED,        event_t::STOP_ORDERED,     event_t::BALANCE_LOST};
  ASSERT_EQ(codes.size(), decision::kReflexEvents.size());
  output.decision.time_in_phase_s = 0.00025;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    output.decision.event = decision::kReflexEvents[i];
    const RunEvent event = only_event();
    EXPECT_EQ(event.code, codes[i]);
    EXPECT_STREQ(event.name, decision::name(decision::kReflexEvents[i]));
    EXPECT_DOUBLE_EQ(event.value, 0.00025);
  }
}

// With the reflex on, the detector fires and the sequence moves on in the same tick: one event, not two.
TEST_F(EventWatchTest, CallsAPayloadSeenOnlyWhenNoReflexAnswersIt) {
  output.decision.is_payload_seen = true;
  output.estimate.filtered_force_n = 820.0;
  const RunEvent seen = only_event();
  EXPECT_EQ(seen.code, event_t::PAYLOAD_SEEN);
  EXPECT_STREQ(seen.name, "payload_seen");
  EXPECT_DOUBLE_EQ(seen.value, 820.0);
  output.decision.event = decision::ReflexEvent::kPayloadDetected;
  EXPECT_THAT(names(), ElementsAre("payload_detected"));
}

TEST_F(EventWatchTest, TellsALossOfReachOncePerLoss) {
  output.decision.reference_x_body_m = -0.12;
  output.joint_reference.is_reachable = false;
  const RunEvent lost = only_event();
  EXPECT_EQ(lost.code, event_t::REACH_LOST);
  EXPECT_DOUBLE_EQ(lost.value, -0.12);
  EXPECT_THAT(names(), IsEmpty());
  output.joint_reference.is_reachable = true;
  EXPECT_THAT(names(), IsEmpty());
  output.joint_reference.is_reachable = false;
  EXPECT_THAT(names(), ElementsAre("reach_lost"));
}

TEST_F(EventWatchTest, TellsAFallOnceWithThePitch) {
  truth.has_fallen = true;
  truth.pitch_rad = 0.8;
  const RunEvent fell = only_event();
  EXPECT_EQ(fell.code, event_t::FELL);
  EXPECT_DOUBLE_EQ(fell.value, 0.8);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(EventWatchTest, TellsAFaultOnceWithItsNumberAndName) {
  output.fault = safety::Fault::kBoardDamping;
  const RunEvent fault = only_event();
  EXPECT_EQ(fault.code, event_t::FAULT_LATCHED);
  EXPECT_STREQ(fault.name, safety::name(safety::Fault::kBoardDamping));
  EXPECT_DOUBLE_EQ(fault.value, 5.0);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(EventWatchTest, TellsWhichFaultsBeginAndEnd) {
  truth.faults_active = 0b101;
  const std::span<const RunEvent> begun = watch.observe(output, truth);
  ASSERT_EQ(begun.size(), 2U);
  EXPECT_EQ(begun[0].code, event_t::FAULT_INJECTED);
  EXPECT_STREQ(begun[0].name, event_name(event_t::FAULT_INJECTED, 0.0));
  EXPECT_DOUBLE_EQ(begun[0].value, 0.0);
  EXPECT_DOUBLE_EQ(begun[1].value, 2.0);
  EXPECT_THAT(names(), IsEmpty());
  truth.faults_active = 0b001;
  const RunEvent ended = only_event();
  EXPECT_EQ(ended.code, event_t::FAULT_ENDED);
  EXPECT_STREQ(ended.name, "fault_ended");
  EXPECT_DOUBLE_EQ(ended.value, 2.0);
}

TEST_F(EventWatchTest, HasRoomForEveryFaultInOneTick) {
  truth.faults_active = (1U << sim_hw::kMaxFaults) - 1U;
  EXPECT_EQ(names().size(), sim_hw::kMaxFaults);
}

// Everything at once: the world first, then what the firmware makes of it.
TEST_F(EventWatchTest, TellsAllThatHappensInOneTickInOrder) {
  truth.payloads_hung = 1;
  truth.payload_kg = 15.0;
  truth.has_fallen = true;
  output.decision.event = decision::ReflexEvent::kPayloadDetected;
  output.decision.is_payload_seen = true;
  output.joint_reference.is_reachable = false;
  output.fault = safety::Fault::kJointOutOfRange;
  EXPECT_THAT(names(), ElementsAre("payload_attached", "fell", "payload_detected", "reach_lost", "joint_out_of_range"));
}

}  // namespace
}  // namespace surefoot::run
