#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"

namespace surefoot::floor {

/// The floors that Kim, Park, Oh 2007 walk on: four on the spot (Figs 23 and 24), and a room crossed in steps of
/// 20 cm (Fig. 26).
enum class FloorCase : std::uint8_t {
  kFlat,
  kLocal,   ///< tiles of 30 x 30 mm up to 4 mm high: about +-2 degrees under a sole
  kGlobal,  ///< a slope, in roll and in pitch
  kBoth,    ///< tiles on the slope
  kRoom,    ///< 20 cm steps on tiles of 2, 3 or 4 mm, plates of 120 x 120 x 4 mm and a slope of 1 degree
};

inline constexpr std::array kFloorCases{FloorCase::kFlat, FloorCase::kLocal, FloorCase::kGlobal, FloorCase::kBoth,
                                        FloorCase::kRoom};

/// Name as in tables, e.g. "global".
[[nodiscard]] const char* name(FloorCase floor) noexcept;

/// Whether another seed makes another floor.
[[nodiscard]] bool has_seeds(FloorCase floor) noexcept;

/// Slope in roll and in pitch of a case, degrees: `slope_deg` where the case has one; 1 in the room.
[[nodiscard]] double slope_of(FloorCase floor, double slope_deg) noexcept;

/// How long the room is walked, s: enough for 10 m, 52.6 steps of 0.2 m and 0.95 s each.
inline constexpr double kRoomWalk_s = 55.0;

/// What a case sets, "key=value" each: pattern, floor and `duration_s`; every key that another case sets is there too.
/// In the room height of the tiles and signs of the slope follow from the seed, so that twelve seeds in a row meet all
/// of them.
///
/// @param slope_deg   of the cases with a slope but the room
/// @param duration_s  of the walks on the spot
[[nodiscard]] std::vector<std::string> overrides_of(FloorCase floor, double slope_deg, std::uint64_t seed,
                                                    double duration_s);

/// Runs of KHR-2 without load or limits, still without trials; the walk alone is judged.
///
/// @param scenario_file  empty: the main job, whose load is taken away
/// @param overrides      "key=value", as given to `--set`; those of the cases win over them
[[nodiscard]] batch::Batch base_of(const std::filesystem::path& scenario_file,
                                   const std::vector<std::string>& overrides);

}  // namespace surefoot::floor
