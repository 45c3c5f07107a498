#include "tools/doctor/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

namespace surefoot::doctor {
namespace {

struct PurposeName {
  Purpose purpose;
  const char* key;
  const char* title;
};

constexpr std::array kPurposes{
    PurposeName{Purpose::kLockstepRun, "lockstep", "Required for surefoot run"},
    PurposeName{Purpose::kTwoPrograms, "can", "Optional: firmware and robot as two programs on a CAN bus"},
    PurposeName{Purpose::kTelemetry, "telemetry", "Optional: live telemetry, and CAN over UDP"},
    PurposeName{Purpose::kWallClock, "wall_clock", "Optional: the loop on the wall clock, every millisecond"},
    PurposeName{Purpose::kPictures, "pictures", "Optional: pictures and log readers"},
};

const char* key_of(Purpose purpose) { return kPurposes.at(static_cast<std::size_t>(purpose)).key; }

const char* key_of(Status status) {
  constexpr std::array kKeys{"ok", "warning", "missing"};
  return kKeys.at(static_cast<std::size_t>(status));
}

const char* word_of(Status status) {
  constexpr std::array kWords{"OK", "WARN", "MISSING"};
  return kWords.at(static_cast<std::size_t>(status));
}

std::string summary(const Checks& checks) {
  const auto count = [&](bool required, Status status) {
    return std::count_if(checks.begin(), checks.end(), [&](const Check& check) {
      return is_required(check) == required && check.finding.status == status;
    });
  };
  const auto lacking = count(true, Status::kMissing);
  return fmt::format("{}; optional: {} missing, {} to improve\n",
                     lacking == 0 ? std::string("What surefoot run needs is here")
                                  : fmt::format("surefoot run lacks {} of what it needs", lacking),
                     count(false, Status::kMissing), count(false, Status::kWarning));
}

}  // namespace

std::string to_text(const Checks& checks) {
  std::size_t widest = 0;
  for (const Check& check : checks) widest = std::max(widest, check.name.size());
  std::string text;
  for (const PurposeName& purpose : kPurposes) {
    bool has_title = false;
    for (const Check& check : checks) {
      if (check.purpose != purpose.purpose) continue;
      if (!has_title) text += fmt::format("{}\n", purpose.title);
      has_title = true;
      const Finding& finding = check.finding;
      text += fmt::format("  {:<7}  {:<{}}  {}\n", word_of(finding.status), check.name, widest, finding.detail);
      if (finding.status != Status::kOk) text += fmt::format("           remedy: {}\n", finding.remedy);
    }
  }
  return text + summary(checks);
}

std::string to_json(const Checks& checks) {
  nlohmann::ordered_json array = nlohmann::ordered_json::array();
  for (const Check& check : checks) {
    array.push_back({{"check", check.name},
                     {"purpose", key_of(check.purpose)},
                     {"required", is_required(check)},
                     {"status", key_of(check.finding.status)},
                     {"detail", check.finding.detail},
                     {"remedy", check.finding.remedy}});
  }
  // What other programs said may be in any encoding.
  return array.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

run::ExitCode exit_code_of(const Checks& checks) {
  const bool is_lacking = std::any_of(checks.begin(), checks.end(), [](const Check& check) {
    return is_required(check) && check.finding.status == Status::kMissing;
  });
  return is_lacking ? run::ExitCode::kMachineLacks : run::ExitCode::kVerdictHolds;
}

}  // namespace surefoot::doctor
