// An empty frame of identifier 0x080 has 30 nominal and 33 data bits (frame_bits_test.cpp): 36.6 us.
#include "sim_hw/bus/bus_tally.hpp"

#include <gtest/gtest.h>

namespace surefoot::sim_hw {
namespace {

Transmission sync_after(std::int64_t response_ns) {
  return {.frame = {.identifier = 0x080, .length = 0},
          .bits = {.nominal = 30, .data = 33},
          .queued_ns = 1'000,
          .started_ns = 2'000,
          .ended_ns = 1'000 + response_ns};
}

// Ten of them in one millisecond.
TEST(BusTally, LoadIsTheShareOfTheTimeThatFramesTake) {
  BusTally tally;
  for (int i = 0; i < 10; ++i) tally.add(sync_after(50'000));
  EXPECT_EQ(tally.frames(), 10U);
  EXPECT_EQ(tally.nominal_bits(), 300U);
  EXPECT_EQ(tally.data_bits(), 330U);
  EXPECT_EQ(tally.busy_ns(), 366'000U);
  EXPECT_DOUBLE_EQ(tally.load_percent(1'000'000), 36.6);
}

TEST(BusTally, LoadOfNoTimeAtAllIsZero) {
  BusTally tally;
  tally.add(sync_after(50'000));
  EXPECT_EQ(tally.load_percent(0), 0.0);
}

TEST(BusTally, LoadMayPassOneHundredPercentWhenFramesDoNotFit) {
  BusTally tally;
  for (int i = 0; i < 30; ++i) tally.add(sync_after(50'000));
  EXPECT_GT(tally.load_percent(1'000'000), 100.0);
}

TEST(BusTally, FollowsTheBitTimes) {
  BusTally tally({.nominal_bit_ns = 2000, .data_bit_ns = 500});
  tally.add(sync_after(50'000));
  EXPECT_EQ(tally.busy_ns(), 30U * 2000U + 33U * 500U);
}

TEST(BusTally, KeepsTheSlowestFrameOfEachStreamAndOnlyWeighsStrangers) {
  BusTally tally;
  for (const int response_ns : {40'000, 90'000, 50'000}) tally.add(sync_after(response_ns));
  Transmission stranger = sync_after(500'000);
  stranger.frame.identifier = 0x123;
  tally.add(stranger);
  EXPECT_EQ(tally.stream(stream_of(0x080)).frames, 3U);
  EXPECT_EQ(tally.stream(stream_of(0x080)).worst_response_ns, 90'000);
  EXPECT_EQ(tally.frames(), 4U);
}

}  // namespace
}  // namespace surefoot::sim_hw
