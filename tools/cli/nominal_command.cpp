#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/floor/nominal_recorder.hpp"

namespace surefoot::cli {

void add_nominal(CLI::App& app, run::ExitCode& result) {
  auto step_length_m = std::make_shared<double>(0.0);
  auto overrides = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "nominal", "Records what flat walking measures over a step: what the floor walk's controllers compare with.");
  command->add_option("--step-length", *step_length_m, "in metres; 0 walks on the spot")
      ->check(CLI::Range(0.0, 0.3))
      ->capture_default_str();
  command->add_option("--set", *overrides, "Override one key, e.g. pattern.sway_profile=sine; repeatable");
  command->footer(
      "Prints the table as firmware/core/stabilizer/nominal_*.inc hold it. After a change of the robot or its "
      "pattern:\n"
      "  tools/surefoot nominal > firmware/core/stabilizer/nominal_on_the_spot.inc\n"
      "  tools/surefoot nominal --step-length 0.2 > firmware/core/stabilizer/nominal_forward.inc\n"
      "and with --set pattern.sway_profile=pendulum nominal_on_the_spot_pendulum.inc, nominal_forward_pendulum.inc.");
  command->callback([step_length_m, overrides, &result] {
    result = with_error_messages([&] {
      fmt::print("{}", floor::to_source(floor::record_nominal(*step_length_m, *overrides)));
      return run::ExitCode::kVerdictHolds;
    });
  });
}

}  // namespace surefoot::cli
