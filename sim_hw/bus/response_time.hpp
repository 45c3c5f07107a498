#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace surefoot::sim_hw {

/// One stream of frames with one identifier, as the analysis sees it. Times in ns.
struct AnalysedMessage {
  std::uint16_t identifier = 0;      ///< priority: the lower, the more urgent; each stream has its own
  std::int64_t transmission_ns = 0;  ///< C: longest time on the wire, intermission included; above 0
  std::int64_t period_ns = 0;        ///< T: shortest time between the events that cause two frames; above 0
  std::int64_t jitter_ns = 0;        ///< J: longest time from the event to the frame being queued; 0 and up
};

/// What the analysis says of one stream.
struct ResponseTime {
  std::int64_t worst_ns = 0;        ///< R: from the event to the end of the frame
  std::int64_t blocking_ns = 0;     ///< B: longest frame of lower priority, which may just have begun
  std::int64_t busy_period_ns = 0;  ///< t: longest time that the bus is busy at this priority or above
  std::int64_t instances = 1;       ///< Q: frames of this stream that become ready in it
  std::int64_t worst_instance = 0;  ///< the q, counted from 0, whose response is the worst
};

/// Worst-case response times on a CAN bus without errors, for whatever phasing of the streams:
/// non-preemptive, fixed priority, every instance in the busy period examined. (Tindell's analysis of 1994
/// looks at the first instance only and can be too low.)
/// Source: Davis, Burns, Bril, Lukkien 2007, "Controller Area Network (CAN) schedulability analysis:
/// Refuted, revisited and revised", the revised analysis; the names are its symbols.
///
/// @param bit_ns  time of one arbitration bit (tau_bit)
/// @return one for each message, in their order; nothing where the response has no bound: this stream and
///         those above it need the whole bus or more
/// @throws std::invalid_argument at a time out of its range, or two streams of one identifier
[[nodiscard]] std::vector<std::optional<ResponseTime>> response_times(std::span<const AnalysedMessage> messages,
                                                                      std::int64_t bit_ns);

}  // namespace surefoot::sim_hw
