#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/floor/summary.hpp"

namespace surefoot::floor {

/// What each controller is worth: each alone, and a set without each of its own, all on tiles on a slope.
struct AblationSpec {
  std::string set;  ///< "paper" or "extended"
  std::vector<std::uint64_t> seeds;
  double slope_deg = 3.0;
  double duration_s = 10.0;
};

/// One choice of controllers.
struct AblationRow {
  std::string what;                    ///< "off", "damping alone", "paper", "paper without damping"
  std::vector<std::string> overrides;  ///< that choose them
  Summary summary;
};

struct Ablation {
  AblationSpec spec;
  std::vector<AblationRow> rows;
};

/// None, each alone, the set, the set without each; summaries empty.
[[nodiscard]] Ablation planned(const AblationSpec& spec);

/// All runs: rows, seeds, the last one fastest.
[[nodiscard]] batch::Batch ablation_batch(const Ablation& plan, const batch::Batch& base);

/// @param verdicts  of the batch above
[[nodiscard]] Ablation ablation_of(Ablation plan, const std::vector<run::Verdict>& verdicts);

[[nodiscard]] std::string ablation_text(const Ablation& ablation);
[[nodiscard]] std::string ablation_csv(const Ablation& ablation);
[[nodiscard]] std::string to_json(const Ablation& ablation);

}  // namespace surefoot::floor
