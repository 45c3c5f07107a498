#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>

#include "tools/calibrate/search.hpp"
#include "tools/cli/batch_session.hpp"
#include "tools/cli/commands.hpp"

namespace surefoot::cli {
namespace {

struct CalibrateArguments : BatchArguments {
  bool is_fine = false;
  std::string frictions;
  std::string toes;
  std::string times;
};

run::ExitCode print_calibration(const CalibrateArguments& arguments) {
  calibrate::Search search = arguments.is_fine ? calibrate::fine_search() : calibrate::coarse_search();
  if (!arguments.frictions.empty()) search.axes.frictions = table::parse_list(arguments.frictions);
  if (!arguments.toes.empty()) search.axes.toes_m = table::parse_list(arguments.toes);
  if (!arguments.times.empty()) search.times_s = table::parse_list(arguments.times);

  std::vector<std::unique_ptr<BatchSession>> sessions;
  const calibrate::Calibration found =
      calibrate::calibrate(search, [&](const std::string& what, const batch::Batch& batch) {
        if (isatty(STDERR_FILENO) == 1) fmt::print(stderr, "{}\n", what);
        sessions.push_back(std::make_unique<BatchSession>("calibrate", arguments));
        return sessions.back()->run(batch);
      });
  deliver({[&] { return calibrate::to_text(found); }, [&] { return calibrate::to_csv(found); },
           [&] { return calibrate::to_json(found); }},
          arguments);
  for (const auto& session : sessions) session->forget();
  return run::ExitCode::kVerdictHolds;
}

}  // namespace

void add_calibrate(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Search the plant that falls without a reflex where the thesis' robot does; say how free it is.");
  command->add_flag("--fine", arguments->is_fine, "Toes 0.5 mm apart, more frictions, every instant; 15 times longer");
  command->add_option("--friction", arguments->frictions, "Frictions to try: 0.1,0.11 or FIRST:LAST:STEP");
  command->add_option("--toe", arguments->toes, "Toe lengths to try, m: as --friction");
  command->add_option("--times", arguments->times, "Instants of the load in the search, s: as --friction");
  command->add_option("--jobs", arguments->jobs, "Runs at a time (default: one for each core)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--fresh", arguments->is_fresh, "Forget what an interrupted call of the same command has finished");
  CLI::Option* csv = command->add_flag("--csv", arguments->is_csv, "Print the count of every plant as CSV");
  command->add_flag("--json", arguments->is_json, "Print JSON")->excludes(csv);
  command->footer(
      "Tried with 2.5 kg and 5 kg, between which the thesis' Table 4.1 divides; the choice then with all 288 cells, "
      "and\n"
      "again with half the physics step. About two minutes on two cores. What is fixed and why: docs/calibration.md.\n"
      "An interrupted calibration goes on where it stopped when the same command is given again.\n"
      "Exit codes: 0 done, 64 usage, 65 bad value, 69 the machine lacks something, 130 interrupted.\n"
      "Examples:\n"
      "  surefoot calibrate\n"
      "  surefoot calibrate --fine --json\n"
      "  surefoot calibrate --friction 0.11 --toe 0.116:0.126:0.0002");
  command->callback([arguments, &result] {
    result = with_batch_messages("calibrate", [&] { return print_calibration(*arguments); });
  });
}

}  // namespace surefoot::cli
