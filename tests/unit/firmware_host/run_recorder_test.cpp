#include "firmware/host/run_recorder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <surefoot/controller_state_t.hpp>
#include <surefoot/event_t.hpp>

#include "firmware/host/allocation_guard.hpp"
#include "firmware/host/candump_format.hpp"
#include "firmware/host/sha256.hpp"
#include "tests/unit/firmware_host/file_size_limit.hpp"
#include "tests/unit/firmware_host/frames.hpp"
#include "tests/unit/firmware_host/telemetry_log.hpp"
#include "tests/unit/firmware_host/temporary_folder.hpp"

namespace surefoot::host {
namespace {

using testing::contents_of;
using testing::events_of;
using testing::FileSizeLimit;
using testing::numbered_frame;
using testing::TemporaryFolder;

constexpr std::uint32_t kFramesPerTick = 9;

RecorderOptions options_in(const TemporaryFolder& folder) {
  return {.bus_log = folder / "bus.log", .telemetry_log = folder / "telemetry.lcmlog"};
}

/// What a lockstep driver does: waits for room, then one tick that may not wait.
void record_ticks(RunRecorder& recorder, std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) {
    recorder.wait_for_room();
    recorder.set_elapsed(std::int64_t{tick} * 1000);
    for (std::uint32_t i = 0; i < kFramesPerTick; ++i) recorder.on_frame(numbered_frame(tick * kFramesPerTick + i));
    controller_state_t state{};
    state.tick = tick;
    recorder.push(Channel::kControllerState, std::int64_t{tick} * 1000 - 3'000'000, state);
  }
}

std::string expected_bus_log(std::uint32_t ticks) {
  std::string text;
  std::array<char, kMaxCandumpLine> line{};
  for (std::uint32_t number = 0; number < ticks * kFramesPerTick; ++number) {
    const std::int64_t elapsed_us = std::int64_t{number / kFramesPerTick} * 1000;
    text.append(line.data(), format_candump_line(line.data(), elapsed_us, numbered_frame(number)));
  }
  return text;
}

std::string sha256_of(const std::string& text) {
  Sha256 digest;
  digest.update(text.data(), text.size());
  return digest.hex();
}

TEST(RunRecorder, RecordsEveryFrameAndMessageInOrderThroughRingsFarSmallerThanTheRun) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.power_up_before_zero_us = 3'000'000;
  options.frame_slots = 128;
  options.message_slots = 32;
  RunRecorder recorder(options);
  constexpr std::uint32_t kTicks = 2000;
  record_ticks(recorder, kTicks);
  const RecordingSummary summary = recorder.finish();

  EXPECT_FALSE(summary.error.has_value());
  EXPECT_EQ(summary.frames_dropped, 0U);
  EXPECT_EQ(summary.messages_dropped, 0U);
  EXPECT_EQ(summary.frames, kTicks * kFramesPerTick);
  const std::string bus_log = contents_of(folder / "bus.log");
  EXPECT_TRUE(bus_log == expected_bus_log(kTicks));
  EXPECT_EQ(summary.bus_log_bytes, bus_log.size());
  EXPECT_EQ(summary.bus_log_sha256, sha256_of(bus_log));

  const auto events = events_of(folder / "telemetry.lcmlog");
  ASSERT_EQ(events.size(), kTicks);
  EXPECT_EQ(summary.messages, kTicks);
  for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
    EXPECT_EQ(events[tick].channel, "SUREFOOT_STATE");
    EXPECT_EQ(events[tick].timestamp_us, std::int64_t{tick} * 1000) << "since power-up, never negative";
    EXPECT_EQ(events[tick].as<controller_state_t>().tick, tick);
  }
}

TEST(RunRecorder, AnEmptyRunHasEmptyFilesAndTheDigestOfNothing) {
  const TemporaryFolder folder;
  RunRecorder recorder(options_in(folder));
  const RecordingSummary summary = recorder.finish();
  EXPECT_EQ(summary.bus_log_sha256, sha256_of(""));
  EXPECT_EQ(contents_of(folder / "bus.log"), "");
  EXPECT_EQ(contents_of(folder / "telemetry.lcmlog"), "");
}

TEST(RunRecorder, GivesTheSameSummaryAgainAndKeepsTheRunWhenDestroyedWithoutFinish) {
  const TemporaryFolder folder;
  RunRecorder recorder(options_in(folder));
  record_ticks(recorder, 10);
  const RecordingSummary first = recorder.finish();
  const RecordingSummary second = recorder.finish();
  EXPECT_EQ(first.frames, 10 * kFramesPerTick);
  EXPECT_EQ(first.frames, second.frames);
  EXPECT_EQ(first.bus_log_sha256, second.bus_log_sha256);

  const TemporaryFolder other;
  {
    RunRecorder abandoned(options_in(other));
    record_ticks(abandoned, 10);
  }
  EXPECT_EQ(contents_of(other / "bus.log"), contents_of(folder / "bus.log"));
}

TEST(RunRecorder, NeverWaitsInsideATickAndCountsWhatItDropsInstead) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.frame_slots = 64;
  options.message_slots = 16;
  RunRecorder recorder(options);
  constexpr std::uint32_t kFrames = 20'000;
  for (std::uint32_t i = 0; i < kFrames; ++i) recorder.on_frame(numbered_frame(i));
  std::uint64_t accepted = 0;
  for (int i = 0; i < 1000; ++i) accepted += recorder.push(Channel::kEvent, i, event_t{}) ? 1U : 0U;
  const RecordingSummary summary = recorder.finish();
  EXPECT_EQ(summary.frames + summary.frames_dropped, kFrames);
  EXPECT_EQ(summary.messages, accepted);
  EXPECT_EQ(summary.messages + summary.messages_dropped, 1000U);
}

