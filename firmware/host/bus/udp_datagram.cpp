#include "firmware/host/bus/udp_datagram.hpp"

#define MSGPACK_NO_BOOST
#include <algorithm>
#include <array>
#include <cstring>
#include <msgpack.hpp>
#include <string_view>

#include "firmware/host/bus/frame_length.hpp"

namespace surefoot::host {
namespace {

constexpr std::uint64_t kMaxIdentifier = 0x7FF;

/// Where msgpack packs to.
struct FixedBuffer {
  std::span<std::byte> bytes;
  std::size_t used = 0;

  void write(const char* data, std::size_t size) noexcept {
    std::memcpy(bytes.data() + used, data, size);
    used += size;
  }
};

class MapPacker {
 public:
  MapPacker(FixedBuffer& buffer, std::uint32_t fields) : packer_(buffer) { packer_.pack_map(fields); }

  template <typename Value>
  MapPacker& field(std::string_view name, const Value& value) {
    key(name);
    packer_.pack(value);
    return *this;
  }
  MapPacker& bytes(std::string_view name, std::span<const std::uint8_t> value) {
    key(name);
    const auto size = static_cast<std::uint32_t>(value.size());
    packer_.pack_bin(size).pack_bin_body(reinterpret_cast<const char*>(value.data()), size);
    return *this;
  }

 private:
  void key(std::string_view name) {
    const auto size = static_cast<std::uint32_t>(name.size());
    packer_.pack_str(size).pack_str_body(name.data(), size);
  }

  msgpack::packer<FixedBuffer> packer_;
};

enum class Field : std::uint8_t {
  kTimestamp,
  kArbitrationId,
  kIsExtendedId,
  kIsRemoteFrame,
  kIsErrorFrame,
  kChannel,
  kDlc,
  kData,
  kIsFd,
  kBitrateSwitch,
  kErrorStateIndicator,
};

constexpr std::array<std::string_view, 11> kFieldNames{
    "timestamp", "arbitration_id", "is_extended_id", "is_remote_frame", "is_error_frame",       "channel",
    "dlc",       "data",           "is_fd",          "bitrate_switch",  "error_state_indicator"};

constexpr std::string_view name_of(Field field) { return kFieldNames[static_cast<std::size_t>(field)]; }

/// Follows msgpack's parser through one map of scalars; anything nested stops it, so its stack never grows.
class FrameVisitor : public msgpack::null_visitor {
 public:
  void init() noexcept { *this = FrameVisitor(); }

  [[nodiscard]] DatagramKind result(can::CanFrame& frame) const noexcept {
    if (is_error_frame_) return DatagramKind::kErrorFrame;
    if (!has_identifier_ || is_extended_ || is_remote_ || !is_fd_ || (has_dlc_ && dlc_ != data_.size())) {
      return DatagramKind::kForeign;
    }
    if (identifier_ > kMaxIdentifier || !is_fd_length(data_.size())) return DatagramKind::kForeign;
    frame = {.identifier = static_cast<std::uint16_t>(identifier_), .length = static_cast<std::uint8_t>(data_.size())};
    std::ranges::copy(data_, reinterpret_cast<char*>(frame.payload.data()));
    return DatagramKind::kFrame;
  }

  // What msgpack's parser calls; false stops it.
  bool start_map(std::uint32_t /*fields*/) noexcept { return !std::exchange(is_inside_, true); }
  bool start_array(std::uint32_t /*items*/) noexcept { return false; }
  bool start_map_key() noexcept { return is_key_ = true; }
  bool end_map_key() noexcept { return is_inside_; }
  bool start_map_value() noexcept {
    is_key_ = false;
    return true;
  }
  bool visit_nil() noexcept { return is_value_of(Field::kChannel); }
  bool visit_boolean(bool value) noexcept {
    if (!is_value()) return false;
    bool* const flag = flag_of(field_);
    if (flag != nullptr) *flag = value;
    return flag != nullptr;
  }
  bool visit_positive_integer(std::uint64_t value) noexcept {
    if (is_value_of(Field::kArbitrationId)) {
      identifier_ = value;
      return has_identifier_ = true;
    }
    if (is_value_of(Field::kDlc)) {
      dlc_ = value;
      return has_dlc_ = true;
    }
    return is_value_of(Field::kTimestamp) || is_value_of(Field::kChannel);
  }
  bool visit_negative_integer(std::int64_t /*value*/) noexcept { return false; }
  bool visit_float32(float /*value*/) noexcept { return is_value_of(Field::kTimestamp); }
  bool visit_float64(double /*value*/) noexcept { return is_value_of(Field::kTimestamp); }
  bool visit_str(const char* text, std::uint32_t size) noexcept {
    if (is_value()) return is_value_of(Field::kChannel);
    const auto* const name = std::ranges::find(kFieldNames, std::string_view(text, size));
    field_ = static_cast<Field>(name - kFieldNames.begin());
    return is_inside_ && name != kFieldNames.end();
  }
  bool visit_bin(const char* bytes, std::uint32_t size) noexcept {
    data_ = {bytes, size};
    return is_value_of(Field::kData);
  }
  bool visit_ext(const char* /*bytes*/, std::uint32_t /*size*/) noexcept { return false; }

