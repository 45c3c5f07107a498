#include <fmt/format.h>

#include <memory>

#include "tools/bench/bench.hpp"
#include "tools/cli/commands.hpp"

namespace surefoot::cli {
namespace {

struct BenchArguments {
  double seconds = 4.0;
  bool is_json = false;
};

}  // namespace

void add_bench(CLI::App& app, run::ExitCode& result) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command =
      app.add_subcommand("bench", "Measure how fast the closed loop is on one core, and where its time goes.");
  command->add_option("--seconds", arguments->seconds, "Processor time to measure for, 0.1 to 600 (default 4)")
      ->type_name("S")
      ->check(CLI::Range(0.1, 600.0));
  command->add_flag("--json", arguments->is_json, "Print JSON instead of text");
  command->footer(
      "The robot walks without a load on the bus in memory, unrecorded. Times are processor time,\n"
      "the best of several rounds, so that they hold on a busy machine too. Nothing here passes or fails.\n"
      "Exit codes: 0 measured, 64 usage.\n"
      "Examples:\n"
      "  surefoot bench\n"
      "  surefoot bench --seconds 20 --json");
  command->callback([arguments, &result] {
    const bench::Report report = bench::measure(arguments->seconds);
    fmt::print("{}", arguments->is_json ? bench::to_json(report) : bench::to_text(report));
    result = run::ExitCode::kVerdictHolds;
  });
}

}  // namespace surefoot::cli