TEST(RunRecorder, TheLoopsThreadDoesNotAllocate) {
  const TemporaryFolder folder;
  RunRecorder recorder(options_in(folder));
  allocation_guard::arm();
  record_ticks(recorder, 3000);
  const auto counts = allocation_guard::disarm();
  EXPECT_EQ(counts.allocations, 0U);
  EXPECT_EQ(counts.frees, 0U);
}

TEST(RunRecorder, NamesTheFileThatCanNotBeMade) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.telemetry_log = folder / "missing" / "telemetry.lcmlog";
  try {
    const RunRecorder recorder(options);
    FAIL() << "made a file in a folder that does not exist";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_NE(std::string(error.what()).find(options.telemetry_log.string()), std::string::npos);
  }
}

TEST(RunRecorder, AFullDiskIsReportedWhileTheRunGoesOnAndTheOtherFileIsWhole) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.bus_log = "/dev/full";
  RunRecorder recorder(options);
  EXPECT_EQ(recorder.error(), nullptr);
  std::uint32_t ticks = 0;
  for (; recorder.error() == nullptr && ticks < 100'000; ticks += 100) record_ticks(recorder, 100);
  ASSERT_NE(recorder.error(), nullptr);
  EXPECT_EQ(recorder.error()->code, std::errc::no_space_on_device);
  record_ticks(recorder, 2000);  // would hang if the rings were not drained any more
  const RecordingSummary summary = recorder.finish();
  ASSERT_TRUE(summary.error.has_value());
  EXPECT_EQ(summary.error->message, "/dev/full: No space left on device");
  EXPECT_EQ(summary.frames, 0U);
  EXPECT_EQ(events_of(folder / "telemetry.lcmlog").size(), ticks + 2000);
}

TEST(RunRecorder, AFullDiskForTelemetryLeavesTheBusLogWhole) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.telemetry_log = "/dev/full";
  RunRecorder recorder(options);
  record_ticks(recorder, 2000);
  const RecordingSummary summary = recorder.finish();
  ASSERT_TRUE(summary.error.has_value());
  EXPECT_EQ(summary.error->message, "/dev/full: No space left on device");
  EXPECT_EQ(summary.messages, 0U);
  EXPECT_TRUE(contents_of(folder / "bus.log") == expected_bus_log(2000));
}

TEST(RunRecorder, AWriteCutInTheMiddleKeepsWholeLinesAndWholeEventsAndTheProcess) {
  const TemporaryFolder folder;
  RecordingSummary summary;
  {
    const FileSizeLimit limit(300'001);  // no multiple of a line or an event
    RunRecorder recorder(options_in(folder));
    record_ticks(recorder, 3000);
    summary = recorder.finish();
  }
  ASSERT_TRUE(summary.error.has_value());
  EXPECT_EQ(summary.error->code, std::errc::file_too_large);

  const std::string bus_log = contents_of(folder / "bus.log");
  EXPECT_EQ(bus_log.size(), 300'000U) << "7500 lines of 40 characters";
  EXPECT_TRUE(bus_log == expected_bus_log(3000).substr(0, bus_log.size()));
  EXPECT_EQ(summary.bus_log_bytes, bus_log.size());
  EXPECT_EQ(summary.frames, 7500U);
  EXPECT_EQ(summary.bus_log_sha256, sha256_of(bus_log));

  const auto events = events_of(folder / "telemetry.lcmlog");
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.size(), summary.messages);
  const std::uint64_t event_bytes = 28 + 14 + static_cast<std::uint64_t>(controller_state_t{}.getEncodedSize());
  EXPECT_EQ(events.size(), 300'001U / event_bytes) << "as many as fit";
  EXPECT_EQ(std::filesystem::file_size(folder / "telemetry.lcmlog"), events.size() * event_bytes);
  EXPECT_EQ(summary.telemetry_log_bytes, events.size() * event_bytes);
}

// LCM's file provider stands in for the network: the same publish path, no multicast.
TEST(RunRecorder, TellsLiveListenersTheSameMessages) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.live_provider = "file://" + (folder / "live.lcmlog").string() + "?mode=w";
  {
    RunRecorder recorder(options);
    record_ticks(recorder, 50);
    EXPECT_EQ(recorder.finish().live_failures, 0U);
  }
  auto live = events_of(folder / "live.lcmlog");
  const auto announced = std::erase_if(live, [](const auto& event) { return event.channel == "SUREFOOT_RUN"; });
  EXPECT_GE(announced, 1U) << "who listens is told what to";
  const auto recorded = events_of(folder / "telemetry.lcmlog");
  ASSERT_EQ(live.size(), 50U);
  for (std::size_t i = 0; i < live.size(); ++i) {
    EXPECT_EQ(live[i].channel, recorded[i].channel);
    EXPECT_EQ(live[i].encoded, recorded[i].encoded);
  }
}

TEST(RunRecorder, NamesALiveProviderThatLcmDoesNotKnow) {
  const TemporaryFolder folder;
  RecorderOptions options = options_in(folder);
  options.live_provider = "pigeon://loft";
  try {
    const RunRecorder recorder(options);
    FAIL() << "published by pigeon";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("pigeon://loft"), std::string::npos);
  }
}

}  // namespace
}  // namespace surefoot::host
