#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace surefoot::doctor {

enum class Status : std::uint8_t {
  kOk,
  kWarning,  ///< works, but not as well as it could
  kMissing,  ///< what the check is about does not work
};

/// What a check is for. Only the first is required; without the others Surefoot still walks.
enum class Purpose : std::uint8_t {
  kLockstepRun,  ///< `surefoot run`, the lockstep job
  kTwoPrograms,  ///< firmware and robot as two programs on a CAN bus
  kTelemetry,    ///< LCM and UDP on this machine
  kWallClock,    ///< a loop of 1 ms in real time
  kPictures,     ///< plots and lcm-spy
};

/// What was found, in words for people.
struct Finding {
  Status status;
  std::string detail;
  std::string remedy;  ///< begins with a command; empty if and only if `status` is kOk
};

struct Check {
  std::string name;
  Purpose purpose;
  Finding finding;
};

using Checks = std::vector<Check>;

[[nodiscard]] inline Finding ok(std::string detail) { return {Status::kOk, std::move(detail), ""}; }
[[nodiscard]] inline Finding warning(std::string detail, std::string remedy) {
  return {Status::kWarning, std::move(detail), std::move(remedy)};
}
[[nodiscard]] inline Finding missing(std::string detail, std::string remedy) {
  return {Status::kMissing, std::move(detail), std::move(remedy)};
}

[[nodiscard]] inline bool is_required(const Check& check) { return check.purpose == Purpose::kLockstepRun; }

}  // namespace surefoot::doctor
