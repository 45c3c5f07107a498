#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/core/controller.hpp"
#include "sim_hw/plant_config.hpp"
#include "tools/scenario/planned_gait.hpp"
#include "tools/scenario/scenario_error.hpp"

namespace surefoot::scenario {

/// What a run must keep to besides not falling; an angle of 0 means no limit.
struct VerdictLimits {
  double max_abs_pitch_deg = 0.0;  ///< torso, on the scenario's clock from 0 on
  double max_abs_roll_deg = 0.0;   ///< torso, on the scenario's clock from 0 on
  /// Gait cycles to walk after the last load, where a reflex answers it, and after the last removal and push.
  double min_cycles_after_recovery = 2.0;
  /// The run ends once these cycles are walked and every load was noticed, taken off and every push over where there
  /// are any; a run with faults, or with a load that no reflex answers, goes on until `duration_s`.
  bool ends_when_recovered = false;
};

/// How much is recorded.
struct TelemetryOptions {
  std::uint32_t every_ticks = 1;  ///< one telemetry message of each kind every so many ticks
};

/// Everything that decides how a run goes, and nothing else: equal scenarios give equal bits.
///
/// The scenario's clock reads 0 at the begin of the first scored gait cycle, that is, after
/// standing, start-up, warm-up and learning; `duration_s` and `at_s` of payloads, pushes and faults count on it.
///
/// Numbers that two rooms need stand once as a key and are copied by `share_numbers`; the seed
/// lives in `sim.seed`, the time between ticks in `firmware.period_s`. `sim.time_zero_s` is the
/// runner's to set.
///
/// A default-constructed scenario is the plant `nominal` without payload, as the structs' own
/// defaults are; `load` and `load_default` start from the plant `thesis` unless told otherwise.
struct Scenario {
  std::string robot = "elkahlout";
  std::string plant = "nominal";
  std::string controllers = "extended";  ///< stabilizer.set: those of `khr2` that are on unless told otherwise
  double duration_s = 20.0;
  ControllerConfig firmware{};
  sim_hw::SimConfig sim{};
  VerdictLimits limits{};
  TelemetryOptions telemetry{};
  std::vector<PlannedGaitConfig> gaits;  ///< walked one after the other; none: each robot's own pattern
};

/// Whether the firmware walks with KHR-2's stages and controllers: KHR-2 does, and whoever walks planned gaits.
[[nodiscard]] bool walks_over_floors(const Scenario& scenario);

/// Most loads one run takes.
inline constexpr std::size_t kMaxPayloads = 16;

/// Reads a scenario file. Order of precedence: `--set` overrides, the file, the plant's preset, the
/// structs' defaults. Payloads come back sorted by time.
///
/// Pushes and faults keep the order of the file.
///
/// @param overrides  "key=value" each, as given to `--set`; later ones win; payloads, pushes and faults by
///                   their place in the file: "payload.0.mass_kg=5"
/// @throws ScenarioError with every problem found: unknown keys, wrong types, impossible values
[[nodiscard]] Scenario load(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same for text that is at hand; `name` stands for the file in messages.
[[nodiscard]] Scenario load_text(const std::string& name, std::string_view text,
                                 std::span<const std::string> overrides = {});

/// The main job, the same as tools/scenarios/main.toml: 5 kg at 1.2 s, original reflex, plant `thesis`.
/// @throws ScenarioError as `load`
[[nodiscard]] Scenario load_default(std::span<const std::string> overrides = {});

/// The effective scenario: TOML with every key filled in, unit and range beside it. `load` of the
/// text gives the identical scenario, to the last bit.
[[nodiscard]] std::string to_toml(const Scenario& scenario);

/// What `surefoot keys` prints: every key with its kind, unit, range, default and meaning.
[[nodiscard]] std::string describe_keys();

/// Copies the numbers that stand once: `sim.geometry`, `sim.control_period_s` and
/// `firmware.servo.torque_limit_nm` follow `firmware.geometry`, `firmware.period_s` and
/// `firmware.gate.torque_limit_nm`. `load` has done it; call it after changing one of them in code.
void share_numbers(Scenario& scenario);

/// Checks a scenario that was put together in code.
/// @throws ScenarioError with every problem found
void validate(const Scenario& scenario);

}  // namespace surefoot::scenario
