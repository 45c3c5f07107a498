#include <fmt/format.h>

#include <memory>

#include "tools/cli/commands.hpp"
#include "tools/doctor/examine.hpp"
#include "tools/doctor/report.hpp"

namespace surefoot::cli {

void add_doctor(CLI::App& app, run::ExitCode& result) {
  auto wants_json = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand(
      "doctor", "Examine this machine: what is here, what is missing, and the command that mends it.");
  command->add_flag("--json", *wants_json, "Print an array of {check, purpose, required, status, detail, remedy}");
  command->footer(
      "Changes nothing, and sends nothing beyond this machine. Takes a second, more where something is missing.\n"
      "Exit codes: 0 what surefoot run needs is here, 64 usage, 69 it is not.\n"
      "Example:\n  surefoot doctor --json");
  command->callback([wants_json, &result] {
    const doctor::Checks checks = doctor::examine_machine();
    fmt::print("{}", *wants_json ? doctor::to_json(checks) : doctor::to_text(checks));
    result = doctor::exit_code_of(checks);
  });
}

}  // namespace surefoot::cli
