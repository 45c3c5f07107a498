#pragma once

#include <string>

#include "tools/doctor/check.hpp"
#include "tools/run/exit_code.hpp"

namespace surefoot::doctor {

/// A table for people, grouped by purpose; below each line that is not OK the command that mends it.
[[nodiscard]] std::string to_text(const Checks&);

/// An array of {check, purpose, required, status, detail, remedy}; status is ok, warning or missing.
[[nodiscard]] std::string to_json(const Checks&);

/// @return kVerdictHolds, or kMachineLacks when something required is missing
[[nodiscard]] run::ExitCode exit_code_of(const Checks&);

}  // namespace surefoot::doctor
