// Many runs of one scenario: same verdicts whatever the threads, interruptions and resumptions.
#include "tools/batch/batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

#include "tools/batch/verdict_line.hpp"
#include "tools/run/lockstep_run.hpp"

namespace surefoot::batch {
namespace {

constexpr std::size_t kTrials = 6;

/// 9.5 s from power-up to time zero instead of 12.
Batch small_batch() {
  Batch batch;
  batch.common = {"reflex.standing_s=0.5", "detector.warm_up_s=0", "detector.learning_s=4.8", "duration_s=0.3",
                  "payload=[]"};
  for (std::size_t trial = 0; trial < kTrials; ++trial) {
    batch.trials.push_back({{"sensor.force_noise_n=2", "seed=" + std::to_string(trial)}});
  }
  return batch;
}

BatchOptions with_jobs(unsigned jobs, std::filesystem::path journal = {}) {
  BatchOptions options;
  options.jobs = jobs;
  options.journal = std::move(journal);
  return options;
}

std::vector<std::string> lines_of(const std::vector<run::Verdict>& verdicts) {
  std::vector<std::string> lines;
  for (const run::Verdict& verdict : verdicts) lines.push_back(line_of({lines.size(), "", verdict}));
  return lines;
}

/// The batch, run once by itself.
const std::vector<std::string>& expected_lines() {
  static const std::vector<std::string> lines = lines_of(run_batch(small_batch(), with_jobs(2)));
  return lines;
}

class BatchJournal : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "surefoot-batch-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
    journal_ = folder_ / "journal.jsonl";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Stops the batch after `count` trials.
  void run_and_stop_after(std::size_t count) {
    std::atomic<bool> stop{false};
    BatchOptions options = with_jobs(1, journal_);
    options.stop = &stop;
    options.on_progress = [&](const Progress& progress) { stop = progress.done >= count; };
    EXPECT_THROW(static_cast<void>(run_batch(small_batch(), options)), Interrupted);
  }
  std::string text() const {
    std::ifstream stream(journal_, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write(const std::string& text) const { std::ofstream(journal_, std::ios::binary) << text; }
  /// How many trials it ran to finish the batch, and that the outcome is as expected.
  std::size_t finish() const {
    std::size_t ran = 0;
    BatchOptions options = with_jobs(2, journal_);
    options.on_progress = [&](const Progress&) { ++ran; };
    EXPECT_EQ(lines_of(run_batch(small_batch(), options)), expected_lines());
    return ran;
  }
  /// The message that refuses the journal.
  std::string refusal(const Batch& batch) const {
    try {
      static_cast<void>(run_batch(batch, with_jobs(1, journal_)));
    } catch (const scenario::ScenarioError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder_;
  std::filesystem::path journal_;
};

TEST(RunBatch, AVerdictIsThatOfTheSameRunAlone) {
  const Batch batch = small_batch();
  std::vector<std::string> overrides = batch.common;
  overrides.insert(overrides.end(), batch.trials[4].overrides.begin(), batch.trials[4].overrides.end());
  const run::Verdict alone = run::run_lockstep(scenario::load_default(overrides), {});
  EXPECT_EQ(line_of({4, "", alone}), expected_lines().at(4));
  EXPECT_NE(expected_lines().at(3), line_of({3, "", alone}));  // the seed decides, so the order is seen
}

TEST(RunBatch, NumberOfThreadsChangesNothing) {
  EXPECT_EQ(lines_of(run_batch(small_batch(), with_jobs(4))), expected_lines());
}

TEST(RunBatch, ABadTrialIsNamedBeforeAnyRuns) {
  Batch batch = small_batch();
  batch.trials[5].overrides = {"floor.friction=-1"};
  bool has_run = false;
  BatchOptions options = with_jobs(2);
  options.on_progress = [&](const Progress&) { has_run = true; };
  try {
    static_cast<void>(run_batch(batch, options));
    FAIL();
  } catch (const scenario::ScenarioError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("--set floor.friction=-1: floor.friction is -1"));
  }
  EXPECT_FALSE(has_run);
}

TEST(RunBatch, OfNoTrialsGivesNoVerdicts) { EXPECT_TRUE(run_batch({}, {}).empty()); }

TEST_F(BatchJournal, AnInterruptedBatchGoesOnWhereItStopped) {
  run_and_stop_after(2);
  EXPECT_EQ(finish(), kTrials - 2);
  EXPECT_EQ(finish(), 0U);
}

TEST_F(BatchJournal, ALineThatWasCutOffIsRunAgain) {
  run_and_stop_after(2);
  const std::string whole = text();
  write(whole.substr(0, whole.size() - 40));
  EXPECT_EQ(finish(), kTrials - 1);
  EXPECT_EQ(std::ranges::count(text(), '\n'), static_cast<std::ptrdiff_t>(kTrials + 1));
  write(whole.substr(0, 10));  // killed while the first line was written
  EXPECT_EQ(finish(), kTrials);
}

TEST_F(BatchJournal, OfAnotherBatchIsRefused) {
  run_and_stop_after(2);
  const std::string before = text();
  Batch other = small_batch();
  other.common.emplace_back("floor.friction=0.5");
  EXPECT_THAT(refusal(other), ::testing::StartsWith(journal_.string() + ":2: belongs to another batch: row 0"));
  other = small_batch();
  other.trials.resize(1);
  EXPECT_THAT(refusal(other), ::testing::HasSubstr(":3: belongs to another batch: it holds row 1"));
  EXPECT_EQ(text(), before);
}

TEST_F(BatchJournal, OfAnotherBuildIsRefused) {
  run_and_stop_after(1);
  std::string changed = text();
  changed.replace(changed.find(R"("build":")") + 9, 4, "????");
  write(changed);
  EXPECT_THAT(refusal(small_batch()), ::testing::HasSubstr(":1: was written by another build of surefoot\n  remedy: "));
}

TEST_F(BatchJournal, AFileThatIsNoJournalIsRefusedAndKept) {
  for (const std::string& content : {std::string("duration_s = 3\n"), std::string("x"), std::string(3, '\0')}) {
    write(content);
    EXPECT_THAT(refusal(small_batch()), ::testing::HasSubstr("is no journal of a batch"));
    EXPECT_EQ(text(), content);
  }
}

TEST_F(BatchJournal, WhatCannotBeWrittenIsSaidWithARemedy) {
  const Batch batch = small_batch();
  EXPECT_THROW(static_cast<void>(run_batch(batch, with_jobs(2, folder_ / "no" / "such"))), run::RecordingFailure);
}

}  // namespace
}  // namespace surefoot::batch
