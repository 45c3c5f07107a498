#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <surefoot/event_t.hpp>

#include "firmware/host/bus_log_writer.hpp"
#include "firmware/host/telemetry_log_writer.hpp"
#include "tests/unit/firmware_host/frames.hpp"
#include "tests/unit/firmware_host/telemetry_log.hpp"
#include "tests/unit/firmware_host/temporary_folder.hpp"

namespace surefoot::host {
namespace {

using testing::contents_of;
using testing::events_of;
using testing::numbered_frame;
using testing::TemporaryFolder;

template <class Writer>
std::string reason_of_failing_to_create(const std::filesystem::path& path) {
  try {
    const Writer writer(path);
  } catch (const std::system_error& error) {
    return error.what();
  }
  return "created";
}

TEST(LogWriters, NameThePathAndTheReasonWhenAFileCanNotBeMade) {
  EXPECT_EQ(reason_of_failing_to_create<BusLogWriter>("/nowhere/bus.log"),
            "/nowhere/bus.log: No such file or directory");
  EXPECT_EQ(reason_of_failing_to_create<TelemetryLogWriter>("/nowhere/t.lcmlog"),
            "/nowhere/t.lcmlog: No such file or directory");
  EXPECT_EQ(reason_of_failing_to_create<BusLogWriter>("/"), "/: Is a directory");
}

TEST(BusLogWriter, ReplacesAnOlderFileAndCountsOnlyWhatIsInTheNewOne) {
  const TemporaryFolder folder;
  std::ofstream(folder / "bus.log") << std::string(1000, 'o');
  BusLogWriter writer(folder / "bus.log");
  writer.append(1, numbered_frame(0x01020304));
  EXPECT_EQ(writer.frames(), 0U);
  writer.flush();
  EXPECT_EQ(contents_of(folder / "bus.log"), "(0000000000.000001) can0 181##101020304\n");
  EXPECT_EQ(writer.frames(), 1U);
  EXPECT_EQ(writer.bytes(), 40U);
}

void append_event(TelemetryLogWriter& writer, std::int64_t number) {
  event_t event{};
  event.tick = number;
  std::array<std::byte, kMaxEncodedBytes> encoded{};
  const int size = event.encode(encoded.data(), 0, static_cast<int>(encoded.size()));
  writer.append(number, Channel::kEvent, encoded.data(), static_cast<std::size_t>(size));
}

TEST(TelemetryLogWriter, WritesWhatLcmReadsBackAndKnowsItsSize) {
  const TemporaryFolder folder;
  TelemetryLogWriter writer(folder / "t.lcmlog");
  for (std::int64_t i = 0; i < 10'000; ++i) append_event(writer, i);
  writer.flush();
  const auto events = events_of(folder / "t.lcmlog");
  ASSERT_EQ(events.size(), 10'000U);
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto number = static_cast<std::int64_t>(i);
    EXPECT_EQ(events[i].number, number);
    EXPECT_EQ(events[i].timestamp_us, number);
    EXPECT_EQ(events[i].channel, "SUREFOOT_EVENT");
    EXPECT_EQ(events[i].as<event_t>().tick, number);
  }
  EXPECT_EQ(writer.messages(), 10'000U);
  EXPECT_EQ(writer.bytes(), std::filesystem::file_size(folder / "t.lcmlog"));
}

/// Writes more than the buffers hold, then dies without any clean-up.
[[noreturn]] void write_and_get_killed(const TemporaryFolder& folder) {
  BusLogWriter bus_log(folder / "bus.log");
  TelemetryLogWriter telemetry_log(folder / "t.lcmlog");
  for (std::uint32_t i = 0; i < 10'000; ++i) {
    bus_log.append(i, numbered_frame(i));
    append_event(telemetry_log, i);
  }
  std::raise(SIGKILL);
  std::abort();
}

TEST(LogWritersDeathTest, AKilledProcessLeavesWholeLinesAndWholeEvents) {
  const TemporaryFolder folder;
  EXPECT_EXIT(write_and_get_killed(folder), ::testing::KilledBySignal(SIGKILL), "");

  const std::string lines = contents_of(folder / "bus.log");
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.size() % 40, 0U) << "each of these lines has 40 characters";
  EXPECT_EQ(lines.back(), '\n');

  const auto events = events_of(folder / "t.lcmlog");
  ASSERT_FALSE(events.empty());
  EXPECT_LT(events.size(), 10'000U);
  constexpr std::size_t kEventBytes = 28 + 14 + 57;  // header, "SUREFOOT_EVENT", fingerprint and event_t
  EXPECT_EQ(std::filesystem::file_size(folder / "t.lcmlog"), events.size() * kEventBytes);
}

}  // namespace
}  // namespace surefoot::host
