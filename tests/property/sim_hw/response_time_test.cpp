// Whatever streams, phases and jitter: no frame that the arbiter sends takes longer than the analysis says; and on a
// bus with one stream, or with none above or below, the bound is reached.
#include "sim_hw/bus/response_time.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "sim_hw/bus/arbiter.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kBit_ns = 1000;
constexpr std::int64_t kRun_ns = 20'000'000;

struct Stream {
  can::CanFrame frame;
  AnalysedMessage message;
  std::int64_t phase_ns = 0;
};

struct Release {
  std::size_t stream;
  std::int64_t event_ns;
  std::int64_t queued_ns;
};

std::vector<Stream> any_streams() {
  constexpr std::uint8_t kLengths[]{0, 1, 8, 16, 20, 48, 64};
  std::vector<Stream> streams(*rc::gen::inRange<std::size_t>(1, 7));
  for (std::size_t i = 0; i < streams.size(); ++i) {
    Stream& stream = streams[i];
    stream.frame.identifier = static_cast<std::uint16_t>(0x80 + 16 * i);
    stream.frame.length = kLengths[*rc::gen::inRange<std::size_t>(0, std::size(kLengths))];
    stream.frame.payload.fill(*rc::gen::elementOf(std::vector<std::uint8_t>{0x00, 0x55, 0xFF}));
    stream.message = {.identifier = stream.frame.identifier,
                      .transmission_ns = static_cast<std::int64_t>(duration_ns(frame_bits(stream.frame))),
                      .period_ns = *rc::gen::inRange<std::int64_t>(150'000, 1'500'000),
                      .jitter_ns = *rc::gen::element<std::int64_t>(0, 50'000, 400'000)};
    stream.phase_ns = *rc::gen::element<std::int64_t>(0, *rc::gen::inRange<std::int64_t>(0, 1'000'000));
  }
  return streams;
}

/// Events of each stream a period or more apart, each frame queued up to the stream's jitter after its event.
std::vector<Release> any_releases(const std::vector<Stream>& streams) {
  std::vector<Release> releases;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const AnalysedMessage& message = streams[i].message;
    std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();
    for (std::int64_t event_ns = streams[i].phase_ns; event_ns < kRun_ns; event_ns += message.period_ns) {
      const std::int64_t jitter_ns =
          message.jitter_ns == 0 ? 0 : *rc::gen::element<std::int64_t>(0, message.jitter_ns, message.jitter_ns / 3);
      last_ns = std::max(last_ns, event_ns + jitter_ns);  // a node sends its frames in their order
      releases.push_back({i, event_ns, last_ns});
    }
  }
  return releases;
}

}  // namespace

RC_GTEST_PROP(ResponseTimes, AreNeverPassedOnTheBus, ()) {
  const std::vector<Stream> streams = any_streams();
  std::vector<AnalysedMessage> messages;
  for (const Stream& stream : streams) messages.push_back(stream.message);
  const auto bounds = response_times(messages, kBit_ns);

  std::vector<Release> releases = any_releases(streams);
  std::ranges::stable_sort(releases, {}, &Release::queued_ns);
  std::vector<std::vector<Release>> waiting(streams.size());
  std::vector<std::size_t> sent_of(streams.size(), 0);
  for (const Release& release : releases) waiting[release.stream].push_back(release);

  Arbiter bus;
  const auto check = [&](const Transmission& sent) {
    const auto stream = static_cast<std::size_t>((sent.frame.identifier - 0x80) / 16);
    const Release& release = waiting[stream][sent_of[stream]++];
    RC_ASSERT(release.queued_ns == sent.queued_ns);
    if (bounds[stream]) RC_ASSERT(sent.ended_ns - release.event_ns <= bounds[stream]->worst_ns);
  };
  for (const Release& release : releases) {
    while (const auto sent = bus.transmit_next(release.queued_ns)) check(*sent);
    if (!bus.queue(streams[release.stream].frame, release.queued_ns)) return;  // an overloaded bus; all was checked
  }
  while (const auto sent = bus.transmit_next(std::numeric_limits<std::int64_t>::max())) check(*sent);
}

// All ready at one instant, just after the longest frame below has begun: the first instance needs its bound, when
// that is the worst.
RC_GTEST_PROP(ResponseTimes, AreReachedAtTheCriticalInstant, ()) {
  std::vector<Stream> streams = any_streams();
  std::vector<AnalysedMessage> messages;
  for (Stream& stream : streams) {
    stream.message.period_ns = 50'000'000;  // once
    stream.message.jitter_ns = 0;
    messages.push_back(stream.message);
  }
  const auto bounds = response_times(messages, kBit_ns);
  const std::size_t studied = *rc::gen::inRange<std::size_t>(0, streams.size());
  Arbiter bus;
  const auto longest = std::max_element(
      streams.begin() + static_cast<std::ptrdiff_t>(studied) + 1, streams.end(),
      [](const Stream& a, const Stream& b) { return a.message.transmission_ns < b.message.transmission_ns; });
  const bool is_blocked = longest != streams.end();
  if (is_blocked) RC_ASSERT(bus.queue(longest->frame, 0));
  for (std::size_t i = 0; i <= studied; ++i) RC_ASSERT(bus.queue(streams[i].frame, is_blocked ? 1 : 0));
  std::int64_t response_ns = 0;
  while (const auto sent = bus.transmit_next(std::numeric_limits<std::int64_t>::max())) {
    if (sent->frame.identifier == streams[studied].frame.identifier) response_ns = sent->response_ns();
  }
  RC_ASSERT(response_ns == bounds[studied]->worst_ns - (is_blocked ? 1 : 0));
}

}  // namespace surefoot::sim_hw
