#include "firmware/host/memory_bus.hpp"

namespace surefoot::host {
namespace {

/// Frames on their way in one direction.
class FrameQueue {
 public:
  [[nodiscard]] bool is_full() const noexcept { return count_ == MemoryBus::kQueueFrames; }

  /// The queue must not be full.
  void push(const can::CanFrame& frame) noexcept {
    frames_[(first_ + count_) % MemoryBus::kQueueFrames] = frame;
    ++count_;
  }

  std::size_t pop(std::span<can::CanFrame> frames) noexcept {
    std::size_t taken = 0;
    while (taken < frames.size() && count_ > 0) {
      frames[taken++] = frames_[first_];
      first_ = (first_ + 1) % MemoryBus::kQueueFrames;
      --count_;
    }
    return taken;
  }

 private:
  std::array<can::CanFrame, MemoryBus::kQueueFrames> frames_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

class BusEnd final : public can::CanBus {
 public:
  BusEnd(FrameQueue& outgoing, FrameQueue& incoming, BusTap* tap) noexcept
      : outgoing_(outgoing), incoming_(incoming), tap_(tap) {}

  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    std::size_t taken = 0;
    while (taken < frames.size() && !outgoing_.is_full()) {
      const can::CanFrame& frame = frames[taken++];
      outgoing_.push(frame);
      if (tap_ != nullptr) tap_->on_frame(frame);
    }
    return taken;
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override { return incoming_.pop(frames); }

 private:
  FrameQueue& outgoing_;
  FrameQueue& incoming_;
  BusTap* tap_;
};

}  // namespace

struct MemoryBus::Ends {
  explicit Ends(BusTap* tap) noexcept : controller(to_robot, to_controller, tap), robot(to_controller, to_robot, tap) {}

  FrameQueue to_robot;
  FrameQueue to_controller;
  BusEnd controller;
  BusEnd robot;
};

MemoryBus::MemoryBus(BusTap* tap) : ends_(std::make_unique<Ends>(tap)) {}

MemoryBus::MemoryBus(const MemoryBus& other, BusTap* tap) : MemoryBus(tap) {
  ends_->to_robot = other.ends_->to_robot;
  ends_->to_controller = other.ends_->to_controller;
}

MemoryBus::~MemoryBus() = default;

can::CanBus& MemoryBus::controller_end() noexcept { return ends_->controller; }

can::CanBus& MemoryBus::robot_end() noexcept { return ends_->robot; }

}  // namespace surefoot::host
