#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "firmware/can/messages.hpp"
#include "sim_hw/faults/bus_line.hpp"
#include "sim_hw/faults/frame_fault.hpp"
#include "tests/unit/sim_hw/wire.hpp"

namespace surefoot::sim_hw {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using enum FaultKind;
using Identifiers = std::vector<std::uint16_t>;

constexpr std::uint32_t kAll = 0xFFFF;  ///< every fault is on

can::CanFrame state_of(can::Node node, std::uint32_t tick = 7) {
  const can::FrameStamp stamp{.tick = tick, .counter = 3};
  switch (node) {
    case can::Node::kLegRight:
      return can::encode_leg_state(Side::kRight, stamp, {}, {});
    case can::Node::kLegLeft:
      return can::encode_leg_state(Side::kLeft, stamp, {}, {});
    case can::Node::kFootRight:
      return can::encode_foot_force(Side::kRight, stamp, {});
    case can::Node::kFootLeft:
      return can::encode_foot_force(Side::kLeft, stamp, {});
    default:
      return can::encode_imu(stamp, {});
  }
}

/// A line, the bus behind it, and what came out at either end.
class Line {
 public:
  explicit Line(std::vector<FaultConfig> faults, std::uint64_t seed = 1)
      : schedule_(std::move(faults), 1e-3), line(schedule_, seed, answers) {
    line.connect(wire);
    begin(0);
  }

  void begin(std::int64_t period, std::uint32_t active = kAll) {
    line.begin_period(period, active & ((1U << schedule_.faults().size()) - 1U));
  }

  void send(can::Node node) {
    const can::CanFrame frame = state_of(node);
    EXPECT_EQ(line.send({&frame, 1}), 1U);
  }

  /// What the bus has got since the last call.
  std::vector<can::CanFrame> sent() { return std::exchange(wire.from_robot, {}); }
  Identifiers sent_identifiers() { return identifiers(sent()); }

  /// What the nodes have heard since the last call.
  std::vector<can::CanFrame> heard() {
    std::vector<can::CanFrame> frames(300);
    frames.resize(line.receive(frames));
    return frames;
  }
  Identifiers heard_identifiers() { return identifiers(heard()); }

  static Identifiers identifiers(const std::vector<can::CanFrame>& frames) {
    Identifiers all;
    for (const can::CanFrame& frame : frames) all.push_back(frame.identifier);
    return all;
  }

 private:
  FaultSchedule schedule_;

 public:
  AnswerWatch answers;
  testing::Wire wire;
  BusLine line;
};

const can::CanFrame kSync = can::encode_sync({.tick = 7});
const can::CanFrame kRightCommand = can::encode_leg_command(Side::kRight, {.tick = 7}, {});
const can::CanFrame kLeftCommand = can::encode_leg_command(Side::kLeft, {.tick = 7}, {});

TEST(BusLine, PassesEverythingWhileNoFaultIsOn) {
  Line line({{.kind = kLinkDown}, {.kind = kDrop}});
  line.begin(0, 0);
  line.send(can::Node::kLegLeft);
  line.line.enter(kSync);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x182));
  EXPECT_THAT(line.heard_identifiers(), ElementsAre(0x080));
}

TEST(BusLine, DropsFramesOfANodeAndTorquesForIt) {
  Line line({{.kind = kDrop, .target = FaultTarget::kLegRight}});
  line.send(can::Node::kLegRight);
  line.send(can::Node::kLegLeft);
  for (const can::CanFrame& frame : {kSync, kRightCommand, kLeftCommand}) line.line.enter(frame);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x182));
  EXPECT_THAT(line.heard_identifiers(), ElementsAre(0x080, 0x202));
  EXPECT_EQ(line.line.counters().dropped, 2U);
}

TEST(BusLine, FramesFromOutsideAreTheControllers) {
  Line line({{.kind = kDrop, .target = FaultTarget::kController}});
  line.send(can::Node::kLegRight);
  for (const can::CanFrame& frame : {kSync, kRightCommand}) line.line.enter(frame);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x181));
  EXPECT_THAT(line.heard(), IsEmpty());
}

TEST(BusLine, DropsTheShareThatTheProbabilitySays) {
  Line line({{.kind = kDrop, .probability = 0.2}});
  for (int period = 0; period < 20000; ++period) {
    line.begin(period);
    line.send(can::Node::kFootLeft);
  }
  EXPECT_NEAR(static_cast<double>(line.sent().size()), 16000.0, 4 * 56.6);  // 4 standard deviations
}

