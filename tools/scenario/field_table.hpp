#pragma once

#include <string>
#include <vector>

#include "sim_hw/plant_config.hpp"
#include "tools/scenario/field.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

/// Every key of a scenario but those of the [[payload]] tables, in the order of the effective
/// scenario: keys of one table stand together, top-level keys first.
[[nodiscard]] std::vector<Field> fields(Scenario& scenario);

/// Every key of one [[payload]] table.
[[nodiscard]] std::vector<Field> fields(sim_hw::PayloadConfig& payload);

/// The key of a payload field as messages show it: "payload[0].mass_kg".
[[nodiscard]] std::string payload_key(std::size_t place, const std::string& key);

/// The scenario that a file starts from: the structs' defaults with the plant's numbers in them.
///
/// @param plant  "thesis" or "nominal"
[[nodiscard]] Scenario preset(const std::string& plant);

}  // namespace surefoot::scenario
