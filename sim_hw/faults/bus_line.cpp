#include "sim_hw/faults/bus_line.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/can/messages.hpp"
#include "sim_hw/faults/frame_fault.hpp"

namespace surefoot::sim_hw {
namespace {

constexpr std::uint16_t kNodeMask = 0x07F;

can::Node sender_of(const can::CanFrame& frame) noexcept {
  return static_cast<can::Node>(frame.identifier & kNodeMask);
}

/// The leg that a command frame is for; the controller for every other frame.
can::Node addressee_of(const can::CanFrame& frame) noexcept {
  for (const Side side : kSides) {
    const can::Node node = can::leg_node(side);
    if (frame.identifier == can::command_identifier(node) || frame.identifier == can::position_identifier(node)) {
      return node;
    }
  }
  return can::Node::kController;
}

std::uint32_t whole(double value) noexcept { return static_cast<std::uint32_t>(std::lround(value)); }

}  // namespace

BusLine::BusLine(const FaultSchedule& schedule, std::uint64_t seed, AnswerWatch& answers)
    : schedule_(schedule), answers_(answers), seen_(2 * kIdentifiers) {
  const std::vector<FaultConfig>& faults = schedule.faults();
  for (std::size_t i = 0; i < faults.size(); ++i) random_.emplace_back(seed, fault_stream(faults, i));
  delayed_.reserve(kDelayedFrames);
}

void BusLine::begin_period(std::int64_t period, std::uint32_t active) noexcept {
  if (contention_) {
    const std::int64_t elapsed = std::max<std::int64_t>(period - period_, 0);
    while (const auto arrival = contention_->finish_period(elapsed)) {
      arrive(arrival->frame, arrival->is_for_nodes ? Direction::kToNodes : Direction::kToController);
    }
    contention_->begin_period(period, elapsed);
  }
  period_ = period;
  active_ = active;
  off_bus_ = schedule_.off_bus(active);
  is_link_down_ = false;
  for (std::size_t i = 0; i < random_.size(); ++i) {
    if (((active >> i) & 1U) != 0 && schedule_.faults()[i].kind == FaultKind::kLinkDown) is_link_down_ = true;
  }
  release_due();
  for (std::size_t i = 0; i < random_.size(); ++i) {
    if (((active >> i) & 1U) != 0 && schedule_.faults()[i].kind == FaultKind::kBabble) babble(i);
  }
}

void BusLine::enter(const can::CanFrame& frame) noexcept {
  pass(frame, Direction::kToNodes);
  pump();
}

std::size_t BusLine::send(std::span<const can::CanFrame> frames) noexcept {
  refused_ = 0;
  for (const can::CanFrame& frame : frames) pass(frame, Direction::kToController);
  pump();
  return frames.size() - std::min(refused_, frames.size());
}

std::size_t BusLine::receive(std::span<can::CanFrame> frames) noexcept {
  std::size_t count = 0;
  while (count < frames.size() && inbound_.pop(frames[count])) ++count;
  return count;
}

void BusLine::pass(const can::CanFrame& frame, Direction direction) noexcept {
  if (is_cut(frame, direction)) {
    ++counters_.silenced;
    return;
  }
  batch_.passing[0] = {.frame = frame};
  batch_.count = 1;
  const std::uint32_t place = ordinal(frame.identifier, direction);
  const std::uint32_t what = frame.identifier | (static_cast<std::uint32_t>(direction) << 16U);
  for (std::size_t i = 0; i < random_.size(); ++i) {
    const FaultConfig& fault = schedule_.faults()[i];
    if (((active_ >> i) & 1U) == 0 || !is_frame_fault(fault.kind)) continue;
    const can::Node node = direction == Direction::kToController ? sender_of(frame) : addressee_of(frame);
    const bool is_own =
        fault.target == FaultTarget::kBus ||
        (fault.target == FaultTarget::kController ? direction == Direction::kToNodes : node == node_of(fault.target)) ||
        (fault.kind == FaultKind::kSwap && twin_of(node) == node_of(fault.target));
    if (!is_own) continue;
    const std::uint64_t draw = random_[i].draw(period_, what, place);
    if (FaultRandom::uniform(draw) < fault.probability) befall(fault, draw);
  }
  for (std::size_t i = 0; i < batch_.count; ++i) {
    if (batch_.passing[i].delay_ticks > 0) {
      hold_back(batch_.passing[i], direction);
    } else {
      deliver(batch_.passing[i].frame, direction);
    }
  }
}

void BusLine::befall(const FaultConfig& fault, std::uint64_t draw) noexcept {
  const std::span<Passing> passing{batch_.passing.data(), batch_.count};
  switch (fault.kind) {
    case FaultKind::kDrop:
      counters_.dropped += batch_.count;
      batch_.count = 0;
      break;
    case FaultKind::kDuplicate:
      multiply(whole(fault.value));
      break;
    case FaultKind::kDelay:
      for (Passing& one : passing) one.delay_ticks += whole(fault.value);
      counters_.delayed += batch_.count;
      break;
    case FaultKind::kCorrupt:
      for (Passing& one : passing) {
        one.frame = corrupted(one.frame, whole(fault.value), draw ^ static_cast<std::uint64_t>(&one - passing.data()));
        ++counters_.corrupted;
        if (is_acceptable(one.frame)) ++counters_.corrupted_unnoticed;
      }
      break;
    case FaultKind::kSwap:
      for (Passing& one : passing) one.frame = swapped(one.frame, fault.value > 0.5);
      counters_.swapped += batch_.count;
      break;
    default:
      break;
  }
}

/// Copies stand behind their originals.
void BusLine::multiply(std::size_t copies) noexcept {
  const std::size_t originals = batch_.count;
  for (std::size_t copy = 0; copy < copies; ++copy) {
    for (std::size_t i = 0; i < originals; ++i) {
      if (batch_.count == batch_.passing.size()) {
        ++counters_.overflowed;
        continue;
      }
      batch_.passing[batch_.count++] = batch_.passing[i];
      ++counters_.duplicated;
    }
  }
}

void BusLine::deliver(const can::CanFrame& frame, Direction direction) noexcept {
  if (!contention_) {
    arrive(frame, direction);
  } else if (!contention_->queue(frame, direction == Direction::kToNodes)) {
    ++counters_.overflowed;
  }
}

/// Lets everybody's frames cross the bus as far as the tick goes.
void BusLine::pump() noexcept {
  if (!contention_) return;
  while (const auto arrival = contention_->advance()) {
    arrive(arrival->frame, arrival->is_for_nodes ? Direction::kToNodes : Direction::kToController);
  }
}

void BusLine::arrive(const can::CanFrame& frame, Direction direction) noexcept {
  if (direction == Direction::kToNodes) {
    if (!inbound_.push(frame)) ++counters_.overflowed;
  } else if (bus_ == nullptr || bus_->send({&frame, 1}) == 0) {
    ++refused_;
  } else if (is_answer(frame, answers_.tick())) {
    answers_.note({&frame, 1});
  }
}

void BusLine::hold_back(const Passing& passing, Direction direction) noexcept {
  if (delayed_.size() == kDelayedFrames) {
    ++counters_.overflowed;
    return;
  }
  delayed_.push_back({passing.frame, period_ + passing.delay_ticks, direction});
}

void BusLine::release_due() noexcept {
  std::size_t kept = 0;
  for (const Delayed& one : delayed_) {
    if (one.due_period > period_) {
      delayed_[kept++] = one;
    } else if (is_cut(one.frame, one.direction)) {
      ++counters_.silenced;
    } else {
      arrive(one.frame, one.direction);
    }
  }
  delayed_.resize(kept);
}

void BusLine::babble(std::size_t place) noexcept {
  const FaultConfig& fault = schedule_.faults()[place];
  const can::Node node = node_of(fault.target);
  if (off_bus_.has(node) || is_link_down_) return;
  const Direction direction = node == can::Node::kController ? Direction::kToNodes : Direction::kToController;
  const std::uint32_t count = whole(fault.value);
  for (std::uint32_t i = 0; i < count; ++i) {
    const can::FrameStamp stamp{.tick = answers_.tick(), .counter = babble_counter_[place]};
    const can::CanFrame frame = can::encode_emergency(node, stamp, {});
    if (!contention_) {
      arrive(frame, direction);
    } else if (!contention_->babble(frame, static_cast<double>(i) / count, direction == Direction::kToNodes)) {
      ++counters_.overflowed;
      continue;
    }
    ++babble_counter_[place];
    ++counters_.babbled;
  }
}

bool BusLine::is_cut(const can::CanFrame& frame, Direction direction) const noexcept {
  return is_link_down_ || off_bus_.has(direction == Direction::kToController ? sender_of(frame) : addressee_of(frame));
}

std::uint32_t BusLine::ordinal(std::uint16_t identifier, Direction direction) noexcept {
  const std::size_t place = (identifier % kIdentifiers) + (direction == Direction::kToNodes ? 0 : kIdentifiers);
  Count& seen = seen_[place];
  if (seen.period != period_) seen = {.period = period_};
  return seen.count++;
}

}  // namespace surefoot::sim_hw
