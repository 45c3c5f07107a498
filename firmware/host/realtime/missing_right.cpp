#include "firmware/host/realtime/missing_right.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <system_error>

namespace surefoot::host {

std::string grant_capabilities_command() {
  std::error_code unreadable;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unreadable);
  return fmt::format("sudo setcap cap_sys_nice,cap_ipc_lock=ep {}", unreadable ? "PROGRAM" : program.string());
}

std::string to_text(const MissingRights& missing) {
  std::string text;
  for (const MissingRight& right : missing) {
    fmt::format_to(std::back_inserter(text), "without {}: {}\n  remedy: {}\n", right.what, right.why, right.remedy);
  }
  return text;
}

}  // namespace surefoot::host
