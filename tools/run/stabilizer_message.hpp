#pragma once

#include <cstdint>

#include "firmware/core/controller.hpp"
#include "firmware/host/run_recorder.hpp"
#include "surefoot/stabilizer_t.hpp"

namespace surefoot::run {

/// What the controllers of a floor walk saw and added in one tick.
///
/// @param utime_us  scenario clock
/// @param is_on     as configured
/// @param output    of `WalkMethod::kFloorWalk`
[[nodiscard]] stabilizer_t stabilizer_message(std::int64_t utime_us, const stabilizer::Switches& is_on,
                                              const TickOutput& output) noexcept;

/// Puts the channel SUREFOOT_STABILIZER into a recording, of a floor walk alone.
class StabilizerTelemetry {
 public:
  explicit StabilizerTelemetry(const ControllerConfig&) noexcept;

  void push(host::RunRecorder&, std::int64_t utime_us, const TickOutput&) const noexcept;

 private:
  bool walks_on_floors_;
  stabilizer::Switches is_on_;
};

}  // namespace surefoot::run
