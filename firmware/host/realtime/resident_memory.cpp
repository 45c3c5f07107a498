#include "firmware/host/realtime/resident_memory.hpp"

#include <fmt/format.h>
#include <linux/capability.h>
#include <malloc.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

namespace surefoot::host {
namespace {

constexpr std::size_t kPageBytes = 4096;
constexpr std::size_t kStackLeftBytes = std::size_t{64} << 10;  // for the calls that follow

bool may_lock_without_limit() noexcept {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  if (limit.rlim_cur == RLIM_INFINITY) return true;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> capabilities{};
  if (syscall(SYS_capget, &header, capabilities.data()) != 0) return false;
  return (capabilities[CAP_TO_INDEX(CAP_IPC_LOCK)].effective & CAP_TO_MASK(CAP_IPC_LOCK)) != 0;
}

std::optional<MissingRight> lock_all_memory() {
  const bool is_unlimited = may_lock_without_limit();
  // MCL_FUTURE under a limit turns a later malloc or thread into a failure: locked is then what is here now.
  const int error_number = mlockall(is_unlimited ? MCL_CURRENT | MCL_FUTURE : MCL_CURRENT) == 0 ? 0 : errno;
  if (error_number == 0 && is_unlimited) return std::nullopt;
  const std::string why = error_number != 0 ? std::generic_category().message(error_number)
                                            : "the limit of locked memory (ulimit -l) is finite, so that only what is "
                                              "mapped now is locked";
  return MissingRight{"all memory locked (mlockall)", why,
                      fmt::format("{}; or ulimit -l unlimited ('memlock unlimited' in /etc/security/limits.conf, "
                                  "LimitMEMLOCK=infinity of systemd)",
                                  grant_capabilities_command())};
}

/// Bytes between here and the end of the calling thread's stack.
std::size_t stack_left_bytes() noexcept {
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  void* lowest = nullptr;
  std::size_t size = 0;
  pthread_attr_getstack(&attributes, &lowest, &size);
  pthread_attr_destroy(&attributes);
  const auto* here = static_cast<const char*>(__builtin_frame_address(0));
  return static_cast<std::size_t>(here - static_cast<const char*>(lowest));
}

void touch(volatile char* memory, std::size_t bytes) noexcept {
  for (std::size_t i = 0; i < bytes; i += kPageBytes) memory[i] = 0;
}

/// The stack below the loop: a page that a deep call touches for the first time is a page fault in the loop.
[[gnu::noinline]] void touch_stack(std::size_t bytes) noexcept {
  touch(static_cast<volatile char*>(__builtin_alloca(bytes)), bytes);
}

std::optional<MissingRight> prefault_stack(std::size_t bytes) {
  const std::size_t left_bytes = stack_left_bytes();
  const std::size_t possible_bytes = left_bytes > kStackLeftBytes ? left_bytes - kStackLeftBytes : 0;
  if (const std::size_t touched_bytes = std::min(bytes, possible_bytes); touched_bytes > 0) touch_stack(touched_bytes);
  if (bytes <= possible_bytes) return std::nullopt;
  return MissingRight{fmt::format("{} bytes of stack touched beforehand", bytes),
                      fmt::format("the thread's stack has {} left", possible_bytes),
                      fmt::format("ulimit -s {}", (bytes + (std::size_t{1} << 20)) >> 10)};
}

void keep_heap(std::size_t reserve_bytes) noexcept {
  // A sanitizer's allocator refuses both; then there is nothing to keep, and page faults are counted anyway.
  mallopt(M_TRIM_THRESHOLD, -1);  // what is freed stays with the process: no page fault at its next use
  mallopt(M_MMAP_MAX, 0);         // large blocks too come from the heap, instead of mapping fresh pages each time
  if (reserve_bytes == 0) return;
  auto* reserve = static_cast<char*>(std::malloc(reserve_bytes));
  if (reserve == nullptr) return;  // the reserve is a wish; who needs the memory will say so
  touch(reserve, reserve_bytes);
  std::free(reserve);
}

}  // namespace

MissingRights make_resident(const ResidentMemory& wanted) {
  MissingRights missing;
  keep_heap(wanted.heap_reserve_bytes);
  // Pages that are not locked can be taken back, and a fault that fetches one costs microseconds to milliseconds.
  if (wanted.lock_all) {
    if (auto right = lock_all_memory()) missing.push_back(std::move(*right));
  }
  if (wanted.stack_prefault_bytes > 0) {
    if (auto right = prefault_stack(wanted.stack_prefault_bytes)) missing.push_back(std::move(*right));
  }
  return missing;
}

}  // namespace surefoot::host
