#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/floor/floor_cases.hpp"
#include "tools/floor/summary.hpp"

namespace surefoot::floor {

/// What is walked: every set of controllers on every floor with every seed.
struct FloorTableSpec {
  std::vector<std::string> sets;     ///< of stabilizer.set
  std::vector<std::uint64_t> seeds;  ///< of the tiles and plates
  double slope_deg = 3.0;            ///< with controllers
  double bare_slope_deg = 2.0;       ///< without
  double duration_s = 10.0;          ///< on the spot

  /// Slope that the cases with one have under this set.
  [[nodiscard]] double slope_under(const std::string& set) const { return set == "off" ? bare_slope_deg : slope_deg; }
};

/// Text that names no seeds; the message says what was expected.
class BadSeeds : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "1-20", "3" or "1,4,9-12": ascending, each once, at most 1000.
/// @throws BadSeeds
[[nodiscard]] std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// One set of controllers on one floor.
struct FloorRow {
  std::string set;
  FloorCase floor = FloorCase::kFlat;
  double slope_deg = 0.0;
  Summary summary;
};

struct FloorTable {
  FloorTableSpec spec;
  std::vector<FloorRow> rows;

  /// Falls under one set, on all its floors.
  [[nodiscard]] std::size_t falls(const std::string& set) const;
};

/// All runs: sets, floors, seeds, the last one fastest; a floor without seeds is walked once.
[[nodiscard]] batch::Batch table_batch(const FloorTableSpec& spec, const batch::Batch& base);

/// @param verdicts  of the batch above
[[nodiscard]] FloorTable table_of(const FloorTableSpec& spec, const std::vector<run::Verdict>& verdicts);

/// The amplitude of roll, degrees, that the paper's figure shows: without controllers at +2 (Fig. 23), with them at +3
/// (Fig. 24), in the room (Fig. 26). "" where it shows none.
[[nodiscard]] const char* printed_in_paper(const std::string& set, FloorCase floor) noexcept;

[[nodiscard]] std::string floor_text(const FloorTable& table);
[[nodiscard]] std::string floor_csv(const FloorTable& table);
[[nodiscard]] std::string to_json(const FloorTable& table);

}  // namespace surefoot::floor
