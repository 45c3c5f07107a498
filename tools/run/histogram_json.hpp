#pragma once

#include <nlohmann/json.hpp>

#include "firmware/host/tick_histogram.hpp"

namespace surefoot::run {

/// The bins that hold something, each as [from_us, to_us, count].
[[nodiscard]] inline nlohmann::ordered_json histogram_json(const host::TickHistogram::Bins& bins) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    if (bins[bin] == 0) continue;
    json.push_back({host::TickHistogram::bin_begin_us(bin), host::TickHistogram::bin_begin_us(bin + 1), bins[bin]});
  }
  return json;
}

/// The same back from another process of this version.
[[nodiscard]] inline host::TickHistogram::Bins bins_of(const nlohmann::json& json) {
  host::TickHistogram::Bins bins{};
  for (const nlohmann::json& entry : json) {
    for (std::size_t bin = 0; bin < bins.size(); ++bin) {
      if (host::TickHistogram::bin_begin_us(bin) == double{entry[0]}) bins[bin] = std::uint64_t{entry[2]};
    }
  }
  return bins;
}

}  // namespace surefoot::run
