#include "tools/run/fault_teller.hpp"

#include <fmt/format.h>

#include <chrono>
#include <utility>

namespace surefoot::run {

FaultTeller::FaultTeller(std::function<void(const std::string&)> say)
    : say_(std::move(say)), thread_([this](const std::stop_token& stop) {
        for (; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(50))) tell();
      }) {}

void FaultTeller::on_tick(safety::Fault fault) noexcept {
  if (fault == latched_) return;
  latched_ = fault;
  untold_.store(fault, std::memory_order_relaxed);
}

void FaultTeller::tell() {
  const safety::Fault fault = untold_.exchange(safety::Fault::kNone, std::memory_order_relaxed);
  if (fault == safety::Fault::kNone || !say_) return;
  say_(fmt::format("fault {} ({}) latched; see firmware/FAULTS.md", static_cast<int>(fault), safety::name(fault)));
}

}  // namespace surefoot::run
