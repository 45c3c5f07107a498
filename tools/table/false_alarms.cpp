#include "tools/table/false_alarms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace surefoot::table {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> overrides_of(const SensorNoise& noise) {
  return {"payload=[]",
          fmt::format("sensor.force_noise_n={}", noise.force_n),
          fmt::format("sensor.encoder_noise_rad={}", noise.encoder_rad),
          fmt::format("sensor.joint_rate_noise_rad_s={}", noise.joint_rate_rad_s),
          fmt::format("sensor.gyro_noise_rad_s={}", noise.gyro_rad_s),
          fmt::format("sensor.accelerometer_noise_m_s2={}", noise.accelerometer_m_s2)};
}

}  // namespace

batch::Batch noise_batch(const Experiment& experiment, const NoisePlan& plan) {
  batch::Batch batch = batch_of(experiment);
  const std::vector<std::string> noise = overrides_of(plan.noise);
  batch.common.insert(batch.common.end(), noise.begin(), noise.end());
  const double cycle_s = load_common(batch).firmware.walk.cycle_s();
  std::uint64_t seed = plan.first_seed;
  for (std::size_t left = plan.cycles; left > 0;) {
    const std::size_t cycles = std::min(left, plan.cycles_per_run);
    batch.trials.push_back(
        {{fmt::format("seed={}", seed++), fmt::format("duration_s={}", static_cast<double>(cycles) * cycle_s)}});
    left -= cycles;
  }
  return batch;
}

FalseAlarms false_alarms_of(const Experiment& experiment, const NoisePlan& plan,
                            const std::vector<run::Verdict>& verdicts) {
  FalseAlarms study;
  study.method = experiment.method;
  study.plant = experiment.plant;
  study.plan = plan;
  study.runs = verdicts.size();
  for (const run::Verdict& verdict : verdicts) {
    if (verdict.outcome != run::Outcome::kWalked) ++study.runs_not_walked;
    study.false_alarms += static_cast<std::size_t>(verdict.false_alarms);
    study.run_margins_n.push_back(verdict.unloaded_margin_n.min);
  }
  if (!verdicts.empty()) study.smallest_margin_n = *std::ranges::min_element(study.run_margins_n);
  return study;
}

std::string alarm_text(const FalseAlarms& study) {
  std::vector<double> sorted_n = study.run_margins_n;
  std::ranges::sort(sorted_n);
  const SensorNoise& noise = study.plan.noise;
  return fmt::format(
      "  {} false alarms in {} unloaded gait cycles ({} runs, seeds from {}); {} runs did not walk through\n"
      "  smallest margin to the threshold {:.2f} N; half of the runs kept {:.2f} N or more\n"
      "  noise (standard deviation of a sample): force {} N a corner, encoder {} rad, joint rate {} rad/s,\n"
      "  gyro {} rad/s, accelerometer {} m/s2\n",
      study.false_alarms, study.plan.cycles, study.runs, study.plan.first_seed, study.runs_not_walked,
      study.smallest_margin_n, sorted_n.empty() ? 0.0 : sorted_n[sorted_n.size() / 2], noise.force_n, noise.encoder_rad,
      noise.joint_rate_rad_s, noise.gyro_rad_s, noise.accelerometer_m_s2);
}

std::string alarm_csv(const FalseAlarms& study) {
  std::string text = "seed,smallest_margin_n\n";
  for (std::size_t i = 0; i < study.run_margins_n.size(); ++i) {
    text += fmt::format("{},{:.4f}\n", study.plan.first_seed + i, study.run_margins_n[i]);
  }
  return text;
}

std::string to_json(const FalseAlarms& study) {
  const SensorNoise& noise = study.plan.noise;
  return Json{{"picture", "false_alarms"},
              {"method", study.method},
              {"plant", study.plant},
              {"cycles", study.plan.cycles},
              {"runs", study.runs},
              {"first_seed", study.plan.first_seed},
              {"noise",
               {{"force_n", noise.force_n},
                {"encoder_rad", noise.encoder_rad},
                {"joint_rate_rad_s", noise.joint_rate_rad_s},
                {"gyro_rad_s", noise.gyro_rad_s},
                {"accelerometer_m_s2", noise.accelerometer_m_s2}}},
              {"runs_not_walked", study.runs_not_walked},
              {"false_alarms", study.false_alarms},
              {"smallest_margin_n", study.smallest_margin_n},
              {"run_margins_n", study.run_margins_n}}
             .dump(2) +
         "\n";
}

}  // namespace surefoot::table
