#pragma once

#include <vector>

#include "firmware/core/controller.hpp"
#include "tools/bench/bench.hpp"

namespace surefoot::bench {

/// The lines of `Controller::tick`, each alone, on the sensors of one tick.
[[nodiscard]] std::vector<Stage> firmware_stages(const ControllerConfig& config, const SensorSnapshot& sensors,
                                                 double seconds);

}  // namespace surefoot::bench
