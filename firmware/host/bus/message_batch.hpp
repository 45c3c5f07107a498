#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace surefoot::host {

/// What came with a datagram.
struct Received {
  std::span<const std::byte> bytes{};
  bool is_truncated = false;                    ///< it was longer than the batch's capacity
  std::int64_t time_ns = 0;                     ///< CLOCK_REALTIME; 0 where the kernel gave none
  std::optional<std::uint32_t> kernel_drops{};  ///< running total of the socket, modulo 2^32
  std::uint16_t udp_source_port = 0;            ///< 0 where the socket is not an IPv4 one
};

/// Buffers for one `sendmmsg` or `recvmmsg`; all memory is taken at construction.
class MessageBatch {
 public:
  static constexpr std::size_t kMessages = 64;

  /// @param capacity  bytes of the longest datagram
  explicit MessageBatch(std::size_t capacity);
  MessageBatch(const MessageBatch&) = delete;
  MessageBatch& operator=(const MessageBatch&) = delete;

  /// Room for datagram `i`, to be filled before `send`.
  [[nodiscard]] std::span<std::byte> buffer(std::size_t i) noexcept;
  void set_length(std::size_t i, std::size_t bytes) noexcept { parts_[i].iov_len = bytes; }

  /// Sends the first `count` datagrams, at most kMessages. Never blocks.
  /// @return how many went, or -1 and errno
  int send(int socket, std::size_t count) noexcept;

  /// Receives at most `count` datagrams, at most kMessages. Never blocks.
  /// @return how many came, or -1 and errno
  int receive(int socket, std::size_t count) noexcept;

  /// Datagram `i` of the last `receive`.
  [[nodiscard]] Received received(std::size_t i) noexcept;

 private:
  struct alignas(cmsghdr) Control {
    std::byte bytes[CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))];
  };

  std::size_t capacity_;
  std::vector<std::byte> bytes_;
  std::vector<iovec> parts_;
  std::vector<Control> controls_;
  std::vector<sockaddr_in> sources_;
  std::vector<mmsghdr> messages_;
};

}  // namespace surefoot::host
