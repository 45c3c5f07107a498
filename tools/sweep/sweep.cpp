#include "tools/sweep/sweep.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "tools/scenario/field.hpp"
#include "tools/sweep/draw.hpp"
#include "tools/sweep/sweep_reader.hpp"

namespace surefoot::sweep {
namespace {

/// Room for a list of some ten thousand rows; keeps out logs and /dev/zero.
constexpr std::size_t kLargestFile = 4 * 1024 * 1024;

/// As messages of the scenario show the place of an override.
constexpr std::size_t kLongestShown = 120;

[[noreturn]] void fail(std::string place, std::string statement, std::string remedy) {
  throw scenario::ScenarioError({{std::move(place), std::move(statement), std::move(remedy)}});
}

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) fail(file.string(), "is a directory", "name a .toml file in it");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail(file.string(), "cannot be opened", "check path and permissions; examples are in tools/sweeps");
  std::string text(kLargestFile + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kLargestFile) fail(file.string(), "is larger than 4 MiB", "name the sweep, not a log");
  return text;
}

toml::table parse(const std::string& name, std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position& at = error.source().begin;
    fail(fmt::format("{}:{}:{}", name, at.line, at.column), fmt::format("is not TOML: {}", error.description()),
         "correct this line; the file must be UTF-8 text, strings in it stand in quotes");
  }
}

/// Forms the rows of a sweep.
class RowMaker {
 public:
  RowMaker(const SweepFile& file, Sweep& sweep) : file_(file), sweep_(sweep) {}

  void make(const std::string& name) {
    const std::size_t list_rows = file_.list.empty() ? 1 : file_.list.front().values.size();
    std::size_t cells = 1;
    for (const Varied& varied : file_.grid) {
      cells *= varied.values.size();
      if (cells * list_rows * file_.draws > kMaxRows) break;  // each factor is below 2^22: no overflow
    }
    if (cells * list_rows * file_.draws > kMaxRows) {
      fail(name, fmt::format("has more than {} rows", kMaxRows), "vary fewer keys, or make several sweeps");
    }
    for (std::uint64_t draw = 0; draw < file_.draws; ++draw) {
      for (std::size_t cell = 0; cell < cells; ++cell) {
        for (std::size_t row = 0; row < list_rows; ++row) add_row(draw, cell, row);
      }
    }
  }

 private:
  void add_row(std::uint64_t number, std::size_t cell, std::size_t list_row) {
    sweep_.values.emplace_back();
    sweep_.batch.trials.emplace_back();
    std::size_t remaining = cell;
    std::vector<const Value*> grid(file_.grid.size());
    for (std::size_t key = file_.grid.size(); key-- > 0;) {
      const std::vector<Value>& values = file_.grid[key].values;
      grid[key] = &values[remaining % values.size()];
      remaining /= values.size();
    }
    for (std::size_t key = 0; key < grid.size(); ++key) add(file_.grid[key].key, *grid[key]);
    for (const Varied& varied : file_.list) add(varied.key, varied.values[list_row]);
    for (const RandomKey& random : file_.random) add(random.key, {drawn(random, number), random.place});
  }

  std::string drawn(const RandomKey& random, std::uint64_t number) const {
    const std::uint64_t bits = draw(file_.draw_seed, random.key, number);
    return random.is_integer ? fmt::format("{}", uniform_integer(bits, random.min_integer, random.max_integer))
                             : scenario::toml_number(uniform(bits, random.min, random.max));
  }

  void add(const std::string& key, const Value& value) {
    const std::string text = key + "=" + value.text;
    sweep_.values.back().push_back(value.text);
    sweep_.batch.trials.back().overrides.push_back(text);
    sweep_.place_of.try_emplace("--set " + text.substr(0, kLongestShown), value.place);
  }

  const SweepFile& file_;
  Sweep& sweep_;
};

}  // namespace

Sweep load(const std::filesystem::path& file) { return load_text(file, read_text(file)); }

Sweep load_text(const std::filesystem::path& file, std::string_view text) {
  const std::string name = file.string();
  const SweepFile content = read_sweep_file(name, parse(name, text));
  Sweep sweep;
  sweep.name = file.stem().string();
  if (!content.scenario.empty()) {
    sweep.batch.scenario_file = (file.parent_path() / content.scenario).lexically_normal();
  }
  for (const Varied& set : content.set) {
    sweep.batch.common.push_back(set.key + "=" + set.values.front().text);
    sweep.place_of.try_emplace("--set " + sweep.batch.common.back().substr(0, kLongestShown), set.values.front().place);
  }
  for (const Varied& varied : content.grid) sweep.keys.push_back(varied.key);
  for (const Varied& varied : content.list) sweep.keys.push_back(varied.key);
  for (const RandomKey& random : content.random) sweep.keys.push_back(random.key);
  if (sweep.keys.empty()) fail(name, "varies nothing", "add a table [grid], [list] or [random]; see tools/sweeps");
  RowMaker(content, sweep).make(name);
  return sweep;
}

scenario::ScenarioError with_places(const Sweep& sweep, const scenario::ScenarioError& error) {
  std::vector<scenario::Problem> problems = error.problems();
  for (scenario::Problem& problem : problems) {
    const auto found = sweep.place_of.find(problem.place);
    if (found != sweep.place_of.end()) problem.place = found->second;
  }
  return scenario::ScenarioError(std::move(problems));
}

}  // namespace surefoot::sweep
