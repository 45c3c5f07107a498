#pragma once

#include <cstdint>

/// Counts what the calling thread asks of the heap. A program that links `surefoot_allocation_guard`
/// has malloc and its family replaced by counting ones over glibc's own, so that shared libraries
/// and operator new are seen as well; unarmed threads pay one test a call.
namespace surefoot::host::allocation_guard {

/// Calls between `arm` and `disarm`.
struct Counts {
  std::uint64_t allocations = 0;  ///< malloc, calloc, realloc, aligned_alloc, posix_memalign and kin, operator new
  std::uint64_t frees = 0;        ///< free of something, operator delete
};

/// False where a sanitizer owns malloc (address, thread): then counts stay zero.
[[nodiscard]] bool is_available() noexcept;

/// Starts counting for the calling thread, from zero.
void arm() noexcept;

/// Stops counting for the calling thread. @return what it did since `arm`
Counts disarm() noexcept;

}  // namespace surefoot::host::allocation_guard
