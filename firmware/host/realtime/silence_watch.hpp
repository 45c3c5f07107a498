#pragma once

#include <algorithm>
#include <cstdint>

namespace surefoot::host {

/// How long the other side has been silent, as one hears it who was awake: of the time between two looks at most a slice
/// counts. A machine that stood still for seconds kept both sides from speaking, and that accuses nobody.
class SilenceWatch {
 public:
  /// @param slice_ns  a little more than the longest time between two looks, > 0
  explicit SilenceWatch(std::int64_t slice_ns) noexcept : slice_ns_(slice_ns) {}

  /// The other side has spoken, or is asked only now.
  void restart(std::int64_t now_ns) noexcept {
    looked_ns_ = now_ns;
    silent_ns_ = 0;
  }

  /// Nothing was heard since the last look.
  /// @return the silence so far
  std::int64_t look(std::int64_t now_ns) noexcept {
    silent_ns_ += std::min(now_ns - looked_ns_, slice_ns_);
    looked_ns_ = now_ns;
    return silent_ns_;
  }

 private:
  std::int64_t slice_ns_;
  std::int64_t looked_ns_ = 0;
  std::int64_t silent_ns_ = 0;
};

}  // namespace surefoot::host