 private:
  [[nodiscard]] bool is_value() const noexcept { return is_inside_ && !is_key_; }
  [[nodiscard]] bool is_value_of(Field field) const noexcept { return is_value() && field_ == field; }
  [[nodiscard]] bool* flag_of(Field field) noexcept {
    switch (field) {
      case Field::kIsExtendedId:
        return &is_extended_;
      case Field::kIsRemoteFrame:
        return &is_remote_;
      case Field::kIsErrorFrame:
        return &is_error_frame_;
      case Field::kIsFd:
        return &is_fd_;
      case Field::kBitrateSwitch:
      case Field::kErrorStateIndicator:
        return &ignored_;
      default:
        return nullptr;
    }
  }

  bool is_inside_ = false;
  bool is_key_ = false;
  Field field_ = Field::kTimestamp;
  // The defaults of python-can's Message.
  bool has_identifier_ = false;
  bool has_dlc_ = false;
  bool is_extended_ = true;
  bool is_remote_ = false;
  bool is_error_frame_ = false;
  bool is_fd_ = false;
  bool ignored_ = false;
  std::uint64_t identifier_ = 0;
  std::uint64_t dlc_ = 0;
  std::string_view data_{};  // in the datagram
};

}  // namespace

std::size_t encode_datagram(const can::CanFrame& frame, std::span<std::byte> datagram) noexcept {
  FixedBuffer buffer{.bytes = datagram};
  MapPacker(buffer, kFieldNames.size())
      .field(name_of(Field::kTimestamp), 0.0)
      .field(name_of(Field::kArbitrationId), frame.identifier)
      .field(name_of(Field::kIsExtendedId), false)
      .field(name_of(Field::kIsRemoteFrame), false)
      .field(name_of(Field::kIsErrorFrame), false)
      .field(name_of(Field::kChannel), msgpack::type::nil_t())
      .field(name_of(Field::kDlc), frame.length)
      .bytes(name_of(Field::kData), frame.bytes())
      .field(name_of(Field::kIsFd), true)
      .field(name_of(Field::kBitrateSwitch), true)
      .field(name_of(Field::kErrorStateIndicator), false);
  return buffer.used;
}

// The parser below `msgpack::parse`, kept: that one takes memory for its stack at every call.
class DatagramReader::Parser {
 public:
  [[nodiscard]] DatagramKind read(std::span<const std::byte> datagram, can::CanFrame& frame) noexcept {
    if (datagram.empty()) return DatagramKind::kForeign;
    helper_.init();
    std::size_t used = 0;
    const auto outcome = helper_.execute(reinterpret_cast<const char*>(datagram.data()), datagram.size(), used);
    const bool is_whole = outcome == msgpack::PARSE_SUCCESS && used == datagram.size();
    return is_whole ? visitor_.result(frame) : DatagramKind::kForeign;
  }

 private:
  FrameVisitor visitor_;
  msgpack::detail::parse_helper<FrameVisitor> helper_{visitor_};
};

DatagramReader::DatagramReader() : parser_(std::make_unique<Parser>()) {}

DatagramReader::~DatagramReader() = default;

DatagramKind DatagramReader::read(std::span<const std::byte> datagram, can::CanFrame& frame) noexcept {
  return parser_->read(datagram, frame);
}

}  // namespace surefoot::host
