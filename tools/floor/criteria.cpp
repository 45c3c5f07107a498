#include "tools/floor/criteria.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "tools/batch/parallel_for.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::floor {
namespace {

/// A walk of an experiment, and what it came to. Each without the controller is followed by its twin with it.
struct Piece {
  std::size_t experiment = 0;
  scenario::Scenario scenario;
  bool has_fallen = false;
  std::vector<Samples> samples;  ///< of each quantity
};

std::vector<Piece> pieces_of(const std::vector<Experiment>& experiments, const batch::Batch& base) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < experiments.size(); ++i) {
    const Experiment& experiment = experiments[i];
    for (const batch::Trial& walk : experiment.walks) {
      for (const char* is_on : {"false", "true"}) {
        batch::Batch one = base;
        const auto add = [&](const std::vector<std::string>& more) {
          one.common.insert(one.common.end(), more.begin(), more.end());
        };
        add(experiment.overrides);
        add(walk.overrides);
        add({"stabilizer.set=" + experiment.set,
             fmt::format("stabilizer.{}={}", stabilizer::name(experiment.controller), is_on)});
        pieces.push_back({i, table::load_common(one), false, {}});
      }
    }
  }
  return pieces;
}

void add(Figure& figure, const Samples& samples) noexcept {
  for (const double sample : samples) {
    ++figure.samples;
    figure.mean += (sample - figure.mean) / static_cast<double>(figure.samples);
  }
}

/// One walk without the controller, and its twin.
void add(CriterionRow& row, const Samples& off, const Samples& on) noexcept {
  add(row.off, off);
  add(row.on, on);
  if (off.empty() || on.empty()) return;
  Figure off_alone;
  Figure on_alone;
  add(off_alone, off);
  add(on_alone, on);
  ++row.compared;
  row.less += on_alone.mean < off_alone.mean ? 1 : 0;
  row.more += on_alone.mean > off_alone.mean ? 1 : 0;
}

/// @param pieces  of this experiment
void append_rows(const Experiment& experiment, std::span<const Piece> pieces, std::vector<CriterionRow>& rows) {
  for (std::size_t q = 0; q < experiment.quantities.size(); ++q) {
    const Quantity& quantity = experiment.quantities[q];
    CriterionRow row{.controller = experiment.controller,
                     .set = experiment.set,
                     .floor = experiment.floor,
                     .walks = experiment.walks.size(),
                     .what = quantity.what,
                     .unit = quantity.unit,
                     .wanted = quantity.wanted,
                     .off = {},
                     .on = {},
                     .compared = 0,
                     .less = 0,
                     .more = 0};
    for (std::size_t i = 0; i < pieces.size(); i += 2) {
      const Piece& off = pieces[i];
      const Piece& on = pieces[i + 1];
      row.falls_off += off.has_fallen ? 1 : 0;
      row.falls_on += on.has_fallen ? 1 : 0;
      if (off.has_fallen || on.has_fallen) continue;
      add(row, off.samples[q], on.samples[q]);
    }
    rows.push_back(row);
  }
}

}  // namespace

const char* name(CriterionVerdict verdict) noexcept {
  constexpr std::array kNames{"holds", "does not help", "not shown", "not met", "no sample"};
  return kNames[static_cast<std::size_t>(verdict)];
}

double chance_of_luck(std::size_t less, std::size_t more) noexcept {
  const std::size_t all = less + more;
  double chance = 0.0;
  double term = std::pow(0.5, static_cast<double>(all));  // of none
  for (std::size_t count = 0; count <= all; ++count) {
    if (count >= less) chance += term;
    term *= static_cast<double>(all - count) / static_cast<double>(count + 1);
  }
  return chance;
}

std::optional<double> CriterionRow::change_percent() const noexcept {
  if (off.samples == 0 || on.samples == 0 || off.mean == 0.0 || wanted.kind == Wanted::Kind::kNear) return std::nullopt;
  return 100.0 * (on.mean - off.mean) / std::abs(off.mean);
}

CriterionVerdict CriterionRow::verdict() const noexcept {
  const bool compares = wanted.kind == Wanted::Kind::kLess || wanted.kind == Wanted::Kind::kBelow;
  if (on.samples == 0 || (compares && off.samples == 0)) return CriterionVerdict::kNoSample;
  const auto met = [](bool holds) { return holds ? CriterionVerdict::kHolds : CriterionVerdict::kNotMet; };
  switch (wanted.kind) {
    case Wanted::Kind::kLess: {
      if (change_percent().value_or(0.0) > -kClear_percent || less <= more) return CriterionVerdict::kDoesNotHelp;
      const bool may_be_luck = walks > 1 && chance_of_luck(less, more) > kLuck;
      return may_be_luck ? CriterionVerdict::kNotShown : CriterionVerdict::kHolds;
    }
    case Wanted::Kind::kNear:
      return met(std::abs(on.mean - wanted.value) <= wanted.tolerance);
    case Wanted::Kind::kAtMost:
      return met(on.mean <= wanted.value);
    case Wanted::Kind::kBelow:
      return met(change_percent().value_or(0.0) <= -wanted.value);
  }
  return CriterionVerdict::kNoSample;
}

std::size_t Criteria::missed() const noexcept {
  return static_cast<std::size_t>(std::ranges::count_if(rows, [](const CriterionRow& row) {
    const CriterionVerdict verdict = row.verdict();
    return verdict == CriterionVerdict::kNotMet ||
           (verdict == CriterionVerdict::kNoSample && row.wanted.kind != Wanted::Kind::kLess);
  }));
}

Criteria measure(const std::vector<Experiment>& experiments, const batch::Batch& base, const CriteriaOptions& options) {
  std::vector<Piece> pieces = pieces_of(experiments, base);
  std::atomic<std::size_t> done = 0;
  const bool is_whole = batch::parallel_for(pieces.size(), {options.jobs, options.stop}, [&](std::size_t i) {
    Piece& piece = pieces[i];
    const ObservedWalk walk = observe(piece.scenario);
    piece.has_fallen = walk.has_fallen;
    for (const Quantity& quantity : experiments[piece.experiment].quantities) {
      piece.samples.push_back(quantity.samples(walk));
    }
    const std::size_t count = ++done;
    if (options.on_progress) options.on_progress(count, pieces.size());
  });
  if (!is_whole) throw batch::Interrupted{done, pieces.size()};
  Criteria criteria;
  std::span<const Piece> rest = pieces;
  for (const Experiment& experiment : experiments) {
    const std::size_t count = 2 * experiment.walks.size();
    append_rows(experiment, rest.first(count), criteria.rows);
    rest = rest.subspan(count);
  }
  return criteria;
}

}  // namespace surefoot::floor
