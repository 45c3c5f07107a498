#include "firmware/host/bus/message_batch.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>

namespace surefoot::host {
namespace {

template <typename Value>
Value value_of(const cmsghdr* control) noexcept {
  Value value;
  std::memcpy(&value, CMSG_DATA(control), sizeof value);
  return value;
}

}  // namespace

MessageBatch::MessageBatch(std::size_t capacity)
    : capacity_(capacity),
      bytes_(kMessages * capacity),
      parts_(kMessages),
      controls_(kMessages),
      sources_(kMessages),
      messages_(kMessages) {
  for (std::size_t i = 0; i < kMessages; ++i) {
    parts_[i].iov_base = buffer(i).data();
    messages_[i].msg_hdr.msg_iov = &parts_[i];
    messages_[i].msg_hdr.msg_iovlen = 1;
  }
}

std::span<std::byte> MessageBatch::buffer(std::size_t i) noexcept {
  return std::span(bytes_).subspan(i * capacity_, capacity_);
}

int MessageBatch::send(int socket, std::size_t count) noexcept {
  return ::sendmmsg(socket, messages_.data(), static_cast<unsigned>(std::min(count, kMessages)), MSG_DONTWAIT);
}

int MessageBatch::receive(int socket, std::size_t count) noexcept {
  const std::size_t asked = std::min(count, kMessages);
  for (std::size_t i = 0; i < asked; ++i) {
    parts_[i].iov_len = capacity_;
    messages_[i].msg_hdr.msg_name = &sources_[i];
    messages_[i].msg_hdr.msg_namelen = sizeof sources_[i];
    messages_[i].msg_hdr.msg_control = &controls_[i];
    messages_[i].msg_hdr.msg_controllen = sizeof controls_[i];
  }
  return ::recvmmsg(socket, messages_.data(), static_cast<unsigned>(asked), MSG_DONTWAIT, nullptr);
}

Received MessageBatch::received(std::size_t i) noexcept {
  msghdr& header = messages_[i].msg_hdr;
  Received received{.bytes = buffer(i).first(messages_[i].msg_len),
                    .is_truncated = (header.msg_flags & MSG_TRUNC) != 0};
  if (sources_[i].sin_family == AF_INET) received.udp_source_port = ntohs(sources_[i].sin_port);
  for (cmsghdr* control = CMSG_FIRSTHDR(&header); control != nullptr; control = CMSG_NXTHDR(&header, control)) {
    if (control->cmsg_level != SOL_SOCKET) continue;
    if (control->cmsg_type == SCM_TIMESTAMPNS) {
      const auto time = value_of<timespec>(control);
      received.time_ns = std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
    } else if (control->cmsg_type == SO_RXQ_OVFL) {
      received.kernel_drops = value_of<std::uint32_t>(control);
    }
  }
  return received;
}

}  // namespace surefoot::host
