#pragma once

#include "firmware/core/sensor_snapshot.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::bench {

/// A walking tick of the closed loop, each side of the bus alone on the same frames, in microseconds.
struct LoopStages {
  double firmware_us = 0.0;   ///< decode, control, encode
  double robot_us = 0.0;      ///< nodes and world
  double judge_us = 0.0;      ///< events and verdict
  double bus_watch_us = 0.0;  ///< weighing and timing the frames as a real bus would carry them (`run::BusWatch`)
  SensorSnapshot sensors;     ///< what the firmware saw in one tick
};

/// @param scenario  with its time zero set, without payloads and pushes
[[nodiscard]] LoopStages loop_stages(const scenario::Scenario& scenario, double seconds);

/// The whole: what a trial of a batch is.
[[nodiscard]] double closed_loop_us(const scenario::Scenario& scenario, double seconds);

}  // namespace surefoot::bench
