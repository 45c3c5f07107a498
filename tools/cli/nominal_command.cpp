#include <fmt/format.h>

#include <memory>

#include "tools/cli/bus_options.hpp"
#include "tools/cli/commands.hpp"
#include "tools/floor/nominal_recorder.hpp"

namespace surefoot::cli {

void add_nominal(CLI::App& app, run::ExitCode& result) {
  auto step_length_m = std::make_shared<double>(0.0);
  CLI::App* command = app.add_subcommand(
      "nominal", "Records what flat walking measures over a step: what the floor walk's controllers compare with.");
  command->add_option("--step-length", *step_length_m, "in metres; 0 walks on the spot")
      ->check(CLI::Range(0.0, 0.3))
      ->capture_default_str();
  command->footer(
      "Prints the table as firmware/core/stabilizer/nominal_*.inc hold it. After a change of the robot or its "
      "pattern:\n"
      "  tools/surefoot nominal > firmware/core/stabilizer/nominal_on_the_spot.inc\n"
      "  tools/surefoot nominal --step-length 0.2 > firmware/core/stabilizer/nominal_forward.inc");
  command->callback([step_length_m, &result] {
    result = with_error_messages([&] {
      fmt::print("{}", floor::to_source(floor::record_nominal(*step_length_m)));
      return run::ExitCode::kVerdictHolds;
    });
  });
}

}  // namespace surefoot::cli
