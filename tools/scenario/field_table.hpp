#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim_hw/plant_config.hpp"
#include "tools/scenario/field.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::scenario {

/// Every key of a scenario but those of the [[payload]], [[push]], [[patch]], [[fault]] and [[planned_gait]] tables, in
/// the order of the effective scenario: keys of one table stand together, top-level keys first.
[[nodiscard]] std::vector<Field> fields(Scenario& scenario);

/// Every key of one [[payload]] table.
[[nodiscard]] std::vector<Field> fields(sim_hw::PayloadConfig& payload);

/// Every key of one [[push]] table.
[[nodiscard]] std::vector<Field> fields(sim_hw::PushConfig& push);

/// Every key of one [[planned_gait]] table.
[[nodiscard]] std::vector<Field> fields(PlannedGaitConfig& config);

/// Every key of one [[patch]] table.
[[nodiscard]] std::vector<Field> fields(sim_hw::PatchConfig& patch);

/// Every key of one [[fault]] table.
[[nodiscard]] std::vector<Field> fields(sim_hw::FaultConfig& fault);

/// The key of a field in an array of tables as messages show it: "payload[0].mass_kg".
[[nodiscard]] std::string element_key(std::string_view array, std::size_t place, std::string_view key);

/// Whether a top-level key is an array of tables: "payload", "push", "patch", "fault" or "planned_gait".
[[nodiscard]] bool is_array_of_tables(std::string_view key);

}  // namespace surefoot::scenario
