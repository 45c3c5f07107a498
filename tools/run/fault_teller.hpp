#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "firmware/host/loop/firmware_loop.hpp"

namespace surefoot::run {

/// Tells people of a fault within 0.1 s of its latching, while the loop goes on in its safe state. The
/// loop's thread only stores a number; the words come from a thread of this object's own.
class FaultTeller {
 public:
  /// @param say  may be empty. To be made before the caller's thread turns real-time: the own one would
  ///             inherit that.
  explicit FaultTeller(std::function<void(const std::string&)> say);

  /// The fault that stands latched after a tick, or none. Does not block or allocate.
  void on_tick(safety::Fault fault) noexcept;

  /// Says what has not been said yet; each fault is told once.
  void tell();

 private:
  std::function<void(const std::string&)> say_;
  safety::Fault latched_ = safety::Fault::kNone;  ///< known to the loop's thread alone
  std::atomic<safety::Fault> untold_{safety::Fault::kNone};
  std::jthread thread_;  ///< last: it ends before what it uses
};

}  // namespace surefoot::run
