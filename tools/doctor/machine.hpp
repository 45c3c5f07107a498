#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::doctor {

/// Text of a small file of /proc or /sys without the last line's end; empty when it cannot be read.
[[nodiscard]] std::string text_of(const std::filesystem::path&);

/// A program of PATH, or of the folders of system programs that an ordinary user's PATH lacks.
[[nodiscard]] bool has_program(const std::string& name);

/// The Surefoot tree around the current folder, else around this program.
[[nodiscard]] std::optional<std::filesystem::path> find_tree();

/// CAN interfaces of any kind.
[[nodiscard]] std::vector<std::string> can_interfaces();

/// An interface that is up and has its multicast flag.
[[nodiscard]] bool carries_multicast(const std::string& interface);

/// @return errno of opening a raw CAN socket; 0: it was opened, and closed again
[[nodiscard]] int try_can_socket();

/// A module among those of one or more kernels, compressed or not.
/// @param folder  e.g. /lib/modules/6.1.0-25-amd64
[[nodiscard]] bool has_kernel_module(const std::filesystem::path& folder, const std::string& name);

/// Text of each processor's scaling_governor.
[[nodiscard]] std::vector<std::string> governors();

/// Resolution of CLOCK_MONOTONIC.
[[nodiscard]] std::int64_t timer_resolution_ns();

/// What `uname` says of the kernel.
struct Kernel {
  std::string release;  ///< -r
  std::string version;  ///< -v
};

[[nodiscard]] Kernel running_kernel();

}  // namespace surefoot::doctor
