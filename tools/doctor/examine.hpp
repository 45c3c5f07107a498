#pragma once

#include "tools/doctor/check.hpp"

namespace surefoot::doctor {

/// Reads this machine and judges it: takes about a second, changes nothing, sends nothing beyond loopback.
[[nodiscard]] Checks examine_machine();

}  // namespace surefoot::doctor
