#pragma once

#include <cstdint>

namespace surefoot::host {

/// What the kernel did to one thread: a loop that has all its rights shows zero page faults and zero
/// involuntary switches, and one voluntary switch for each wait.
struct ResourceUsage {
  std::int64_t minor_page_faults = 0;     ///< memory touched for the first time
  std::int64_t major_page_faults = 0;     ///< memory that had to come from a disk
  std::int64_t voluntary_switches = 0;    ///< the thread waited
  std::int64_t involuntary_switches = 0;  ///< another one took its processor

  friend bool operator==(const ResourceUsage&, const ResourceUsage&) = default;
};

/// Of the calling thread since it began (RUSAGE_THREAD). One system call, no allocation.
[[nodiscard]] ResourceUsage thread_resource_usage() noexcept;

/// @return what came between the two
[[nodiscard]] ResourceUsage operator-(const ResourceUsage& later, const ResourceUsage& earlier) noexcept;

}  // namespace surefoot::host
