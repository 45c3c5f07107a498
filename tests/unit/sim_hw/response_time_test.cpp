#include "sim_hw/bus/response_time.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kBit_ns = 8'000;  // 125 kbit/s: 125 bits take 1 ms

// Davis, Burns, Bril, Lukkien 2007, the example that refutes the analysis of 1994: three messages of 125 bits on a
// bus of 125 kbit/s, periods 2.5, 3.5 and 3.5 ms, 97 % of the bus. The first instances take 2, 3 and 3 ms, and the
// old analysis stops there; the second instance of C takes 3.5 ms, beyond its deadline of 3.25 ms.
constexpr std::array kRefutation{AnalysedMessage{.identifier = 1, .transmission_ns = kMs, .period_ns = 2'500'000},
                                 AnalysedMessage{.identifier = 2, .transmission_ns = kMs, .period_ns = 3'500'000},
                                 AnalysedMessage{.identifier = 3, .transmission_ns = kMs, .period_ns = 3'500'000}};

TEST(ResponseTimes, TheSecondInstanceOfTheLowestPriorityIsTheWorstOne) {
  const auto responses = response_times(kRefutation, kBit_ns);
  ASSERT_TRUE(responses[0] && responses[1] && responses[2]);
  EXPECT_EQ(responses[0]->worst_ns, 2 * kMs);
  EXPECT_EQ(responses[1]->worst_ns, 3 * kMs);
  EXPECT_EQ(responses[2]->worst_ns, 3'500'000);
  EXPECT_EQ(responses[2]->worst_instance, 1);
  EXPECT_EQ(responses[2]->instances, 2);
  EXPECT_EQ(responses[2]->busy_period_ns, 7 * kMs);
  EXPECT_EQ(responses[0]->blocking_ns, kMs);
  EXPECT_EQ(responses[2]->blocking_ns, 0);
}

// Priority is the identifier's, not the place in the list.
TEST(ResponseTimes, DoNotDependOnTheOrderOfTheList) {
  const std::array shuffled{kRefutation[2], kRefutation[0], kRefutation[1]};
  const auto responses = response_times(shuffled, kBit_ns);
  EXPECT_EQ(responses[0]->worst_ns, 3'500'000);
  EXPECT_EQ(responses[1]->worst_ns, 2 * kMs);
  EXPECT_EQ(responses[2]->worst_ns, 3 * kMs);
}

// By hand: B waits for A once (3 ms < 10 ms) and adds its own jitter; a second A comes into play only when A's
// jitter of 8.5 ms lets it follow the first within B's wait of 2 ms.
TEST(ResponseTimes, JitterOfItsOwnAddsAndThatOfOthersBringsMoreOfThem) {
  std::array messages{
      AnalysedMessage{.identifier = 1, .transmission_ns = 2 * kMs, .period_ns = 10 * kMs},
      AnalysedMessage{.identifier = 2, .transmission_ns = kMs, .period_ns = 20 * kMs, .jitter_ns = 500'000}};
  EXPECT_EQ(response_times(messages, 1000)[1]->worst_ns, 3'500'000);
  messages[0].jitter_ns = 8'500'000;
  EXPECT_EQ(response_times(messages, 1000)[1]->worst_ns, 5'500'000);
}

// A wait of exactly one period of the other: its next frame, ready as the bus becomes free, still wins (tau_bit).
TEST(ResponseTimes, AFrameReadyWithinOneBitOfTheStartStillWins) {
  const std::array messages{AnalysedMessage{.identifier = 1, .transmission_ns = kMs, .period_ns = 2 * kMs},
                            AnalysedMessage{.identifier = 2, .transmission_ns = kMs, .period_ns = 8 * kMs},
                            AnalysedMessage{.identifier = 3, .transmission_ns = kMs, .period_ns = 8 * kMs}};
  EXPECT_EQ(response_times(messages, 1000)[1]->worst_ns, 4 * kMs);  // blocked 1, A 1, A again 1, itself 1
}

TEST(ResponseTimes, AStreamThatNeedsMoreThanTheBusHasNoBound) {
  const std::array messages{AnalysedMessage{.identifier = 1, .transmission_ns = 6 * kMs, .period_ns = 10 * kMs},
                            AnalysedMessage{.identifier = 2, .transmission_ns = 5 * kMs, .period_ns = 10 * kMs}};
  const auto responses = response_times(messages, 1000);
  EXPECT_TRUE(responses[0]);
  EXPECT_FALSE(responses[1]);
}

TEST(ResponseTimes, RefuseImpossibleMessages) {
  const AnalysedMessage good{.identifier = 1, .transmission_ns = 1, .period_ns = 2};
  EXPECT_THROW(static_cast<void>(response_times(std::array{good, good}, 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(response_times(std::array{good}, 0)), std::invalid_argument);
  for (const AnalysedMessage& bad :
       {AnalysedMessage{.identifier = 1, .transmission_ns = 0, .period_ns = 2},
        AnalysedMessage{.identifier = 1, .transmission_ns = 1, .period_ns = 0},
        AnalysedMessage{.identifier = 1, .transmission_ns = 1, .period_ns = 2, .jitter_ns = -1}}) {
    EXPECT_THROW(static_cast<void>(response_times(std::array{bad}, 1)), std::invalid_argument);
  }
}

}  // namespace
}  // namespace surefoot::sim_hw
