// Frames without payload whose bits are counted by hand (frame_bits_test.cpp): identifier 0x555 has 29 nominal and
// 33 data bits, at 1 and 5 Mbit/s 35.6 us; 0x080 one stuff bit more, 36.6 us.
#include "sim_hw/bus/arbiter.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kEver = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t k555_ns = 35'600;
constexpr std::int64_t k080_ns = 36'600;

can::CanFrame empty(int identifier) { return {.identifier = static_cast<std::uint16_t>(identifier), .length = 0}; }

std::vector<Transmission> all(Arbiter& bus, std::int64_t until_ns = kEver) {
  std::vector<Transmission> sent;
  while (const auto next = bus.transmit_next(until_ns)) sent.push_back(*next);
  return sent;
}

TEST(Arbiter, SendsAFrameAtOnceWhenTheBusIsFree) {
  Arbiter bus;
  ASSERT_TRUE(bus.queue(empty(0x555), 1'000));
  const std::vector<Transmission> sent = all(bus);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].queued_ns, 1'000);
  EXPECT_EQ(sent[0].started_ns, 1'000);
  EXPECT_EQ(sent[0].ended_ns, 1'000 + k555_ns);
  EXPECT_EQ(sent[0].response_ns(), k555_ns);
  EXPECT_EQ(bus.busy_until_ns(), 1'000 + k555_ns);
}

TEST(Arbiter, TheLowestIdentifierWinsWhenTheBusIsFree) {
  Arbiter bus;
  for (const int identifier : {0x555, 0x080, 0x181}) ASSERT_TRUE(bus.queue(empty(identifier), 0));
  const std::vector<Transmission> sent = all(bus);
  ASSERT_EQ(sent.size(), 3U);
  EXPECT_EQ(sent[0].frame.identifier, 0x080);
  EXPECT_EQ(sent[1].frame.identifier, 0x181);
  EXPECT_EQ(sent[2].frame.identifier, 0x555);
  EXPECT_EQ(sent[1].started_ns, sent[0].ended_ns);
}

TEST(Arbiter, AFrameThatHasBegunIsNotInterrupted) {
  Arbiter bus;
  ASSERT_TRUE(bus.queue(empty(0x080), 1));
  ASSERT_TRUE(bus.queue(empty(0x555), 0));
  const std::vector<Transmission> sent = all(bus);
  EXPECT_EQ(sent[0].frame.identifier, 0x555);
  EXPECT_EQ(sent[1].started_ns, k555_ns);
  EXPECT_EQ(sent[1].response_ns(), k555_ns - 1 + k080_ns);
}

// Ready at the very instant at which the bus becomes free: it takes part in the arbitration.
TEST(Arbiter, AFrameReadyWhenTheBusBecomesFreeTakesPart) {
  Arbiter bus;
  ASSERT_TRUE(bus.queue(empty(0x100), 0));
  ASSERT_TRUE(bus.queue(empty(0x555), 0));
  const std::int64_t free_ns = all(bus, 1).front().ended_ns;
  ASSERT_TRUE(bus.queue(empty(0x080), free_ns));
  EXPECT_EQ(all(bus).front().frame.identifier, 0x080);
}

TEST(Arbiter, FramesOfOneIdentifierKeepTheirOrder) {
  Arbiter bus;
  for (std::uint8_t content = 1; content <= 3; ++content) {
    can::CanFrame frame{.identifier = 0x181, .length = 1};
    frame.payload[0] = content;
    ASSERT_TRUE(bus.queue(frame, 0));
  }
  const std::vector<Transmission> sent = all(bus);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(sent[i].frame.payload[0], i + 1);
}

TEST(Arbiter, SendsWhatStartsBeforeTheLimitAndNothingElse) {
  Arbiter bus;
  ASSERT_TRUE(bus.queue(empty(0x555), 0));
  ASSERT_TRUE(bus.queue(empty(0x556), 0));
  EXPECT_FALSE(bus.transmit_next(0));
  EXPECT_EQ(all(bus, k555_ns).size(), 1U);  // the second would start at the limit
  EXPECT_EQ(bus.waiting(), 1U);
  EXPECT_EQ(all(bus, k555_ns + 1).size(), 1U);
}

TEST(Arbiter, ANewTickMovesWhatWaitsAndWhatIsOnTheWire) {
  Arbiter bus;
  ASSERT_TRUE(bus.queue(empty(0x555), 990'000));
  ASSERT_TRUE(bus.queue(empty(0x556), 995'000));
  const auto late = bus.transmit_next(1'000'000);
  ASSERT_TRUE(late);
  EXPECT_EQ(late->ended_ns, 1'025'600);
  bus.rebase(1'000'000);
  EXPECT_EQ(bus.busy_until_ns(), 25'600);
  ASSERT_TRUE(bus.queue(empty(0x080), 0));
  const std::vector<Transmission> sent = all(bus);
  EXPECT_EQ(sent[0].frame.identifier, 0x080);
  EXPECT_EQ(sent[0].started_ns, 25'600);
  EXPECT_EQ(sent[1].queued_ns, -5'000);
  EXPECT_EQ(sent[1].response_ns(), 5'000 + sent[1].ended_ns);
}

TEST(Arbiter, RefusesWhatItHasNoRoomFor) {
  Arbiter bus;
  for (std::size_t i = 0; i < Arbiter::kCapacity; ++i) ASSERT_TRUE(bus.queue(empty(0x555), 0));
  EXPECT_FALSE(bus.queue(empty(0x080), 0));
  EXPECT_EQ(all(bus).size(), Arbiter::kCapacity);
  EXPECT_TRUE(bus.queue(empty(0x080), 0));
}

TEST(Arbiter, UsesItsBitTimes) {
  Arbiter bus({.nominal_bit_ns = 2000, .data_bit_ns = 500});
  ASSERT_TRUE(bus.queue(empty(0x555), 0));
  EXPECT_EQ(all(bus).front().ended_ns, 29 * 2000 + 33 * 500);
}

}  // namespace
}  // namespace surefoot::sim_hw
