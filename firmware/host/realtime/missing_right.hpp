#pragma once

#include <string>
#include <vector>

namespace surefoot::host {

/// Something that the machine did not grant; the loop goes on without it.
struct MissingRight {
  std::string what;    ///< what was asked for, e.g. "SCHED_FIFO priority 80"
  std::string why;     ///< the kernel's answer
  std::string remedy;  ///< begins with the command that grants it
};

using MissingRights = std::vector<MissingRight>;

/// The command that gives this program the capabilities of a real-time loop for good.
[[nodiscard]] std::string grant_capabilities_command();

/// Two lines for each: what and why; the remedy.
[[nodiscard]] std::string to_text(const MissingRights&);

}  // namespace surefoot::host
