#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/scenario/scenario.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::scenario {

/// Where each overridden key comes from: "payload[0].mass_kg" to "--set payload.0.mass_kg=5".
using OverridePlaces = std::map<std::string, std::string>;

/// A parsed file with the overrides written into it.
struct Document {
  std::string name;  ///< as messages show it
  toml::table root;
  OverridePlaces overrides;
};

/// The text of a file that may be a scenario's.
/// @throws ScenarioError where it cannot be read, or is no scenario by its size
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

/// @param name  stands for the file in messages
/// @throws ScenarioError with the place where it is not TOML
[[nodiscard]] Document parse(const std::string& name, std::string_view text);

/// Writes each "key=value" into the document.
/// @throws ScenarioError with every override that cannot be written
void apply_overrides(Document& document, std::span<const std::string> overrides);

/// Forms the scenario, checked and with shared numbers copied.
/// @throws ScenarioError with every problem, those of the file first, in the order of its lines
[[nodiscard]] Scenario read_scenario(const Document& document);

}  // namespace surefoot::scenario
