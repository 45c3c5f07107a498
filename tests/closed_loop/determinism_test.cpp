#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "firmware/host/allocation_guard.hpp"
#include "tests/closed_loop/run_scenario.hpp"
#include "tools/run/candump_log.hpp"
#include "tools/run/replay.hpp"

namespace surefoot::run {
namespace {

using testing::run_scenario;

class Recorded : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  Verdict record(const std::string& name, const std::vector<std::string>& overrides = {}) {
    RunOptions options;
    options.folder = folder_ / name;
    return run_scenario("main", overrides, options);
  }

  /// Flips one hexadecimal digit of the first frame of that identifier at or after a line.
  void flip_a_digit(const std::string& name, const std::string& identifier, int from_line) {
    std::ifstream in(folder_ / name / "bus.log");
    std::string text;
    std::string line;
    bool is_done = false;
    for (int number = 0; std::getline(in, line); ++number) {
      if (!is_done && number >= from_line && line.find(" " + identifier + "##1") != std::string::npos) {
        line.back() = line.back() == '0' ? '1' : '0';
        is_done = true;
      }
      text += line + "\n";
    }
    ASSERT_TRUE(is_done);
    std::ofstream(folder_ / name / "bus.log") << text;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("surefoot_determinism_" + std::to_string(getpid()));
};

const std::vector<std::string> kNoisy{"duration_s=6", "limits.min_cycles_after_recovery=0", "sensor.force_noise_n=1.0",
                                      "sensor.encoder_noise_rad=1e-5", "seed=7"};

TEST_F(Recorded, RunsOnManyThreadsGiveTheSameBitsAsOneAlone) {
  const Verdict alone = record("alone", kNoisy);
  ASSERT_EQ(alone.bus_log_sha256.size(), 64U);
  std::array<Verdict, 4> together;
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < together.size(); ++i) {
      threads.emplace_back([&, i] { together[i] = record("thread" + std::to_string(i), kNoisy); });
    }
  }
  for (const Verdict& verdict : together) EXPECT_EQ(verdict.bus_log_sha256, alone.bus_log_sha256);
}

TEST_F(Recorded, AnotherSeedGivesOtherBits) {
  std::vector<std::string> other = kNoisy;
  other.back() = "seed=8";
  EXPECT_NE(record("one", kNoisy).bus_log_sha256, record("other", other).bus_log_sha256);
}

TEST_F(Recorded, ReplayGivesTheSameFramesBitByBit) {
  record("run", kNoisy);
  const ReplayResult result = replay(folder_ / "run");
  EXPECT_EQ(result.ticks, 18000U);
  EXPECT_EQ(result.controller_frames, 3 * 18000U + 180U);
  EXPECT_EQ(result.differing_frames, 0U) << result.first_difference;
  EXPECT_FALSE(result.ends_in_mid_tick);
}

// A replay that cannot fail proves nothing: another sensor value must give other torques, and a frame
// that was tampered with is dropped by its CRC, which the torques show too.
TEST_F(Recorded, ReplayNoticesATamperedNodeFrameAndATamperedTorque) {
  record("run", kNoisy);
  flip_a_digit("run", "181", 100000);
  const ReplayResult sensor = replay(folder_ / "run");
  EXPECT_GT(sensor.differing_frames, 0U);
  record("run", kNoisy);
  flip_a_digit("run", "201", 100000);
  EXPECT_EQ(replay(folder_ / "run").differing_frames, 1U);
}

TEST_F(Recorded, ALogCutInTheMiddleReplaysAsFarAsItGoes) {
  record("run", kNoisy);
  const std::filesystem::path log = folder_ / "run" / "bus.log";
  std::filesystem::resize_file(log, std::filesystem::file_size(log) / 2 + 7);
  const ReplayResult result = replay(folder_ / "run");
  EXPECT_GT(result.ticks, 8000U);
  EXPECT_EQ(result.differing_frames, 0U);
}

// Firmware, simulated robot, judge and recorder's front end: not one allocation in the whole loop,
// reflex and recovery included.
TEST_F(Recorded, TheLoopDoesNotAllocate) {
  const Verdict verdict = record("run");
  ASSERT_EQ(verdict.outcome, Outcome::kWalked) << verdict.reason;
  ASSERT_EQ(verdict.allocations_were_counted, host::allocation_guard::is_available());
  EXPECT_EQ(verdict.allocations_in_loop, 0U);
}

TEST_F(Recorded, AStopFromOutsideLeavesAValidShorterRun) {
  std::atomic<bool> stop{true};
  RunOptions options;
  options.folder = folder_ / "stopped";
  options.stop = &stop;
  const Verdict verdict = run_scenario("main", {}, options);
  EXPECT_EQ(verdict.outcome, Outcome::kInterrupted);
  EXPECT_TRUE(std::filesystem::exists(options.folder / "verdict.json"));
}

TEST(CandumpLog, RefusesWhatIsNoCanFdFrame) {
  for (const char* line :
       {"", "(0.000000)", "(0.000000) can0 181#00", "(0.000000) can0 181##1ZZ", "(0.000000) can0 181##1ABC",
        "(x.000000) can0 181##1AB", "(9223372036855.000000) can0 181##1AB", "(-1.000000) can0 181##1AB",
        "(0.000) can0 181##1AB", "(0.000000) can0 800##1AB", "can0 181##1AB"}) {
    EXPECT_FALSE(parse_candump_line(line)) << line;
  }
  const std::optional<LoggedFrame> logged = parse_candump_line("(12.345678) can0 181##1AB01");
  ASSERT_TRUE(logged);
  EXPECT_EQ(logged->elapsed_us, 12'345'678);
  EXPECT_EQ(logged->frame.identifier, 0x181);
  EXPECT_EQ(logged->frame.length, 2);
  EXPECT_EQ(logged->frame.payload[0], 0xAB);
}

}  // namespace
}  // namespace surefoot::run
