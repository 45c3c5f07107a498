#include "tools/run/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <vector>

#include "firmware/host/firmware_node.hpp"
#include "tools/run/candump_log.hpp"
#include "tools/scenario/scenario.hpp"

namespace surefoot::run {
namespace {

/// A bus whose other end is a log: gives what the nodes sent, keeps what the controller sends.
class RecordedTick final : public can::CanBus {
 public:
  std::size_t send(std::span<const can::CanFrame> frames) noexcept override {
    sent.insert(sent.end(), frames.begin(), frames.end());
    return frames.size();
  }

  std::size_t receive(std::span<can::CanFrame> frames) noexcept override {
    const std::size_t count = std::min(frames.size(), from_nodes.size() - taken);
    std::copy_n(from_nodes.begin() + static_cast<std::ptrdiff_t>(taken), count, frames.begin());
    taken += count;
    return count;
  }

  void clear() {
    from_nodes.clear();
    from_controller.clear();
    sent.clear();
    taken = 0;
  }

  std::vector<can::CanFrame> from_nodes;
  std::vector<can::CanFrame> from_controller;
  std::vector<can::CanFrame> sent;
  std::size_t taken = 0;
};

bool is_command(const can::CanFrame& frame, can::Node leg) {
  return frame.identifier == can::command_identifier(leg) || frame.identifier == can::position_identifier(leg);
}

bool is_from_controller(const can::CanFrame& frame) {
  return frame.identifier == can::kSyncIdentifier || is_command(frame, can::Node::kLegRight) ||
         is_command(frame, can::Node::kLegLeft) ||
         frame.identifier == can::heartbeat_identifier(can::Node::kController) ||
         frame.identifier == can::emergency_identifier(can::Node::kController);
}

bool are_equal(const can::CanFrame& left, const can::CanFrame& right) {
  return left.identifier == right.identifier && std::ranges::equal(left.bytes(), right.bytes());
}

/// Compares what the firmware sends now with what the controller sent then.
void compare(RecordedTick& tick, ReplayResult& result) {
  result.controller_frames += tick.from_controller.size();
  const std::size_t count = std::max(tick.sent.size(), tick.from_controller.size());
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_same =
        i < tick.sent.size() && i < tick.from_controller.size() && are_equal(tick.sent[i], tick.from_controller[i]);
    if (is_same) continue;
    ++result.differing_frames;
    if (result.first_difference.empty()) {
      const std::uint16_t identifier =
          i < tick.from_controller.size() ? tick.from_controller[i].identifier : tick.sent[i].identifier;
      result.first_difference = fmt::format("tick {}, identifier 0x{:03X}", result.ticks, identifier);
    }
  }
}

/// Before tick 0: the controller's announcements among those of the nodes.
void run_start_up(host::FirmwareNode& firmware, RecordedTick& start_up, ReplayResult& result) {
  firmware.listen(start_up);
  for (std::size_t i = 0; i < start_up.from_controller.size(); ++i) {
    firmware.announce(start_up, can::NodeState::kPreOperational);
  }
  compare(start_up, result);
}

/// @param logged_tick  as SYNC said; ticks before it that were missed on the wall clock are missed again
void run_tick(host::FirmwareNode& firmware, RecordedTick& tick, std::uint32_t logged_tick, ReplayResult& result) {
  while (firmware.next_tick() < logged_tick) firmware.miss_tick();
  firmware.begin_tick(tick);
  static_cast<void>(firmware.collect(tick));
  firmware.finish_tick(tick);
  compare(tick, result);
  ++result.ticks;
}

/// Cuts the log into start-ups and ticks.
class Replay {
 public:
  explicit Replay(const ControllerConfig& config) : config_(config), firmware_(config) {}

  void take(const can::CanFrame& frame) {
    can::FrameStamp stamp;
    if (can::decode_sync(frame, stamp) == can::Rejection::kNone) {
      end_stretch();
      is_in_tick_ = true;
      logged_tick_ = stamp.tick;
    } else if (has_commands_ && frame.identifier == can::heartbeat_identifier(can::Node::kController)) {
      end_stretch();  // announced after the commands, not after SYNC: the firmware has started anew
      firmware_ = host::FirmwareNode(config_);
    }
    (is_from_controller(frame) ? stretch_.from_controller : stretch_.from_nodes).push_back(frame);
    has_commands_ = has_commands_ || is_command(frame, can::Node::kLegLeft);
  }

  [[nodiscard]] ReplayResult finish() {
    result_.ends_in_mid_tick = is_in_tick_ && !has_commands_;
    if (has_commands_) end_stretch();
    return result_;
  }

 private:
  void end_stretch() {
    if (is_in_tick_) {
      run_tick(firmware_, stretch_, logged_tick_, result_);
    } else {
      run_start_up(firmware_, stretch_, result_);
    }
    stretch_.clear();
    is_in_tick_ = false;
    has_commands_ = false;
  }

  const ControllerConfig& config_;
  host::FirmwareNode firmware_;
  RecordedTick stretch_;
  ReplayResult result_;
  std::uint32_t logged_tick_ = 0;
  bool is_in_tick_ = false;
  bool has_commands_ = false;
};

void require_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_directory(status)) return;
  throw RunFolderError(
      fmt::format("{}: there is no such file\n  remedy: give a run folder that `surefoot run` wrote", path.string()));
}

}  // namespace

ReplayResult replay(const std::filesystem::path& run_folder) {
  for (const char* file : {"scenario.toml", "bus.log"}) require_file(run_folder / file);
  const scenario::Scenario scenario = scenario::load(run_folder / "scenario.toml", {});
  CandumpLogReader log(run_folder / "bus.log");
  Replay replay(scenario.firmware);
  while (const std::optional<LoggedFrame> logged = log.next()) replay.take(logged->frame);
  const ReplayResult result = replay.finish();
  if (result.ticks == 0) {
    throw RunFolderError(
        fmt::format("{}: holds no whole tick\n  remedy: run the scenario again", (run_folder / "bus.log").string()));
  }
  return result;
}

}  // namespace surefoot::run
