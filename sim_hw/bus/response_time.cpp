#include "sim_hw/bus/response_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace surefoot::sim_hw {
namespace {

constexpr std::int64_t kLongestBusyPeriod_ns = 3'600'000'000'000;  // beyond an hour it is without bound

constexpr std::int64_t ceil_div(std::int64_t dividend, std::int64_t divisor) noexcept {
  return (dividend + divisor - 1) / divisor;
}

void check(std::span<const AnalysedMessage> messages, std::int64_t bit_ns) {
  if (bit_ns <= 0) throw std::invalid_argument(fmt::format("a bit of {} ns; expected more than 0", bit_ns));
  for (const AnalysedMessage& message : messages) {
    if (message.transmission_ns <= 0 || message.period_ns <= 0 || message.jitter_ns < 0) {
      throw std::invalid_argument(
          fmt::format("message {:03X}: transmission {} ns, period {} ns, jitter {} ns; expected more than 0, and no "
                      "negative jitter",
                      message.identifier, message.transmission_ns, message.period_ns, message.jitter_ns));
    }
    const auto has_identifier = [&](const AnalysedMessage& other) { return other.identifier == message.identifier; };
    if (std::ranges::count_if(messages, has_identifier) > 1) {
      throw std::invalid_argument(fmt::format("identifier {:03X} stands for two messages", message.identifier));
    }
  }
}

/// The streams of higher priority than one, and that one's blocking.
struct Competition {
  std::vector<AnalysedMessage> higher;
  std::int64_t blocking_ns = 0;

  Competition(std::span<const AnalysedMessage> messages, const AnalysedMessage& of) {
    for (const AnalysedMessage& other : messages) {
      if (other.identifier < of.identifier) higher.push_back(other);
      if (other.identifier > of.identifier) blocking_ns = std::max(blocking_ns, other.transmission_ns);
    }
  }

  /// Bus time that frames of higher priority take while they keep one waiting for `waited_ns`.
  [[nodiscard]] std::int64_t interference_ns(std::int64_t waited_ns) const noexcept {
    std::int64_t sum_ns = 0;
    for (const AnalysedMessage& other : higher) {
      sum_ns += ceil_div(waited_ns + other.jitter_ns, other.period_ns) * other.transmission_ns;
    }
    return sum_ns;
  }
};

/// Grows `value` by `next` until it stays, or passes the bound.
template <typename Next>
std::optional<std::int64_t> fixed_point(std::int64_t value, Next next) {
  while (value <= kLongestBusyPeriod_ns) {
    const std::int64_t grown = next(value);
    if (grown == value) return value;
    value = grown;
  }
  return std::nullopt;
}

/// With this much or more of the bus taken, the busy period never ends.
bool needs_more_than_the_bus(const Competition& competition, const AnalysedMessage& message) noexcept {
  const auto share = [](const AnalysedMessage& m) {
    return static_cast<long double>(m.transmission_ns) / static_cast<long double>(m.period_ns);
  };
  long double utilisation = share(message);
  for (const AnalysedMessage& other : competition.higher) utilisation += share(other);
  const bool may_end = utilisation < 1.0L - 1e-9L;
  return !may_end;
}

std::optional<ResponseTime> response_time(std::span<const AnalysedMessage> messages, const AnalysedMessage& message,
                                          std::int64_t bit_ns) {
  const Competition competition(messages, message);
  if (needs_more_than_the_bus(competition, message)) return std::nullopt;

  const auto busy_period = fixed_point(message.transmission_ns, [&](std::int64_t t_ns) {
    return competition.blocking_ns + competition.interference_ns(t_ns) +
           ceil_div(t_ns + message.jitter_ns, message.period_ns) * message.transmission_ns;
  });
  if (!busy_period) return std::nullopt;

  ResponseTime response{.blocking_ns = competition.blocking_ns, .busy_period_ns = *busy_period};
  response.instances = ceil_div(*busy_period + message.jitter_ns, message.period_ns);
  std::int64_t waited_ns = competition.blocking_ns;
  for (std::int64_t q = 0; q < response.instances; ++q) {
    const std::int64_t own_ns = q * message.transmission_ns;
    const auto queued = fixed_point(std::max(waited_ns, competition.blocking_ns + own_ns), [&](std::int64_t w_ns) {
      return competition.blocking_ns + own_ns + competition.interference_ns(w_ns + bit_ns);
    });
    if (!queued) return std::nullopt;
    const std::int64_t worst_ns = message.jitter_ns + *queued - q * message.period_ns + message.transmission_ns;
    if (worst_ns > response.worst_ns) {
      response.worst_ns = worst_ns;
      response.worst_instance = q;
    }
    waited_ns = *queued + message.transmission_ns;
  }
  return response;
}

}  // namespace

std::vector<std::optional<ResponseTime>> response_times(std::span<const AnalysedMessage> messages,
                                                        std::int64_t bit_ns) {
  check(messages, bit_ns);
  std::vector<std::optional<ResponseTime>> responses;
  for (const AnalysedMessage& message : messages) {
    responses.push_back(response_time(messages, message, bit_ns));
  }
  return responses;
}

}  // namespace surefoot::sim_hw
