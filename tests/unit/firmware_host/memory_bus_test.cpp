#include "firmware/host/memory_bus.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "firmware/host/allocation_guard.hpp"
#include "tests/unit/firmware_host/frames.hpp"

namespace surefoot::host {
namespace {

using testing::number_of;
using testing::numbered_frame;

class Listener final : public BusTap {
 public:
  void on_frame(const can::CanFrame& frame) noexcept override { numbers.push_back(number_of(frame)); }
  std::vector<std::uint32_t> numbers;
};

std::vector<std::uint32_t> received(can::CanBus& end, std::size_t at_most = 1000) {
  std::vector<can::CanFrame> frames(at_most);
  frames.resize(end.receive(frames));
  std::vector<std::uint32_t> numbers;
  for (const can::CanFrame& frame : frames) numbers.push_back(number_of(frame));
  return numbers;
}

std::vector<can::CanFrame> numbered_frames(std::uint32_t first, std::uint32_t count) {
  std::vector<can::CanFrame> frames;
  for (std::uint32_t i = 0; i < count; ++i) frames.push_back(numbered_frame(first + i));
  return frames;
}

TEST(MemoryBus, DeliversToTheOtherEndInOrderAndNeverToTheSender) {
  MemoryBus bus;
  EXPECT_EQ(bus.controller_end().send(numbered_frames(1, 3)), 3U);
  EXPECT_EQ(bus.robot_end().send(numbered_frames(11, 2)), 2U);
  EXPECT_EQ(received(bus.controller_end()), (std::vector<std::uint32_t>{11, 12}));
  EXPECT_EQ(received(bus.robot_end()), (std::vector<std::uint32_t>{1, 2, 3}));
  EXPECT_TRUE(received(bus.robot_end()).empty());
}

TEST(MemoryBus, KeepsWhatDoesNotFitIntoTheReceiversBatch) {
  MemoryBus bus;
  bus.controller_end().send(numbered_frames(1, 5));
  EXPECT_EQ(received(bus.robot_end(), 2), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(received(bus.robot_end(), 2), (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(received(bus.robot_end(), 2), (std::vector<std::uint32_t>{5}));
}

TEST(MemoryBus, RefusesTheRestWhenTheQueueIsFullAndTakesAgainOnceThereIsRoom) {
  MemoryBus bus;
  EXPECT_EQ(bus.robot_end().send(numbered_frames(0, 300)), MemoryBus::kQueueFrames);
  EXPECT_EQ(bus.robot_end().send(numbered_frames(900, 1)), 0U);
  EXPECT_EQ(bus.controller_end().send(numbered_frames(500, 1)), 1U) << "the directions share no queue";
  EXPECT_EQ(received(bus.controller_end(), 1), (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(bus.robot_end().send(numbered_frames(901, 2)), 1U);
  const std::vector<std::uint32_t> rest = received(bus.controller_end());
  ASSERT_EQ(rest.size(), MemoryBus::kQueueFrames);
  EXPECT_EQ(rest.front(), 1U);
  EXPECT_EQ(rest.back(), 901U);
}

TEST(MemoryBus, TapSeesEachAcceptedFrameOfBothEndsInTheOrderOfSendingAndNoRefusedOne) {
  Listener listener;
  MemoryBus bus(&listener);
  bus.controller_end().send(numbered_frames(1, 1));
  bus.robot_end().send(numbered_frames(2, 2));
  bus.controller_end().send(numbered_frames(4, 1));
  EXPECT_EQ(listener.numbers, (std::vector<std::uint32_t>{1, 2, 3, 4}));
  bus.robot_end().send(numbered_frames(0, 300));
  EXPECT_EQ(listener.numbers.size(), 4 + MemoryBus::kQueueFrames - 2);
}

TEST(MemoryBus, ACopyHasTheFramesThatAreOnTheirWayAndAnotherTap) {
  Listener first;
  Listener second;
  MemoryBus bus(&first);
  bus.controller_end().send(numbered_frames(1, 2));
  bus.robot_end().send(numbered_frames(11, 3));
  MemoryBus copy(bus, &second);
  EXPECT_EQ(received(copy.robot_end()), (std::vector<std::uint32_t>{1, 2}));
  copy.robot_end().send(numbered_frames(20, 1));
  EXPECT_EQ(received(copy.controller_end()), (std::vector<std::uint32_t>{11, 12, 13, 20}));
  EXPECT_EQ(received(bus.robot_end()), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(received(bus.controller_end()), (std::vector<std::uint32_t>{11, 12, 13}));
  EXPECT_EQ(first.numbers, (std::vector<std::uint32_t>{1, 2, 11, 12, 13}));
  EXPECT_EQ(second.numbers, (std::vector<std::uint32_t>{20}));
}

TEST(MemoryBus, DoesNotAllocateAfterItsConstruction) {
  MemoryBus bus;
  const std::vector<can::CanFrame> frames = numbered_frames(0, 300);
  std::vector<can::CanFrame> room(300);
  allocation_guard::arm();
  bus.controller_end().send(frames);
  bus.robot_end().receive(room);
  EXPECT_EQ(allocation_guard::disarm().allocations, 0U);
}

}  // namespace
}  // namespace surefoot::host
