#include "tools/doctor/bus_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <system_error>

namespace surefoot::doctor {
namespace {

constexpr const char* kInGuest = "tools/with-vcan COMMAND, which runs it where CAN is";

}  // namespace

Finding judge_can_sockets(int error_number, bool has_module) {
  if (error_number == 0) return ok("the kernel has them");
  const std::string why = std::generic_category().message(error_number);
  if (error_number == EAFNOSUPPORT || error_number == EPROTONOSUPPORT) {
    return missing(fmt::format("this kernel has no CAN ({})", why), has_module ? "sudo modprobe can-raw" : kInGuest);
  }
  return missing(fmt::format("the kernel refuses one ({})", why), kInGuest);
}

Finding judge_vcan(const std::vector<std::string>& interfaces, const Outcome& creation, bool has_module) {
  if (!interfaces.empty()) return ok(fmt::format("there is {}", fmt::join(interfaces, ", ")));
  if (creation.is_success()) return ok("this kernel can make them, in a network of their own");
  // A kernel without the type, or a user without the right to find out.
  if (creation.output.find("nknown device type") != std::string::npos ||
      creation.output.find("not supported") != std::string::npos) {
    return missing("this kernel has no such type of interface", has_module ? "sudo modprobe vcan" : kInGuest);
  }
  return missing(fmt::format("cannot be made by this user ({})", creation.output),
                 "sudo sh -c 'ip link add vcan0 type vcan && ip link set vcan0 mtu 72 up'; or tools/with-vcan COMMAND");
}

Finding judge_can_utils(const std::vector<std::string>& absent) {
  if (absent.empty()) return ok("candump, cansend, canplayer, canbusload");
  return missing(fmt::format("there is no {}", fmt::join(absent, ", ")), "sudo apt-get install -y can-utils");
}

Finding judge_user_mode_linux(const UserModeLinux& found) {
  if (!found.has_program || !found.has_vcan_module) {
    return missing(found.has_program ? "its modules have no vcan" : "there is no linux.uml",
                   "sudo apt-get install -y user-mode-linux kmod");
  }
  if (!found.has_insmod) return missing("there is no insmod for its modules", "sudo apt-get install -y kmod");
  return ok("linux.uml with vcan");
}

Finding judge_time_travel(const std::optional<std::string>& program) {
  if (program) return ok(*program);
  return missing("not built: no byte-identical logs of free-running programs", "tools/build-uml (5 minutes, once)");
}

Finding judge_with_vcan(bool has_script, const Finding& vcan, const Finding& user_mode_linux) {
  if (!has_script) return missing("not in this folder's tree", "cd to the folder of Surefoot's README.md");
  if (vcan.status == Status::kOk) return ok("runs commands on this kernel's vcan");
  if (user_mode_linux.status == Status::kOk) return ok("runs commands in User Mode Linux, where vcan is");
  return missing("finds neither a vcan nor User Mode Linux: it would skip", user_mode_linux.remedy);
}

}  // namespace surefoot::doctor
