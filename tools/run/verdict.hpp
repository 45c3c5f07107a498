#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firmware/core/joints.hpp"
#include "firmware/host/tick_histogram.hpp"
#include "tools/run/exit_code.hpp"

namespace surefoot::run {

enum class Outcome : std::uint8_t {
  kWalked,  ///< no fall, no fault, every limit kept
  kFell,
  kLimit,        ///< a limit of the scenario broke, or it ended before the robot had recovered
  kFault,        ///< the firmware latched a fault
  kInterrupted,  ///< stopped from outside
};

[[nodiscard]] const char* name(Outcome outcome) noexcept;
[[nodiscard]] ExitCode exit_code(Outcome outcome) noexcept;

/// Smallest and largest value seen.
struct Range {
  double min = 0.0;
  double max = 0.0;
  bool is_empty = true;

  void include(double value) noexcept {
    if (is_empty || value < min) min = value;
    if (is_empty || value > max) max = value;
    is_empty = false;
  }
  [[nodiscard]] double largest_magnitude() const noexcept { return -min > max ? -min : max; }
};

/// Something that happened, on the scenario clock.
struct TimedEvent {
  const char* name = "";
  double time_s = 0.0;
};

/// One identifier on one bus.
struct StreamTiming {
  std::uint16_t identifier = 0;
  const char* name = "";  ///< as in surefoot.dbc
  std::uint64_t frames = 0;
  std::optional<double> worst_case_us;  ///< from queued to the end of the frame, by analysis; nothing: without bound
  double observed_us = 0.0;             ///< the largest of the run
};

/// What crossed one bus, bit by bit.
struct BusTraffic {
  double load_percent = 0.0;
  std::uint64_t frames = 0;
  std::uint64_t nominal_bits = 0;  ///< at the nominal bit rate, stuff bits and intermission included
  std::uint64_t data_bits = 0;     ///< at the data bit rate
  std::uint64_t busy_ns = 0;
  std::int64_t elapsed_ns = 0;
  std::vector<StreamTiming> streams;
};

/// What a run is judged by. Angles, torques and slip count from the scenario's time zero.
struct Verdict {
  Outcome outcome = Outcome::kWalked;
  std::string reason;
  double ended_at_s = 0.0;
  Range torso_pitch_deg;  ///< beta in the thesis, positive leaning forward
  Range torso_roll_deg;
  Range start_up_pitch_deg;  ///< before time zero
  Range start_up_roll_deg;
  double distance_m = 0.0;
  int steps_walked = 0;  ///< touch-downs of the gait since time zero
  /// Gait cycles since the last resume, since the last removal or push was over, or since time zero.
  double cycles_after_recovery = 0.0;
  std::vector<TimedEvent> events;
  int payloads_attached = 0;
  int payloads_detected = 0;  ///< at most as many as were attached
  int payloads_removed = 0;
  int pushes = 0;  ///< that were over before the end
  int disturbance_triggers =
      0;                 ///< detections with no new payload, but in a push, or in the step after one or a removal
  int false_alarms = 0;  ///< all other detections beyond the payloads that hang

  std::array<double, kJointsPerLeg> peak_torque_nm{};  ///< larger of both legs
  double torque_ripple_nm = 0.0;                       ///< root mean square of the change from tick to tick, all joints
  double time_at_torque_limit_percent = 0.0;           ///< share of joint ticks
  double foot_slip_mm = 0.0;                           ///< way the soles slid, weighted with their load, per step
  double standing_zmp_x_body_m = 0.0;  ///< true ZMP, mean over the last half second of the initial standing
  double threshold_n = 0.0;            ///< payload threshold at the end
  Range unloaded_margin_n;             ///< payload threshold above the filtered force, walking before the first load
  int unreachable_ticks = 0;

  std::string bus_log_sha256;
  std::uint64_t allocations_in_loop = 0;
  bool allocations_were_counted = false;
  double tick_us_mean = 0.0, tick_us_p50 = 0.0, tick_us_p999 = 0.0, tick_us_max = 0.0;
  host::TickHistogram::Bins tick_bins{};
  double real_time_factor = 0.0;
  std::uint64_t frames_sent = 0;
  std::uint64_t frames_lost = 0;  ///< refused, rejected or missing on either side, or not recorded; a damaged frame
                                  ///< counts when it arrives and again as a gap
  std::uint64_t frames_late = 0;
  double bus_load_percent = 0.0;  ///< of two buses that with the most
  std::vector<BusTraffic> bus;
};

/// As `verdict.json` keeps it, and `--json` prints it.
[[nodiscard]] std::string to_json(const Verdict& verdict);

/// As a person reads it on the terminal.
[[nodiscard]] std::string to_text(const Verdict& verdict);

}  // namespace surefoot::run
