#include "sim_hw/bus/arbiter.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

namespace surefoot::sim_hw {

bool Arbiter::queue(const can::CanFrame& frame, std::int64_t queued_ns) noexcept {
  if (count_ == kCapacity) return false;
  waiting_[count_++] = {frame, queued_ns, queued_++};
  return true;
}

std::optional<Transmission> Arbiter::transmit_next(std::int64_t until_ns) noexcept {
  if (count_ == 0) return std::nullopt;
  std::int64_t first_ready_ns = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 0; i < count_; ++i) first_ready_ns = std::min(first_ready_ns, waiting_[i].queued_ns);
  const std::int64_t start_ns = std::max(busy_until_ns_, first_ready_ns);
  if (start_ns >= until_ns) return std::nullopt;

  Waiting& winner = waiting_[winner_at(start_ns)];
  Transmission sent{
      .frame = winner.frame, .bits = frame_bits(winner.frame), .queued_ns = winner.queued_ns, .started_ns = start_ns};
  sent.ended_ns = start_ns + static_cast<std::int64_t>(duration_ns(sent.bits, timing_));
  busy_until_ns_ = sent.ended_ns;
  winner = waiting_[--count_];
  return sent;
}

void Arbiter::rebase(std::int64_t elapsed_ns) noexcept {
  busy_until_ns_ -= elapsed_ns;
  for (std::size_t i = 0; i < count_; ++i) waiting_[i].queued_ns -= elapsed_ns;
}

std::size_t Arbiter::winner_at(std::int64_t now_ns) const noexcept {
  const auto rank = [](const Waiting& waiting) {
    return std::tuple(waiting.frame.identifier & 0x7FF, waiting.queued_ns, waiting.order);
  };
  std::size_t best = count_;
  for (std::size_t i = 0; i < count_; ++i) {
    if (waiting_[i].queued_ns > now_ns) continue;
    if (best == count_ || rank(waiting_[i]) < rank(waiting_[best])) best = i;
  }
  return best;
}

}  // namespace surefoot::sim_hw
