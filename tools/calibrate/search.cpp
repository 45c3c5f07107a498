#include "tools/calibrate/search.hpp"

#include <fmt/format.h>

#include <ranges>

#include "tools/table/experiment.hpp"

namespace surefoot::calibrate {
namespace {

const table::Experiment kReflexOff{"off", "thesis", {}, {}};

batch::Batch with_half_step(batch::Batch batch) {
  const scenario::Scenario scenario = table::load_common(batch);
  batch.common.push_back(fmt::format("physics.step_s={}", 0.5 * scenario.sim.physics_step_s));
  return batch;
}

std::size_t count_changed(const std::vector<table::Cell>& a, const std::vector<table::Cell>& b) {
  std::size_t changed = 0;
  for (std::size_t i = 0; i < a.size(); ++i) changed += a[i].survives != b.at(i).survives ? 1U : 0U;
  return changed;
}

/// Cells of a grid on one plant.
std::vector<table::Cell> cells_on(const table::BandAxes& plant, const table::Grid& grid, bool has_half_step,
                                  const Runner& run) {
  batch::Batch batch = table::band_batch(kReflexOff, plant, grid);
  if (has_half_step) batch = with_half_step(std::move(batch));
  const std::string what = fmt::format("friction {:g}, toe {:g} mm{}", plant.frictions[0], 1e3 * plant.toes_m[0],
                                       has_half_step ? ", half the step" : "");
  return table::band_of(kReflexOff, plant, grid, run(what, batch)).cells;
}

WholeTable whole_table(double friction, double toe_m, const Runner& run) {
  const table::BandAxes plant{{friction}, {toe_m}};
  const table::Table whole{"off", "thesis", table::thesis_grid(), cells_on(plant, table::thesis_grid(), false, run)};
  return {.friction = friction,
          .toe_m = toe_m,
          .cells = whole.cells.size(),
          .survive = table::survivors(whole.cells),
          .differing = table::compare(whole, table::thesis_table("off").value()).differing(),
          .changed_by_halving = count_changed(whole.cells, cells_on(plant, whole.grid, true, run))};
}

}  // namespace

Calibration calibrate(const Search& search, const Runner& run) {
  Calibration found;
  found.search = search;
  const table::Grid grid = search.grid();
  const table::Band band =
      table::band_of(kReflexOff, search.axes, grid, run("search", table::band_batch(kReflexOff, search.axes, grid)));
  found.plants = count_plants(band);
  found.windows = windows(found.plants);
  found.window = widest(found.windows);

  for (const double toe_m : std::views::reverse(found.window.toes_m)) {
    const table::BandAxes plant{{found.window.friction}, {toe_m}};
    found.halved.push_back({toe_m, count_changed(cells_on(plant, grid, false, run), cells_on(plant, grid, true, run))});
    if (found.halved.back().changed == 0) break;
  }
  const HalvedStep steadiest = std::ranges::min(found.halved, {}, &HalvedStep::changed);
  found.chosen = whole_table(found.window.friction, steadiest.toe_m, run);

  const scenario::Scenario preset = table::load_common(table::batch_of(kReflexOff));
  found.preset.friction = preset.sim.contact.friction;
  found.preset.toe_m = preset.firmware.geometry.sole_toe_m;
  found.preset = found.is_preset() ? found.chosen : whole_table(found.preset.friction, found.preset.toe_m, run);
  return found;
}

}  // namespace surefoot::calibrate
