#include "firmware/host/telemetry_ring.hpp"

#include <gtest/gtest.h>

#include <surefoot/bus_statistics_t.hpp>
#include <surefoot/controller_state_t.hpp>
#include <surefoot/event_t.hpp>
#include <surefoot/simulator_truth_t.hpp>
#include <surefoot/stabilizer_t.hpp>
#include <surefoot/timing_statistics_t.hpp>

#include "firmware/can/messages.hpp"
#include "firmware/core/decision/reflex_phase.hpp"
#include "firmware/core/decision/walk_stage.hpp"
#include "firmware/core/safety/safe_state.hpp"
#include "firmware/core/stabilizer/activation.hpp"
#include "firmware/host/allocation_guard.hpp"

namespace surefoot::host {
namespace {

/// Sends a message of bytes 1, 2, 3 ... through a ring and its encoding, and compares what comes out.
template <class Message>
void expect_round_trip() {
  std::array<unsigned char, sizeof(Message)> pattern{};
  Message sent;
  for (std::size_t i = 0; i < pattern.size(); ++i) pattern[i] = static_cast<unsigned char>(i % 127 + 1);
  std::memcpy(static_cast<void*>(&sent), pattern.data(), sizeof(Message));

  TelemetryRing ring(2);
  allocation_guard::arm();
  const bool was_taken = push(ring, Channel::kEvent, -7, sent);
  EXPECT_EQ(allocation_guard::disarm().allocations, 0U);
  ASSERT_TRUE(was_taken);
  std::array<std::byte, kMaxEncodedBytes> buffer{};
  int size = 0;
  ring.consume(
      [&](const TelemetrySlot& slot) {
        EXPECT_EQ(slot.utime_us, -7);
        EXPECT_EQ(slot.channel, Channel::kEvent);
        size = slot.encode(slot.message.data(), buffer.data(), static_cast<int>(buffer.size()));
      },
      1);
  ASSERT_EQ(size, sent.getEncodedSize());
  Message received;
  ASSERT_EQ(received.decode(buffer.data(), 0, size), size);
  std::array<std::byte, kMaxEncodedBytes> again{};
  ASSERT_EQ(received.encode(again.data(), 0, static_cast<int>(again.size())), size);
  EXPECT_EQ(again, buffer);
}

TEST(TelemetryRing, CarriesEveryMessageTypeUnchangedAndWithoutAllocating) {
  expect_round_trip<controller_state_t>();
  expect_round_trip<event_t>();
  expect_round_trip<simulator_truth_t>();
  expect_round_trip<bus_statistics_t>();
  expect_round_trip<timing_statistics_t>();
  expect_round_trip<stabilizer_t>();
}

TEST(TelemetryRing, FullRingDropsAndCounts) {
  TelemetryRing ring(2);
  const event_t event{};
  EXPECT_TRUE(push(ring, Channel::kEvent, 0, event));
  EXPECT_TRUE(push(ring, Channel::kEvent, 1, event));
  EXPECT_FALSE(push(ring, Channel::kEvent, 2, event));
  EXPECT_EQ(ring.drops(), 1U);
}

// The schemas can not include the firmware's enumerations, so that their tables are held together here.
TEST(MessageConstants, AgreeWithTheFirmwaresEnumerations) {
  using decision::ReflexEvent;
  using decision::ReflexPhase;
  const auto value = [](auto enumerator) { return static_cast<std::int8_t>(enumerator); };
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_STANDING}, value(ReflexPhase::kStanding));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_WALKING}, value(ReflexPhase::kWalking));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_REFLEX}, value(ReflexPhase::kReflex));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_SETTLING}, value(ReflexPhase::kSettling));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_SHIFTING}, value(ReflexPhase::kShifting));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_RESTORING}, value(ReflexPhase::kRestoring));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_RESTING}, value(ReflexPhase::kResting));
  EXPECT_EQ(std::int8_t{controller_state_t::PHASE_STOPPED}, value(ReflexPhase::kStopped));
  EXPECT_EQ(std::int8_t{event_t::STANDING_DONE}, value(ReflexEvent::kStandingDone));
  EXPECT_EQ(std::int8_t{event_t::PAYLOAD_DETECTED}, value(ReflexEvent::kPayloadDetected));
  EXPECT_EQ(std::int8_t{event_t::REFLEX_DONE}, value(ReflexEvent::kReflexDone));
  EXPECT_EQ(std::int8_t{event_t::SETTLED}, value(ReflexEvent::kSettled));
  EXPECT_EQ(std::int8_t{event_t::SHIFTED}, value(ReflexEvent::kShifted));
  EXPECT_EQ(std::int8_t{event_t::RESTORED}, value(ReflexEvent::kRestored));
  EXPECT_EQ(std::int8_t{event_t::RESTED}, value(ReflexEvent::kRested));
  EXPECT_EQ(std::int8_t{event_t::STOP_ORDERED}, value(ReflexEvent::kStopOrdered));
  EXPECT_EQ(std::int8_t{controller_state_t::SAFE_NONE}, value(safety::SafeState::kNone));
  EXPECT_EQ(std::int8_t{controller_state_t::SAFE_STANCE_HOLD}, value(safety::SafeState::kStanceHold));
  EXPECT_EQ(std::int8_t{controller_state_t::SAFE_DAMP}, value(safety::SafeState::kDamp));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_UNKNOWN_IDENTIFIER}, value(can::Rejection::kUnknownIdentifier));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_WRONG_LENGTH}, value(can::Rejection::kWrongLength));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_WRONG_CRC}, value(can::Rejection::kWrongCrc));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_REPEATED}, value(can::Rejection::kRepeated));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_LATE}, value(can::Rejection::kLate));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_IMPLAUSIBLE}, value(can::Rejection::kImplausible));
  EXPECT_EQ(std::int8_t{bus_statistics_t::REJECTED_FOREIGN_VERSION}, value(can::Rejection::kForeignVersion));
}

