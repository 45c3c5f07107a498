#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/doctor/check.hpp"
#include "tools/doctor/outcome.hpp"

namespace surefoot::doctor {

/// @param error_number  of socket(PF_CAN, SOCK_RAW, CAN_RAW); 0: it was given
/// @param has_module    this kernel has can-raw as a module
[[nodiscard]] Finding judge_can_sockets(int error_number, bool has_module);

/// @param interfaces  existing CAN interfaces, e.g. vcan0 and can0
/// @param creation    of `ip link add type vcan` in a network namespace
/// @param has_module  this kernel has vcan as a module
[[nodiscard]] Finding judge_vcan(const std::vector<std::string>& interfaces, const Outcome& creation, bool has_module);

/// @param absent  of the programs of can-utils, those that are not there
[[nodiscard]] Finding judge_can_utils(const std::vector<std::string>& absent);

/// What Debian's User Mode Linux needs to give its guest a vcan.
struct UserModeLinux {
  bool has_program = false;
  bool has_vcan_module = false;  ///< below /usr/lib/uml/modules
  bool has_insmod = false;
};

[[nodiscard]] Finding judge_user_mode_linux(const UserModeLinux&);

/// @param program  of `tools/build-uml --print-path`
[[nodiscard]] Finding judge_time_travel(const std::optional<std::string>& program);

/// @param has_script  tools/with-vcan is there and can be run
[[nodiscard]] Finding judge_with_vcan(bool has_script, const Finding& vcan, const Finding& user_mode_linux);

}  // namespace surefoot::doctor
