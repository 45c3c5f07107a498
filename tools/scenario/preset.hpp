#pragma once

#include <array>
#include <string>

#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

inline constexpr std::array kRobots{"elkahlout", "khr2"};
inline constexpr std::array kPlants{"thesis", "nominal"};
inline constexpr std::array kControllerSets{"off", "paper", "extended"};

/// What decides with which numbers a scenario begins. A name that does not exist counts as the default.
struct PresetNames {
  std::string robot = "elkahlout";
  std::string plant = "thesis";          ///< of `elkahlout`; `khr2` has one plant
  std::string controllers = "extended";  ///< stabilizer.set, of `khr2`
  std::string reflex = "original";       ///< reflex.method
  bool has_planned_gaits = false;        ///< the walk is planned: any robot walks it with KHR-2's controllers
};

/// The names that a scenario holds.
[[nodiscard]] PresetNames preset_names(const Scenario& scenario);

/// The scenario that a file starts from: the structs' defaults with the numbers of its names in them.
[[nodiscard]] Scenario preset(const PresetNames& names);

}  // namespace surefoot::scenario
