#pragma once

#include <nlohmann/json.hpp>

#include "firmware/host/bus/host_bus.hpp"

namespace surefoot::run {

/// The counters of an interface as firmware.json and robot.json keep them.
[[nodiscard]] inline nlohmann::ordered_json json_of(const host::BusReport& bus) {
  return {{"sent", bus.sent},
          {"received", bus.received},
          {"refused_no_buffer", bus.refused_no_buffer},
          {"link_down", bus.link_down},
          {"error_frames", bus.error_frames},
          {"bus_off", bus.bus_off},
          {"foreign_shape", bus.foreign_shape},
          {"queue_overflow", bus.queue_overflow}};
}

}  // namespace surefoot::run
