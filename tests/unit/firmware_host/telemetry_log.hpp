#pragma once

#include <cstdint>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <string>
#include <vector>

namespace surefoot::host::testing {

struct LoggedEvent {
  std::int64_t number;
  std::int64_t timestamp_us;
  std::string channel;
  std::vector<char> encoded;

  /// The event as a message; throws when it is another type or cut short.
  template <class Message>
  [[nodiscard]] Message as() const {
    Message message;
    const int size = static_cast<int>(encoded.size());
    if (message.decode(encoded.data(), 0, size) != size) throw std::runtime_error("not a whole " + channel);
    return message;
  }
};

/// Everything that LCM's own reader finds in a log.
inline std::vector<LoggedEvent> events_of(const std::filesystem::path& path) {
  std::vector<LoggedEvent> events;
  lcm::LogFile log(path.string(), "r");
  while (const lcm::LogEvent* const event = log.readNextEvent()) {
    const char* const bytes = static_cast<const char*>(event->data);
    events.push_back({event->eventnum, event->timestamp, event->channel, {bytes, bytes + event->datalen}});
  }
  return events;
}

}  // namespace surefoot::host::testing
