#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "firmware/can/can_frame.hpp"
#include "firmware/host/memory_bus.hpp"
#include "firmware/host/spsc_ring.hpp"
#include "firmware/host/telemetry_ring.hpp"

namespace surefoot::host {

/// Where a run is recorded.
struct RecorderOptions {
  std::filesystem::path bus_log{};             ///< CAN frames, text as of `candump -L`
  std::filesystem::path telemetry_log{};       ///< LCM event log
  std::int64_t power_up_before_zero_us = 0;    ///< added to a message's utime to give time since power-up
  std::optional<std::string> live_provider{};  ///< LCM URL, `LivePublisher::kLocalProvider`; nothing: no live telemetry
  std::size_t frame_slots = 8192;              ///< power of two; 0.9 s of 9 frames at 1 kHz
  std::size_t message_slots = 1024;            ///< power of two; 0.3 s of 3 messages at 1 kHz
};

/// The first thing that went wrong with a file.
struct RecordingError {
  std::error_code code;
  std::string message;  ///< "runs/1/bus.log: No space left on device"
};

/// What a recording amounts to.
struct RecordingSummary {
  std::string bus_log_sha256;  ///< of the file as it is, 64 hexadecimal digits
  std::uint64_t frames = 0;    ///< in bus.log
  std::uint64_t bus_log_bytes = 0;
  std::uint64_t messages = 0;  ///< in the telemetry log
  std::uint64_t telemetry_log_bytes = 0;
  std::uint64_t frames_dropped = 0;  ///< found the ring full
  std::uint64_t messages_dropped = 0;
  std::uint64_t live_failures = 0;  ///< messages that LCM could not send
  std::optional<RecordingError> error;
};

/// Records a run: the loop's thread puts frames and messages into two rings, an own thread formats,
/// encodes, hashes, writes and publishes them. Nothing that the loop's thread calls between
/// construction and `finish` allocates, blocks or calls the system, `wait_for_room` excepted.
///
/// The files hold whole lines and whole events at any time and lag by half a second of wall time at
/// most, so that a killed process leaves valid, shorter ones. After a write error (disk full, file
/// size limit) the file that met it keeps what it has, and the rest of the run is drained into nothing.
class RunRecorder final : public BusTap {
 public:
  /// Create it before the calling thread turns real-time: the own thread inherits its scheduling.
  /// @throws std::system_error naming the path when a file can not be made
  /// @throws std::runtime_error when live telemetry can not be opened
  explicit RunRecorder(const RecorderOptions& options);
  ~RunRecorder() override;
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;

  /// Time since power-up that the frames from now on carry, >= 0.
  void set_elapsed(std::int64_t elapsed_us) noexcept { elapsed_us_ = elapsed_us; }

  /// A frame for bus.log; a full ring drops and counts it.
  void on_frame(const can::CanFrame& frame) noexcept override;

  /// A generated LCM struct for the telemetry log and for live listeners.
  /// @param utime_us  scenario clock, may be negative
  /// @return false when the ring was full: dropped and counted
  template <class Message>
  bool push(Channel channel, std::int64_t utime_us, const Message& message) noexcept {
    return host::push(messages_, channel, utime_us, message);
  }

  /// True while the rings hold one more tick for certain: 64 frames and 16 messages.
  [[nodiscard]] bool has_room() const noexcept;

  /// Sleeps until `has_room`. For a lockstep driver between two ticks, never inside one; with it
  /// nothing is ever dropped in lockstep.
  void wait_for_room() const;

  /// The first write error, or null while all is well. The driver polls it.
  [[nodiscard]] const RecordingError* error() const noexcept { return error_.load(std::memory_order_acquire); }

  /// Brings everything into the files and ends the own thread. A second call gives the same summary.
  RecordingSummary finish();

 private:
  struct StampedFrame {
    std::int64_t elapsed_us;
    can::CanFrame frame;
  };
  struct Writers;

  void run() noexcept;
  [[nodiscard]] bool drain() noexcept;
  void latch_errors() noexcept;

  RecorderOptions options_;
  SpscRing<StampedFrame> frames_;
  TelemetryRing messages_;
  std::int64_t elapsed_us_ = 0;
  std::unique_ptr<Writers> writers_;  ///< the own thread's alone until it has ended
  RecordingError first_error_;        ///< written once, before `error_` points to it
  std::atomic<const RecordingError*> error_{nullptr};
  std::atomic<bool> is_finishing_{false};
  std::thread thread_;
};

}  // namespace surefoot::host
