// What trials share is walked once: their verdicts are those of runs from power-up on, to the last bit.
#include "tools/batch/shared_walk.hpp"

#include <gtest/gtest.h>

#include <future>

#include "tools/run/lockstep_run.hpp"
#include "tools/run/schedule.hpp"
#include "tools/run/shared_past.hpp"

namespace surefoot::batch {
namespace {

/// 8.75 s from power-up to time zero instead of 12; noise, so that every draw counts.
LoadedTrial trial_of(const std::vector<std::string>& own) {
  std::vector<std::string> overrides{"reflex.standing_s=0.5",  "detector.warm_up_s=0",  "detector.learning_s=4.8",
                                     "sensor.force_noise_n=2", "reflex.settling_s=0.5", "duration_s=4"};
  overrides.insert(overrides.end(), own.begin(), own.end());
  return {scenario::load_default(overrides), ""};
}

/// Everything that a verdict says but wall times: the bits of all frames are counted in it.
std::string text_of(run::Verdict verdict) {
  verdict.tick_us_mean = verdict.tick_us_p50 = verdict.tick_us_p999 = verdict.tick_us_max = verdict.real_time_factor = 0.0;
  verdict.tick_bins = {};
  return run::to_json(verdict);
}

std::vector<LoadedTrial> mixed_trials() {
  std::vector<LoadedTrial> trials;
  for (const char* load : {"0", "0.05", "1.2", "1.2005", "1.9", "2.6"}) {
    trials.push_back(trial_of({std::string("payload.0.at_s=") + load, "payload.0.mass_kg=10"}));
  }
  trials.push_back(trial_of({"payload=[]"}));
  trials.push_back(trial_of({"payload=[]", "duration_s=0.35"}));
  trials.push_back(trial_of({"payload.0.at_s=1.9", "duration_s=2.5", "payload.0.removed_at_s=2.2"}));
  trials.push_back(trial_of({"payload=[]", "push=[{at_s=1.25, duration_s=0.1, force_n=[0.0, 150.0, 0.0]}]"}));
  trials.push_back(trial_of({"payload.0.at_s=1.2", "limits.max_abs_roll_deg=1"}));
  trials.push_back(trial_of({"payload.0.at_s=1.2", "reflex.method=off"}));  // another firmware: a walk of its own
  return trials;
}

TEST(SharedWalk, GivesTheVerdictsOfRunsFromPowerUpOn) {
  const std::vector<LoadedTrial> trials = mixed_trials();
  SharedWalk walk(trials);
  // Late ones first and two at a time: the walk's stops come in any order.
  const auto run_some = [&](std::size_t parity) {
    std::vector<std::string> texts;
    for (std::size_t i = trials.size(); i-- > 0;) {
      if (i % 2 == parity) texts.push_back(text_of(walk.run(i)));
    }
    return texts;
  };
  std::future<std::vector<std::string>> even = std::async(std::launch::async, run_some, 0U);
  std::vector<std::string> odd = run_some(1);
  std::vector<std::string> shared[2] = {even.get(), std::move(odd)};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(shared[i % 2].back(), text_of(run::run_lockstep(trials[i].scenario, {})));
    shared[i % 2].pop_back();
  }
}

TEST(SharedPast, IsThatOfScenariosThatDifferInLoadsPushesLengthAndLimitsAlone) {
  const std::string key = run::past_key(trial_of({}).scenario);
  for (const char* same : {"payload=[]", "payload.0.mass_kg=7", "duration_s=9", "limits.max_abs_pitch_deg=3",
                           "push=[{at_s=1.0, force_n=[1.0, 0.0, 0.0]}]"}) {
    EXPECT_EQ(run::past_key(trial_of({same}).scenario), key) << same;
  }
  for (const char* other : {"seed=2", "reflex.method=off", "floor.friction=0.12", "plant=nominal",
                            "physics.step_s=0.00025", "sensor.force_noise_n=1", "detector.margin_n=4"}) {
    EXPECT_NE(run::past_key(trial_of({other}).scenario), key) << other;
  }
}

TEST(SharedPast, IsNoneWhereARobotCannotBeBranched) {
  EXPECT_EQ(run::past_key(trial_of({"contact.model=bullet"}).scenario), "");
  EXPECT_EQ(run::past_key(trial_of({"fault.0.kind=drop", "fault.0.target=foot_left"}).scenario), "");
}

TEST(SharedPast, EndsBeforeTheFirstDisturbance) {
  const scenario::Scenario base = trial_of({"payload=[]"}).scenario;
  const std::int64_t zero = run::schedule_of(base).zero_tick;
  EXPECT_EQ(run::undisturbed_ticks(base), zero + 4000);
  const auto ticks = [](const std::vector<std::string>& own) { return run::undisturbed_ticks(trial_of(own).scenario); };
  EXPECT_LE(ticks({"payload.0.at_s=1.2"}), zero + 1199);
  EXPECT_GE(ticks({"payload.0.at_s=1.2"}), zero + 1197);
  EXPECT_LT(ticks({"payload.0.at_s=1.2", "push=[{at_s=0.4, force_n=[1.0, 0.0, 0.0]}]"}), zero + 400);
  EXPECT_EQ(ticks({"payload.0.at_s=3.9", "duration_s=1"}), zero + 1000);
}

}  // namespace
}  // namespace surefoot::batch
