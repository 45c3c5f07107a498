#include "firmware/can/counter_watch.hpp"

namespace surefoot::can {

Rejection CounterWatch::step(std::uint8_t counter) noexcept {
  const auto advance = static_cast<std::uint8_t>(counter - last_);  // modulo 256, as the counter runs
  if (was_heard_ && advance == 0) return Rejection::kRepeated;
  if (was_heard_) lost_ += advance - 1U;
  last_ = counter;
  was_heard_ = true;
  return Rejection::kNone;
}

}  // namespace surefoot::can
