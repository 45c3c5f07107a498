#include "firmware/host/allocation_guard.hpp"

#include <malloc.h>

#include <atomic>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SUREFOOT_SANITIZER_OWNS_MALLOC 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define SUREFOOT_SANITIZER_OWNS_MALLOC 1
#endif
#endif

namespace surefoot::host::allocation_guard {
namespace {

// Atomic, because the compiler takes malloc for a function that touches no other memory and would
// move plain stores across it. Initial-exec, because the first touch of a dynamic TLS block mallocs.
#define SUREFOOT_GUARD_TLS constinit thread_local __attribute__((tls_model("initial-exec")))
SUREFOOT_GUARD_TLS std::atomic<bool> is_armed{false};
SUREFOOT_GUARD_TLS std::atomic<std::uint64_t> allocations{0};
SUREFOOT_GUARD_TLS std::atomic<std::uint64_t> frees{0};
#undef SUREFOOT_GUARD_TLS

}  // namespace

bool is_available() noexcept {
#ifdef SUREFOOT_SANITIZER_OWNS_MALLOC
  return false;
#else
  return true;
#endif
}

void arm() noexcept {
  allocations = 0;
  frees = 0;
  is_armed = true;
}

Counts disarm() noexcept {
  is_armed = false;
  return {.allocations = allocations, .frees = frees};
}

#ifndef SUREFOOT_SANITIZER_OWNS_MALLOC
namespace {

void count(std::atomic<std::uint64_t>& calls) noexcept {
  if (is_armed.load(std::memory_order_relaxed)) calls.store(calls + 1, std::memory_order_relaxed);
}

}  // namespace

// glibc's own, under the names that stay reachable when malloc is replaced.
extern "C" {
void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* memory, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;
void __libc_free(void* memory) noexcept;

void* malloc(std::size_t size) noexcept {
  count(allocations);
  return __libc_malloc(size);
}

void* calloc(std::size_t items, std::size_t size) noexcept {
  count(allocations);
  return __libc_calloc(items, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  count(allocations);
  return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  count(allocations);
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  count(allocations);
  return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  count(allocations);
  if (alignment % sizeof(void*) != 0 || !std::has_single_bit(alignment)) return EINVAL;
  const int saved_errno = errno;  // POSIX: the error is returned, errno stays
  void* const block = __libc_memalign(alignment, size);
  errno = saved_errno;
  if (block == nullptr) return ENOMEM;
  *memory = block;
  return 0;
}

void free(void* memory) noexcept {
  if (memory != nullptr) count(frees);
  __libc_free(memory);
}
}  // extern "C"
#endif

}  // namespace surefoot::host::allocation_guard