TEST(MessageConstants, OfTheStabilizerAgreeWithTheFirmwaresEnumerations) {
  using decision::WalkStage;
  using stabilizer::Controller;
  const auto value = [](auto enumerator) { return static_cast<std::int8_t>(enumerator); };
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_STANDING}, value(WalkStage::kStanding));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_SHIFTING}, value(WalkStage::kShifting));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_LIFT_LEFT}, value(WalkStage::kLiftLeft));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_LOWER_LEFT}, value(WalkStage::kLowerLeft));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_LIFT_RIGHT}, value(WalkStage::kLiftRight));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_LOWER_RIGHT}, value(WalkStage::kLowerRight));
  EXPECT_EQ(std::int8_t{stabilizer_t::STAGE_LANDING}, value(WalkStage::kLanding));
  EXPECT_EQ(std::int8_t{stabilizer_t::RIGHT}, value(Side::kRight));
  EXPECT_EQ(std::int8_t{stabilizer_t::LEFT}, value(Side::kLeft));
  EXPECT_EQ(std::int8_t{stabilizer_t::UPRIGHT_POSE}, value(Controller::kUprightPose));
  EXPECT_EQ(std::int8_t{stabilizer_t::LANDING_MOMENTUM}, value(Controller::kLandingMomentum));
  EXPECT_EQ(std::int8_t{stabilizer_t::SHOCK_ABSORBER}, value(Controller::kShockAbsorber));
  EXPECT_EQ(std::int8_t{stabilizer_t::LANDING_TIMING}, value(Controller::kLandingTiming));
  EXPECT_EQ(std::int8_t{stabilizer_t::LANDING_POSITION}, value(Controller::kLandingPosition));
  EXPECT_EQ(std::int8_t{stabilizer_t::VIBRATION_REDUCTION}, value(Controller::kVibrationReduction));
  EXPECT_EQ(std::int8_t{stabilizer_t::DAMPING}, value(Controller::kDamping));
  EXPECT_EQ(std::int8_t{stabilizer_t::ZMP_COMPENSATOR}, value(Controller::kZmpCompensator));
  EXPECT_EQ(std::int8_t{stabilizer_t::SOFT_LANDING}, value(Controller::kSoftLanding));
  EXPECT_EQ(std::int8_t{stabilizer_t::SWAY_AMPLITUDE}, value(Controller::kSwayAmplitude));
  EXPECT_EQ(std::int8_t{stabilizer_t::TORSO_TILT}, value(Controller::kTorsoTilt));
  EXPECT_EQ(std::int8_t{stabilizer_t::TILT_OVER}, value(Controller::kTiltOver));
  EXPECT_EQ(std::int8_t{stabilizer_t::TILT_LANDING_POSITION}, value(Controller::kTiltLandingPosition));
  EXPECT_EQ(std::int8_t{stabilizer_t::ATTITUDE_FEEDBACK}, value(Controller::kAttitudeFeedback));
  EXPECT_EQ(std::int8_t{stabilizer_t::FOOT_TILT}, value(Controller::kFootTilt));
  EXPECT_EQ(std::int8_t{stabilizer_t::STEP_ADJUSTMENT}, value(Controller::kStepAdjustment));
  EXPECT_EQ(std::int8_t{stabilizer_t::GROUND_SEEKING}, value(Controller::kGroundSeeking));
  EXPECT_EQ(std::size_t{stabilizer_t::TOTAL}, stabilizer::kControllers);
}

}  // namespace
}  // namespace surefoot::host
