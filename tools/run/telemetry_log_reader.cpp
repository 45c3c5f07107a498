#include "tools/run/telemetry_log_reader.hpp"

#include <fmt/format.h>
#include <lcm/eventlog.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>
#include <string_view>

#include "firmware/host/telemetry_ring.hpp"

namespace surefoot::run {
namespace {

using EventLog = std::unique_ptr<lcm_eventlog_t, void (*)(lcm_eventlog_t*)>;
using Event = std::unique_ptr<lcm_eventlog_event_t, void (*)(lcm_eventlog_event_t*)>;

EventLog open_log(const std::filesystem::path& path, const char* mode) {
  EventLog log(lcm_eventlog_create(path.c_str(), mode), lcm_eventlog_destroy);
  if (log) return log;
  throw TelemetryLogError(
      fmt::format("{}: {}\n  remedy: give a run folder that `surefoot` wrote", path.string(), std::strerror(errno)));
}

Event next_event(lcm_eventlog_t* log) { return {lcm_eventlog_read_next_event(log), lcm_eventlog_free_event}; }

template <class Message>
void append(const lcm_eventlog_event_t& event, const std::filesystem::path& path, std::vector<Message>& messages) {
  Message message{};
  if (message.decode(event.data, 0, static_cast<int>(event.datalen)) < 0) {
    throw TelemetryLogError(
        fmt::format("{}: event {} on {} is of another version of lcm_types\n  remedy: read it with "
                    "the version that wrote it",
                    path.string(), event.eventnum, event.channel));
  }
  messages.push_back(message);
}

}  // namespace

TelemetryLog read_telemetry_log(const std::filesystem::path& path) {
  const EventLog log = open_log(path, "r");
  TelemetryLog telemetry;
  while (const Event event = next_event(log.get())) {
    const std::string_view channel(event->channel, static_cast<std::size_t>(event->channellen));
    if (channel == host::name(host::Channel::kControllerState)) append(*event, path, telemetry.states);
    if (channel == host::name(host::Channel::kSimulatorTruth)) append(*event, path, telemetry.truths);
    if (channel == host::name(host::Channel::kEvent)) append(*event, path, telemetry.events);
  }
  return telemetry;
}

void merge_telemetry_logs(const std::vector<std::filesystem::path>& from, const std::filesystem::path& to) {
  std::vector<EventLog> logs;
  std::vector<Event> heads;
  for (const std::filesystem::path& path : from) {
    logs.push_back(open_log(path, "r"));
    heads.push_back(next_event(logs.back().get()));
  }
  const EventLog merged = open_log(to, "w");
  while (true) {
    const auto earliest = std::ranges::min_element(heads, [](const Event& left, const Event& right) {
      return left && (!right || left->timestamp < right->timestamp);
    });
    if (earliest == heads.end() || !*earliest) return;
    if (lcm_eventlog_write_event(merged.get(), earliest->get()) != 0) {
      throw TelemetryLogError(fmt::format("{}: {}\n  remedy: free disk space", to.string(), std::strerror(errno)));
    }
    *earliest = next_event(logs[static_cast<std::size_t>(earliest - heads.begin())].get());
  }
}

}  // namespace surefoot::run
