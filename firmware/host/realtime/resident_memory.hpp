#pragma once

#include <cstddef>

#include "firmware/host/realtime/missing_right.hpp"

namespace surefoot::host {

/// What of the memory shall never be fetched while the loop runs.
struct ResidentMemory {
  bool lock_all = true;                                       ///< everything now mapped, and what is mapped later
  std::size_t stack_prefault_bytes = std::size_t{256} << 10;  ///< of the calling thread; 0: none
  std::size_t heap_reserve_bytes = 0;  ///< touched and given back to the allocator, which then keeps it
};

/// Makes the process' memory resident and the calling thread's stack touched. Once, before the loop,
/// by the thread that runs it. Never throws for what the machine refuses.
[[nodiscard]] MissingRights make_resident(const ResidentMemory&);

}  // namespace surefoot::host
