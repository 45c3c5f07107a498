#include "firmware/host/bus/bus_bundle.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

#include "firmware/can/identifiers.hpp"

namespace surefoot::host {
namespace {

constexpr std::size_t kInboxFrames = MessageBatch::kMessages;
constexpr std::uint16_t kNodeMask = 0x7F;  // CiA 301: the lower seven bits of an identifier

struct Route {
  bool first;
  bool second;
};

std::int64_t realtime_ns() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

Route route_of(std::uint16_t identifier) noexcept {
  if (identifier == can::kSyncIdentifier || identifier == can::heartbeat_identifier(can::Node::kController)) {
    return {.first = true, .second = true};
  }
  const auto node = static_cast<can::Node>(identifier & kNodeMask);
  const bool is_left = node == can::Node::kLegLeft || node == can::Node::kFootLeft;
  return {.first = !is_left, .second = is_left};
}

bool is_for_both(std::uint16_t identifier) noexcept {
  const Route route = route_of(identifier);
  return route.first && route.second;
}

}  // namespace

BusBundle::BusBundle(Members members) : members_(std::move(members)) {
  for (Inbox& inbox : inboxes_) {
    inbox.frames.resize(kInboxFrames);
    inbox.times_ns.resize(kInboxFrames);
  }
  for (auto& outbox : outboxes_) outbox.reserve(kInboxFrames);
}

std::size_t BusBundle::send(std::span<const can::CanFrame> frames) noexcept {
  std::size_t refused = 0;
  bool was_for_both = false;
  for (const can::CanFrame& frame : frames) {
    const Route route = route_of(frame.identifier);
    // SYNC ends what stood before it on either bus: both legs' torques of the last tick go out ahead of it.
    if (is_for_both(frame.identifier) && !was_for_both) refused += flush();
    was_for_both = is_for_both(frame.identifier);
    if (route.first) outboxes_[0].push_back(frame);
    if (route.second) outboxes_[1].push_back(frame);
    if (std::max(outboxes_[0].size(), outboxes_[1].size()) == kInboxFrames) refused += flush();
  }
  refused += flush();
  return frames.size() - std::min(refused, frames.size());
}

std::size_t BusBundle::flush() noexcept {
  std::size_t refused = 0;
  // The second bus first: a marker at the end of the frames, which is the first one's, then goes out last.
  for (std::size_t member = members_.size(); member-- > 0;) {
    if (outboxes_[member].empty()) continue;
    refused += outboxes_[member].size() - members_[member]->send(outboxes_[member]);
    outboxes_[member].clear();
  }
  return refused;
}

void BusBundle::refill(std::size_t member) noexcept {
  Inbox& inbox = inboxes_[member];
  const auto next = static_cast<std::ptrdiff_t>(inbox.next);
  const auto count = static_cast<std::ptrdiff_t>(inbox.count);
  std::move(inbox.frames.begin() + next, inbox.frames.begin() + count, inbox.frames.begin());
  std::move(inbox.times_ns.begin() + next, inbox.times_ns.begin() + count, inbox.times_ns.begin());
  inbox.count -= inbox.next;
  inbox.next = 0;
  const std::size_t received = members_[member]->receive(std::span(inbox.frames).subspan(inbox.count));
  std::ranges::copy(members_[member]->receive_times_ns().first(received),
                    inbox.times_ns.begin() + static_cast<std::ptrdiff_t>(inbox.count));
  inbox.count += received;
}

std::size_t BusBundle::receive(std::span<can::CanFrame> frames) noexcept {
  time_count_ = 0;
  // What came after this instant waits for the next call: of two buses that are read one after the other, the second
  // may hold a frame whose forerunner on the first came just after that was read.
  const std::int64_t until_ns = realtime_ns();
  const auto is_due = [until_ns](const Inbox& inbox) {
    if (inbox.is_empty()) return false;
    const std::int64_t came_ns = inbox.times_ns[inbox.next];
    return came_ns <= until_ns || came_ns > realtime_ns();  // later than now: the clock was set back
  };
  for (std::size_t member = 0; member < members_.size(); ++member) refill(member);
  const std::size_t wanted = std::min(frames.size(), times_ns_.size());
  while (time_count_ < wanted) {
    Inbox& first = inboxes_[0];
    Inbox& second = inboxes_[1];
    const bool from_first =
        second.is_empty() || (!first.is_empty() && first.times_ns[first.next] < second.times_ns[second.next]);
    Inbox& from = from_first ? first : second;
    if (!is_due(from)) break;
    if (!is_copy(from.frames[from.next], from_first ? 0 : 1)) {
      frames[time_count_] = from.frames[from.next];
      times_ns_[time_count_++] = from.times_ns[from.next];
    }
    ++from.next;
    if (from.is_empty() && from.count == kInboxFrames) refill(from_first ? 0 : 1);
  }
  return time_count_;
}

bool BusBundle::is_copy(const can::CanFrame& frame, std::size_t member) noexcept {
  if (!is_for_both(frame.identifier)) return false;
  Original& original = originals_[frame.identifier == can::kSyncIdentifier ? 0 : 1];
  const bool is_same = original.is_awaited && original.member != member &&
                       original.frame.identifier == frame.identifier &&
                       std::ranges::equal(original.frame.bytes(), frame.bytes());
  original = {.frame = frame, .member = member, .is_awaited = !is_same};
  return is_same;
}

bool BusBundle::wait_readable(std::int64_t deadline_monotonic_ns) noexcept {
  if (!inboxes_[0].is_empty() || !inboxes_[1].is_empty()) return true;
  const std::array<SocketBus*, 2> buses{members_[0].get(), members_[1].get()};
  return SocketBus::wait_for_any(buses, deadline_monotonic_ns);
}

BusReport BusBundle::report() const noexcept {
  BusReport sum = members_[0]->report();
  const BusReport second = members_[1]->report();
  sum.sent += second.sent;
  sum.received += second.received;
  sum.refused_no_buffer += second.refused_no_buffer;
  sum.link_down += second.link_down;
  sum.error_frames += second.error_frames;
  sum.bus_off += second.bus_off;
  sum.foreign_shape += second.foreign_shape;
  sum.queue_overflow += second.queue_overflow;
  sum.is_up = sum.is_up && second.is_up;
  return sum;
}

}  // namespace surefoot::host