TEST(BusLine, DuplicatesStandBehindTheirOriginal) {
  Line line({{.kind = kDuplicate, .target = FaultTarget::kFootLeft, .value = 2.0}});
  line.send(can::Node::kFootLeft);
  line.send(can::Node::kTorsoImu);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x184, 0x184, 0x184, 0x185));
}

TEST(BusLine, DelaysByWholePeriodsInOrderAndBeforeTheFramesOfTheLaterOne) {
  Line line({{.kind = kDelay, .target = FaultTarget::kFootLeft, .value = 3.0}});
  line.send(can::Node::kFootLeft);
  line.begin(2);
  EXPECT_THAT(line.sent(), IsEmpty());
  line.begin(3);
  line.send(can::Node::kTorsoImu);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x184, 0x185));
  line.begin(6);
  EXPECT_THAT(line.sent(), IsEmpty()) << "once";
}

TEST(BusLine, DelayedFramesArriveThoughTheFaultHasEndedAndPeriodsWereSkipped) {
  Line line({{.kind = kDelay, .value = 3.0}});
  line.line.enter(kRightCommand);
  line.begin(10, 0);
  EXPECT_THAT(line.heard_identifiers(), ElementsAre(0x201));
}

TEST(BusLine, DelaysAddUp) {
  Line line({{.kind = kDelay, .value = 2.0}, {.kind = kDelay, .target = FaultTarget::kTorso, .value = 1.0}});
  line.send(can::Node::kTorsoImu);
  line.begin(2);
  EXPECT_THAT(line.sent(), IsEmpty());
  line.begin(3);
  EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x185));
}

TEST(BusLine, CorruptsFramesSoThatNoReceiverTakesThem) {
  Line line({{.kind = kCorrupt, .value = 3.0}});
  for (int period = 0; period < 1000; ++period) {
    line.begin(period);
    line.send(can::Node::kLegLeft);
    line.line.enter(kSync);
  }
  for (const can::CanFrame& frame : line.sent()) EXPECT_FALSE(is_acceptable(frame));
  EXPECT_EQ(line.line.counters().corrupted, 2000U);
  EXPECT_EQ(line.line.counters().corrupted_unnoticed, 0U);
}

TEST(BusLine, SwappedPlugsExchangeBothNodesWithAFittingCrc) {
  Line line({{.kind = kSwap, .target = FaultTarget::kLegRight, .value = 1.0}});
  line.send(can::Node::kLegRight);
  line.send(can::Node::kLegLeft);
  line.send(can::Node::kFootLeft);
  const std::vector<can::CanFrame> sent = line.sent();
  EXPECT_THAT(Line::identifiers(sent), ElementsAre(0x182, 0x181, 0x184));
  for (const can::CanFrame& frame : sent) EXPECT_TRUE(is_acceptable(frame));
  line.line.enter(kRightCommand);
  const std::vector<can::CanFrame> heard = line.heard();
  EXPECT_THAT(Line::identifiers(heard), ElementsAre(0x202));
  EXPECT_TRUE(is_acceptable(heard[0]));
}

TEST(BusLine, MisroutedFramesDoNotFitTheirCrc) {
  Line line({{.kind = kSwap, .target = FaultTarget::kFootLeft, .value = 0.0}});
  line.send(can::Node::kFootLeft);
  const std::vector<can::CanFrame> sent = line.sent();
  EXPECT_THAT(Line::identifiers(sent), ElementsAre(0x183));
  EXPECT_FALSE(is_acceptable(sent[0]));
}

TEST(BusLine, NodesOffTheBusNeitherSendNorHear) {
  for (const FaultKind kind : {kDeadNode, kRestart, kBusOff}) {
    Line line({{.kind = kind, .target = FaultTarget::kLegLeft}});
    line.send(can::Node::kLegLeft);
    line.send(can::Node::kFootLeft);
    line.line.enter(kLeftCommand);
    line.line.enter(kSync);
    EXPECT_THAT(line.sent_identifiers(), ElementsAre(0x184));
    EXPECT_THAT(line.heard_identifiers(), ElementsAre(0x080)) << "the others hear SYNC";
    EXPECT_FALSE(line.line.hears(can::Node::kLegLeft));
    EXPECT_TRUE(line.line.hears(can::Node::kLegRight));
    line.begin(1, 0);
    EXPECT_TRUE(line.line.hears(can::Node::kLegLeft));
  }
}

