#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sim_hw/plant_config.hpp"
#include "tools/scenario/field.hpp"

namespace surefoot::scenario {

struct Scenario;

/// A key whose value is an enumerator; `names` in the order of the enumerators, counted from 0.
template <typename Enum, std::size_t N>
[[nodiscard]] Field choice_field(std::string key, Enum& member, const std::array<const char*, N>& names,
                                 std::string doc) {
  Choice choice{names, [&member] { return static_cast<std::size_t>(member); },
                [&member](std::size_t place) { member = static_cast<Enum>(place); }, &member};
  return {std::move(key), std::move(choice), {}, "", std::move(doc)};
}

/// A key whose value is one of a few fixed strings.
template <std::size_t N>
[[nodiscard]] Field name_field(std::string key, std::string& member, const std::array<const char*, N>& names,
                               std::string doc) {
  Choice choice{names,
                [&member, &names] {
                  return static_cast<std::size_t>(std::find(names.begin(), names.end(), member) - names.begin());
                },
                [&member, &names](std::size_t place) { member = names.at(place); }, &member};
  return {std::move(key), std::move(choice), {}, "", std::move(doc)};
}

/// A key whose value is true or false.
[[nodiscard]] inline Field flag_field(std::string key, bool& member, std::string doc) {
  return {std::move(key), &member, {}, "", std::move(doc)};
}

/// A key whose value is a fixed number of numbers of one kind.
template <std::size_t N>
[[nodiscard]] Field array_field(std::string key, std::array<double, N>& member, Range range, std::string unit,
                                std::string doc) {
  Numbers numbers;
  for (double& element : member) numbers.push_back(&element);
  return {std::move(key), std::move(numbers), range, std::move(unit), std::move(doc)};
}

/// Parts of the table; `fields(Scenario&)` joins them.
void append_run_fields(std::vector<Field>& table, Scenario& scenario);
void append_firmware_fields(std::vector<Field>& table, Scenario& scenario);
void append_safety_fields(std::vector<Field>& table, Scenario& scenario);
void append_simulator_fields(std::vector<Field>& table, Scenario& scenario);
void append_floor_walk_fields(std::vector<Field>& table, Scenario& scenario);
/// Those of the rough floor that stand in [floor]; patches have tables of their own.
void append_terrain_fields(std::vector<Field>& table, sim_hw::TerrainConfig& terrain);

}  // namespace surefoot::scenario
