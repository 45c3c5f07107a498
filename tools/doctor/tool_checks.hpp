#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/doctor/check.hpp"
#include "tools/doctor/outcome.hpp"

namespace surefoot::doctor {

/// Where run folders would go.
struct RunSpace {
  std::string folder;
  bool is_writable = false;
  std::uint64_t free_bytes = 0;
};

[[nodiscard]] Finding judge_run_space(const RunSpace&);

/// @param find_modules  of a Python program that prints which of the modules are not there; 127: no environment
[[nodiscard]] Finding judge_python(const Outcome& find_modules);

/// @param version  of `java -version`; 127: there is none
[[nodiscard]] Finding judge_java(const Outcome& version);

/// @param absent_jars  of those that lcm-spy needs
/// @param java         finding on Java itself
[[nodiscard]] Finding judge_lcm_spy(const std::vector<std::string>& absent_jars, const Finding& java);

}  // namespace surefoot::doctor