TEST(BusLine, LinkThatIsDownPassesNothingAndLosesWhatWasDelayed) {
  Line line({{.kind = kDelay, .value = 1.0}, {.kind = kLinkDown}});
  line.begin(0, 1);
  line.send(can::Node::kTorsoImu);
  line.begin(1);
  line.send(can::Node::kFootLeft);
  line.line.enter(kSync);
  EXPECT_THAT(line.sent(), IsEmpty());
  EXPECT_THAT(line.heard(), IsEmpty());
  EXPECT_EQ(line.line.counters().silenced, 3U);
}

TEST(BusLine, BabblingNodeFloodsTheControllerWithIntactFrames) {
  Line line({{.kind = kBabble, .target = FaultTarget::kFootRight, .value = 20.0}});
  line.wire.from_robot.clear();
  line.begin(1);
  const std::vector<can::CanFrame> sent = line.sent();
  ASSERT_EQ(sent.size(), 20U);
  for (const can::CanFrame& frame : sent) {
    EXPECT_EQ(frame.identifier, can::emergency_identifier(can::Node::kFootRight));
    EXPECT_TRUE(is_acceptable(frame));
  }
  EXPECT_NE(sent[0].payload, sent[1].payload) << "the counter moves on";
}

TEST(BusLine, BabblingControllerFloodsTheNodes) {
  Line line({{.kind = kBabble, .target = FaultTarget::kController, .value = 20.0}});
  (void)line.heard();
  line.begin(1);
  EXPECT_EQ(line.heard().size(), 20U);
  EXPECT_THAT(line.sent(), IsEmpty());
}

TEST(BusLine, DeadNodeDoesNotBabble) {
  Line line({{.kind = kBabble, .target = FaultTarget::kTorso, .value = 20.0},
             {.kind = kDeadNode, .target = FaultTarget::kTorso}});
  EXPECT_THAT(line.sent(), IsEmpty());
}

TEST(BusLine, AFaultBesideItChangesNoDrawOfAFault) {
  const FaultConfig drop{.kind = kDrop, .target = FaultTarget::kLegLeft, .probability = 0.5};
  const FaultConfig other{.kind = kDrop, .target = FaultTarget::kTorso, .probability = 0.5};
  const FaultConfig copies{.kind = kDuplicate, .target = FaultTarget::kFootLeft, .probability = 0.5};
  Line alone({drop});
  Line behind({other, copies, drop});
  for (int period = 0; period < 500; ++period) {
    for (Line* line : {&alone, &behind}) {
      line->begin(period);
      for (const can::Node node : {can::Node::kTorsoImu, can::Node::kFootLeft, can::Node::kLegLeft}) line->send(node);
    }
    const auto is_through = [](const Identifiers& sent) { return std::ranges::count(sent, 0x182) == 1; };
    ASSERT_EQ(is_through(alone.sent_identifiers()), is_through(behind.sent_identifiers())) << period;
  }
}

TEST(BusLine, AnswersCountOnlyAsTheirNodesSentThemAndInTheirTick) {
  const auto is_complete_with = [](std::vector<FaultConfig> faults) {
    Line line(std::move(faults));
    line.answers.begin_tick(7);
    for (const can::Node node : {can::Node::kLegRight, can::Node::kLegLeft, can::Node::kFootRight, can::Node::kFootLeft,
                                 can::Node::kTorsoImu}) {
      EXPECT_FALSE(line.answers.is_complete());
      line.send(node);
    }
    return line.answers.is_complete();
  };
  EXPECT_TRUE(is_complete_with({{.kind = kDuplicate}}));
  EXPECT_TRUE(is_complete_with({{.kind = kSwap, .target = FaultTarget::kLegLeft, .value = 1.0}}));
  EXPECT_FALSE(is_complete_with({{.kind = kSwap, .target = FaultTarget::kLegLeft, .value = 0.0}}));
  EXPECT_FALSE(is_complete_with({{.kind = kDrop, .target = FaultTarget::kTorso}}));
  EXPECT_FALSE(is_complete_with({{.kind = kDelay, .target = FaultTarget::kTorso}}));
  EXPECT_FALSE(is_complete_with({{.kind = kCorrupt, .target = FaultTarget::kTorso}}));
}

}  // namespace
}  // namespace surefoot::sim_hw
