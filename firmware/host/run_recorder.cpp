#include "firmware/host/run_recorder.hpp"

#include <pthread.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <surefoot/run_t.hpp>
#include <utility>

#include "firmware/host/bus_log_writer.hpp"
#include "firmware/host/live_publisher.hpp"
#include "firmware/host/telemetry_log_writer.hpp"

namespace surefoot::host {
namespace {

using std::chrono::steady_clock;

constexpr std::size_t kFramesPerTick = 1024;  // of a bus that somebody floods
constexpr std::size_t kMessagesPerTick = 16;
constexpr std::size_t kFrameBatch = 1024;
constexpr std::size_t kMessageBatch = 128;
constexpr auto kIdle = std::chrono::microseconds(500);
constexpr auto kWaitForRoom = std::chrono::microseconds(50);
constexpr auto kFlushPeriod = std::chrono::milliseconds(400);
constexpr auto kAnnouncePeriod = std::chrono::seconds(1);

/// Blocks all signals of the calling thread, and of threads it starts, while it lives.
class SignalsBlocked {
 public:
  SignalsBlocked() noexcept {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

struct RunRecorder::Writers {
  explicit Writers(const RecorderOptions& options) : bus_log(options.bus_log), telemetry_log(options.telemetry_log) {
    if (!options.live_provider) return;
    live.emplace(*options.live_provider);
    announcement.started_ns = std::chrono::nanoseconds(steady_clock::now().time_since_epoch()).count();
    const std::string folder = std::filesystem::absolute(options.telemetry_log).parent_path().string();
    // A path that does not fit is not told: a cut one would name another folder.
    if (folder.size() < sizeof announcement.folder) std::ranges::copy(folder, announcement.folder);
  }

  /// From the first message on, once a second: who begins to listen in between learns what it listens to.
  void announce() noexcept {
    if (!live || !has_published || steady_clock::now() < announce_next_at) return;
    const int size = announcement.encode(encoded.data(), 0, static_cast<int>(encoded.size()));
    if (size > 0) live->publish(Channel::kRun, encoded.data(), static_cast<std::size_t>(size));
    announce_next_at = steady_clock::now() + kAnnouncePeriod;
  }

  BusLogWriter bus_log;
  TelemetryLogWriter telemetry_log;
  std::optional<LivePublisher> live;
  run_t announcement{};
  steady_clock::time_point announce_next_at{};
  bool has_published = false;
  std::array<std::byte, kMaxEncodedBytes> encoded{};
};

RunRecorder::RunRecorder(const RecorderOptions& options)
    : options_(options),
      frames_(options.frame_slots),
      messages_(options.message_slots),
      writers_(std::make_unique<Writers>(options)) {
  // Signals are the main thread's business; SIGXFSZ blocked turns into EFBIG from write.
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { run(); });
}

RunRecorder::~RunRecorder() {
  is_finishing_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
}

void RunRecorder::on_frame(const can::CanFrame& frame) noexcept {
  frames_.produce([&](StampedFrame& slot) { slot = {.elapsed_us = elapsed_us_, .frame = frame}; });
}

bool RunRecorder::has_room() const noexcept {
  return frames_.room() >= std::min(kFramesPerTick, options_.frame_slots / 2) && messages_.room() >= kMessagesPerTick;
}

void RunRecorder::wait_for_room() const {
  while (!has_room()) std::this_thread::sleep_for(kWaitForRoom);
}

RecordingSummary RunRecorder::finish() {
  is_finishing_.store(true, std::memory_order_release);
  if (thread_.joinable()) thread_.join();
  RecordingSummary summary{.bus_log_sha256 = writers_->bus_log.sha256(),
                           .frames = writers_->bus_log.frames(),
                           .bus_log_bytes = writers_->bus_log.bytes(),
                           .messages = writers_->telemetry_log.messages(),
                           .telemetry_log_bytes = writers_->telemetry_log.bytes(),
                           .frames_dropped = frames_.drops(),
                           .messages_dropped = messages_.drops(),
                           .live_failures = writers_->live ? writers_->live->failures() : 0,
                           .error = std::nullopt};
  if (error() != nullptr) summary.error = *error();
  return summary;
}

void RunRecorder::run() noexcept {
  pthread_setname_np(pthread_self(), "recorder");
  auto flushed_at = steady_clock::now();
  for (bool is_last = false; !is_last;) {
    // Read before draining: what was put in before `finish` is then certainly seen.
    const bool is_finishing = is_finishing_.load(std::memory_order_acquire);
    const bool is_empty = drain();
    writers_->announce();
    is_last = is_finishing && is_empty;
    if (is_last || steady_clock::now() - flushed_at > kFlushPeriod) {
      writers_->bus_log.flush();
      writers_->telemetry_log.flush();
      flushed_at = steady_clock::now();
    }
    latch_errors();
    // One wake-up for many ticks: chasing each frame would fight the loop for its cache lines.
    if (is_empty && !is_last) std::this_thread::sleep_for(kIdle);
  }
}

/// @return true when both rings were emptied
bool RunRecorder::drain() noexcept {
  const std::size_t frames = frames_.consume(
      [this](const StampedFrame& slot) { writers_->bus_log.append(slot.elapsed_us, slot.frame); }, kFrameBatch);
  const std::size_t messages = messages_.consume(
      [this](const TelemetrySlot& slot) {
        std::byte* const encoded = writers_->encoded.data();
        const int size = slot.encode(slot.message.data(), encoded, static_cast<int>(kMaxEncodedBytes));
        if (size < 0) return;
        const auto length = static_cast<std::size_t>(size);
        // Wall-clock figures are for who listens now: in the log they would differ from run to run.
        if (slot.channel != Channel::kTimingStatistics) {
          writers_->telemetry_log.append(slot.utime_us + options_.power_up_before_zero_us, slot.channel, encoded,
                                         length);
        }
        if (!writers_->live) return;
        writers_->live->publish(slot.channel, encoded, length);
        writers_->has_published = true;
      },
      kMessageBatch);
  return frames < kFrameBatch && messages < kMessageBatch;
}

void RunRecorder::latch_errors() noexcept {
  if (error() != nullptr) return;
  const auto latch = [this](std::error_code code, const std::filesystem::path& path) {
    if (!code || error() != nullptr) return;
    first_error_ = {.code = code, .message = path.string() + ": " + code.message()};
    error_.store(&first_error_, std::memory_order_release);
  };
  latch(writers_->bus_log.error(), options_.bus_log);
  latch(writers_->telemetry_log.error(), options_.telemetry_log);
}

}  // namespace surefoot::host
