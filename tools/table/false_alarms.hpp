#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/batch/batch.hpp"
#include "tools/table/experiment.hpp"

namespace surefoot::table {

/// Standard deviations of white noise on every sample at 1 kHz.
struct SensorNoise {
  double force_n = 2.0;                ///< a corner of a foot: 0.2 % of a load cell of 1 kN
  double encoder_rad = 1.0e-5;         ///< one step of the encoder
  double joint_rate_rad_s = 1.0e-2;    ///< one encoder step in 1 ms
  double gyro_rad_s = 2.0e-3;          ///< 0.005 deg/s/sqrt(Hz) over 500 Hz
  double accelerometer_m_s2 = 2.0e-2;  ///< 100 micro-g/sqrt(Hz) over 500 Hz
};

/// Unloaded walks with noisy sensors, each with a seed of its own.
struct NoisePlan {
  SensorNoise noise;
  std::size_t cycles = 1000;        ///< gait cycles in all
  std::size_t cycles_per_run = 20;  ///< at most
  std::uint64_t first_seed = 1;
};

[[nodiscard]] batch::Batch noise_batch(const Experiment& experiment, const NoisePlan& plan);

/// What the payload detector made of walks without payload.
struct FalseAlarms {
  std::string method;
  std::string plant;
  NoisePlan plan;
  std::size_t runs = 0;
  std::size_t runs_not_walked = 0;  ///< fell, broke off, or raised an alarm
  std::size_t false_alarms = 0;
  double smallest_margin_n = 0.0;     ///< of all runs: threshold above the filtered force
  std::vector<double> run_margins_n;  ///< the smallest of each run, seed by seed
};

/// @param verdicts  of the batch above
[[nodiscard]] FalseAlarms false_alarms_of(const Experiment& experiment, const NoisePlan& plan,
                                          const std::vector<run::Verdict>& verdicts);

[[nodiscard]] std::string alarm_text(const FalseAlarms& study);
[[nodiscard]] std::string alarm_csv(const FalseAlarms& study);
[[nodiscard]] std::string to_json(const FalseAlarms& study);

}  // namespace surefoot::table
