#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "firmware/can/can_bus.hpp"

namespace surefoot::host {

/// Sees every frame that crosses a bus, in order; must not allocate or block.
class BusTap {
 public:
  virtual ~BusTap() = default;
  virtual void on_frame(const can::CanFrame& frame) noexcept = 0;
};

/// Two participants in one thread, no kernel: the embedded default for lockstep. What one end sends,
/// the other receives, in order; a full queue refuses (the sender's `send` returns less).
class MemoryBus {
 public:
  static constexpr std::size_t kQueueFrames = 256;

  /// @param tap  may be null; outlives the bus
  explicit MemoryBus(BusTap* tap = nullptr);
  ~MemoryBus();
  /// The same frames on their way, another tap.
  MemoryBus(const MemoryBus&, BusTap* tap);
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  [[nodiscard]] can::CanBus& controller_end() noexcept;
  [[nodiscard]] can::CanBus& robot_end() noexcept;

 private:
  struct Ends;
  std::unique_ptr<Ends> ends_;
};

}  // namespace surefoot::host
