#include "tools/table/band.hpp"

#include <fmt/format.h>

#include <cmath>

namespace surefoot::table {
namespace {

/// Decimal digits only as far as they mean something.
double to_digits(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::round(value * scale) / scale;
}

}  // namespace

std::size_t Band::survive(std::size_t friction, std::size_t toe) const {
  const std::size_t begin = (friction * toes_m.size() + toe) * grid.size();
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < grid.size(); ++cell) {
    if (cells.at(begin + cell).survives) ++count;
  }
  return count;
}

BandAxes band_around(const scenario::Scenario& scenario) {
  BandAxes axes;
  for (const double factor : {0.8, 1.0, 1.25}) {
    axes.frictions.push_back(to_digits(factor * scenario.sim.contact.friction, 4));
  }
  for (const double change_m : {-0.004, 0.0, 0.004}) {
    axes.toes_m.push_back(to_digits(scenario.firmware.geometry.sole_toe_m + change_m, 5));
  }
  return axes;
}

batch::Batch band_batch(const Experiment& experiment, const BandAxes& axes, const Grid& grid) {
  batch::Batch batch = batch_of(experiment);
  const double judged_s = seconds_to_judge(load_common(batch));
  for (const double friction : axes.frictions) {
    for (const double toe_m : axes.toes_m) {
      for (const Load& load : loads_of(grid)) {
        batch::Trial trial = trial_of(load, judged_s);
        trial.overrides.push_back(fmt::format("floor.friction={}", friction));
        trial.overrides.push_back(fmt::format("geometry.sole_toe_m={}", toe_m));
        batch.trials.push_back(std::move(trial));
      }
    }
  }
  return batch;
}

Band band_of(const Experiment& experiment, const BandAxes& axes, const Grid& grid,
             const std::vector<run::Verdict>& verdicts) {
  Band band{experiment.method, experiment.plant, axes.frictions, axes.toes_m, grid, {}};
  const std::vector<Load> loads = loads_of(grid);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    band.cells.push_back(cell_of(verdicts[i], loads.at(i % loads.size()).at_s));
  }
  return band;
}

std::string band_text(const Band& band) {
  std::string text = fmt::format("  survivors of {} cells\n  friction   toe, mm", band.grid.size());
  std::string head;
  for (const double toe_m : band.toes_m) head += fmt::format(" {:>7.5g}", 1e3 * toe_m);
  text += head + "\n";
  for (std::size_t friction = 0; friction < band.frictions.size(); ++friction) {
    text += fmt::format("  {:>8.4g}          ", band.frictions[friction]);
    for (std::size_t toe = 0; toe < band.toes_m.size(); ++toe) {
      text += fmt::format(" {:>7}", band.survive(friction, toe));
    }
    text += "\n";
  }
  return text;
}

std::string band_csv(const Band& band) {
  std::string text = "friction,toe_m,survive,of\n";
  for (std::size_t friction = 0; friction < band.frictions.size(); ++friction) {
    for (std::size_t toe = 0; toe < band.toes_m.size(); ++toe) {
      text += fmt::format("{},{},{},{}\n", band.frictions[friction], band.toes_m[toe], band.survive(friction, toe),
                          band.grid.size());
    }
  }
  return text;
}

}  // namespace surefoot::table
