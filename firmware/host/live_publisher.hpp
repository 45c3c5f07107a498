#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "firmware/host/telemetry_ring.hpp"

struct _lcm_t;

namespace surefoot::host {

/// Tells listeners on this machine what happens now, over LCM. Loss is normal: nobody waits.
class LivePublisher {
 public:
  /// UDP multicast that does not leave the machine.
  static constexpr const char* kLocalProvider = "udpm://239.255.76.67:7667?ttl=0";

  /// @param provider  LCM URL
  /// @throws std::runtime_error naming the provider
  explicit LivePublisher(const std::string& provider);

  /// Does not allocate; about 3 us.
  void publish(Channel channel, const std::byte* encoded, std::size_t size) noexcept;

  /// Messages that LCM could not send.
  [[nodiscard]] std::uint64_t failures() const noexcept { return failures_; }

 private:
  std::unique_ptr<_lcm_t, void (*)(_lcm_t*)> lcm_;
  std::uint64_t failures_ = 0;
};

}  // namespace surefoot::host
