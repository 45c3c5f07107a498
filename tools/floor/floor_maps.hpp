#pragma once

#include <cstdint>
#include <vector>

#include "tools/map/map_spec.hpp"

namespace surefoot::floor {

/// Walks on the spot: slope of the floor (in roll and in pitch, 0 to 10 degrees) by height of its tiles (0 to 12 mm),
/// paper's set against the extended one; the seeds are its repeats.
[[nodiscard]] map::MapSpec rough_map(const std::vector<std::uint64_t>& seeds, double duration_s);

/// Walks on the spot: sideways pushes of 0.1 s, 0.25 m above the hips, by impulse (5 to 25 N s) and eight instants of a
/// gait cycle of 1.9 s; to the left and to the right are its repeats. The floor is that of the scenario.
[[nodiscard]] map::MapSpec push_map(double duration_s);

/// Walks on the spot on tiles on a slope of 3 degrees, extended set: a load on the chest by mass (5 to 40 kg) and eight
/// instants of a gait cycle, without and with the payload reflex; two seeds are its repeats.
/// @param duration_s  from the first of these instants on
[[nodiscard]] map::MapSpec payload_map(double duration_s);

/// Instant of the first of these pushes and loads, s; the last one is a gait cycle later.
inline constexpr double kFirstPush_s = 5.0;

}  // namespace surefoot::floor
