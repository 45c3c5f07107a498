#include "firmware/host/bus/udp_datagram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/host/allocation_guard.hpp"
#include "tests/unit/firmware_host/frames.hpp"

namespace surefoot::host {
namespace {

using testing::frame_of;
using Bytes = std::vector<std::byte>;

// What python-can 4.6.1 with msgpack 1.2.4 writes for
//   pack_message(can.Message(arbitration_id=ID, is_extended_id=False, is_fd=True, bitrate_switch=True, data=...))
// of can/interfaces/udp_multicast/utils.py, in the pieces between the values.
constexpr std::string_view kTimestamp = "8ba974696d657374616d70";
constexpr std::string_view kArbitrationId = "ae6172626974726174696f6e5f6964";
constexpr std::string_view kIsExtendedId = "ae69735f657874656e6465645f6964";
constexpr std::string_view kIsRemoteFrame = "af69735f72656d6f74655f6672616d65";
constexpr std::string_view kIsErrorFrame = "ae69735f6572726f725f6672616d65";
constexpr std::string_view kChannelAndDlc = "a76368616e6e656cc0a3646c63";
constexpr std::string_view kData = "a464617461";
constexpr std::string_view kIsFd = "a569735f6664";
constexpr std::string_view kBitrateSwitch = "ae626974726174655f737769746368";
constexpr std::string_view kErrorStateIndicator = "b56572726f725f73746174655f696e64696361746f72c2";

struct Golden {
  std::string timestamp = "cb0000000000000000";
  std::string identifier = "cd0181";
  std::string extended = "c2";
  std::string remote = "c2";
  std::string error = "c2";
  std::string dlc = "00";
  std::string data = "c400";
  std::string fd = "c3";
  std::string bitrate_switch = "c3";

  [[nodiscard]] Bytes bytes() const {
    std::string hex;
    for (const std::string_view part :
         {kTimestamp, std::string_view(timestamp), kArbitrationId, std::string_view(identifier), kIsExtendedId,
          std::string_view(extended), kIsRemoteFrame, std::string_view(remote), kIsErrorFrame, std::string_view(error),
          kChannelAndDlc, std::string_view(dlc), kData, std::string_view(data), kIsFd, std::string_view(fd),
          kBitrateSwitch, std::string_view(bitrate_switch), kErrorStateIndicator}) {
      hex += part;
    }
    Bytes bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2) {
      bytes.push_back(static_cast<std::byte>(std::stoi(hex.substr(i, 2), nullptr, 16)));
    }
    return bytes;
  }
};

/// As python-can writes it at 1700000000.25 s.
Golden of_48_bytes() {
  Golden golden{.timestamp = "cb41d954fc40100000", .dlc = "30"};
  golden.data = "c430000102030405060708090a0b0c0d0e0f101112131415161718191a1b1c1d1e1f202122232425262728292a2b2c2d2e2f";
  return golden;
}

Bytes encoded(const can::CanFrame& frame) {
  Bytes bytes(kMaxDatagramBytes);
  bytes.resize(encode_datagram(frame, bytes));
  return bytes;
}

DatagramKind kind_of(const Bytes& datagram) {
  can::CanFrame frame;
  return DatagramReader().read(datagram, frame);
}

std::vector<std::uint8_t> counting(std::size_t count) {
  std::vector<std::uint8_t> bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i);
  return bytes;
}

// But for the time stamp 0.0, which msgpack for C++ writes as the integer 0.
TEST(UdpDatagram, IsByteForByteWhatPythonCanWrites) {
  EXPECT_EQ(of_48_bytes().bytes().size(), 202U);
  Golden golden = of_48_bytes();
  golden.timestamp = "00";
  EXPECT_EQ(encoded(frame_of(0x181, counting(48))), golden.bytes());
  EXPECT_EQ(encoded(frame_of(0x080, {})), (Golden{.timestamp = "00", .identifier = "cc80"}).bytes());
  std::string ff = "c440";
  for (int i = 0; i < 64; ++i) ff += "ff";
  EXPECT_EQ(encoded(frame_of(0x7FF, std::vector<std::uint8_t>(64, 0xFF))),
            (Golden{.timestamp = "00", .identifier = "cd07ff", .dlc = "40", .data = ff}).bytes());
}

TEST(UdpDatagram, OfPythonCanReadsAsItsFrame) {
  can::CanFrame frame;
  ASSERT_EQ(DatagramReader().read(of_48_bytes().bytes(), frame), DatagramKind::kFrame);
  EXPECT_EQ(frame.identifier, 0x181);
  EXPECT_EQ(frame.length, 48);
  EXPECT_EQ(frame.payload, frame_of(0x181, counting(48)).payload);
}

TEST(UdpDatagram, EveryIdentifierAndLengthComesBack) {
  DatagramReader reader;
  for (const std::size_t length : {0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 12U, 16U, 20U, 24U, 32U, 48U, 64U}) {
    for (std::uint16_t identifier = 0; identifier < 0x800; identifier = static_cast<std::uint16_t>(identifier + 7)) {
      const can::CanFrame sent = frame_of(identifier, counting(length));
      can::CanFrame got;
      ASSERT_EQ(reader.read(encoded(sent), got), DatagramKind::kFrame) << identifier << ' ' << length;
      EXPECT_EQ(got.identifier, identifier);
      EXPECT_EQ(got.length, length);
      EXPECT_EQ(got.payload, sent.payload);
    }
  }
}

TEST(UdpDatagram, OfAnotherShapeIsForeign) {
  EXPECT_EQ(kind_of((Golden{.fd = "c2", .bitrate_switch = "c2"}).bytes()), DatagramKind::kForeign) << "classic";
  EXPECT_EQ(kind_of((Golden{.extended = "c3"}).bytes()), DatagramKind::kForeign) << "extended";
  EXPECT_EQ(kind_of((Golden{.remote = "c3"}).bytes()), DatagramKind::kForeign) << "remote";
  EXPECT_EQ(kind_of((Golden{.identifier = "cd0800"}).bytes()), DatagramKind::kForeign) << "twelve bits";
  EXPECT_EQ(kind_of((Golden{.dlc = "01"}).bytes()), DatagramKind::kForeign) << "length says more than there is";
  EXPECT_EQ(kind_of((Golden{.dlc = "09", .data = "c409000102030405060708"}).bytes()), DatagramKind::kForeign)
      << "CAN FD has no nine bytes";
  EXPECT_EQ(kind_of((Golden{.identifier = "ff"}).bytes()), DatagramKind::kForeign) << "identifier -1";
  EXPECT_EQ(kind_of((Golden{.identifier = "cb4078100000000000"}).bytes()), DatagramKind::kForeign) << "385.0";
  EXPECT_EQ(kind_of((Golden{.fd = "01"}).bytes()), DatagramKind::kForeign) << "1 is no boolean";
  EXPECT_EQ(kind_of((Golden{.data = "a0"}).bytes()), DatagramKind::kForeign) << "text is no data";
  EXPECT_EQ(kind_of((Golden{.data = "90"}).bytes()), DatagramKind::kForeign) << "a list is no data";
  EXPECT_EQ(kind_of((Golden{.error = "c3"}).bytes()), DatagramKind::kErrorFrame);
}

TEST(UdpDatagram, ThatIsCutOrHasMoreBehindItIsForeign) {
  const Bytes whole = of_48_bytes().bytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_EQ(kind_of(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length))),
              DatagramKind::kForeign)
        << length;
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0xC0});
  EXPECT_EQ(kind_of(longer), DatagramKind::kForeign);
}

TEST(UdpDatagram, ThatIsNoMapOrNestsOneIsForeign) {
  for (const char* const text :
       {"", "hello", "\x80", "\x90", "\xC0", "\x81\x81\xC0\xC0\xC0", "\x82\xA5is_fd\x80", "\x81\xA5other\xC3",
        "\xDF\xFF\xFF\xFF\xFF", "\xC6\xFF\xFF\xFF\xFF", "\xC9\xFF\xFF\xFF\xFF\1"}) {
    const std::string_view view(text);
    EXPECT_EQ(kind_of(Bytes(reinterpret_cast<const std::byte*>(view.data()),
                            reinterpret_cast<const std::byte*>(view.data() + view.size()))),
              DatagramKind::kForeign)
        << text;
  }
  EXPECT_EQ(kind_of(Bytes(400, std::byte{0x91})), DatagramKind::kForeign) << "lists in lists";
  EXPECT_EQ(kind_of(Bytes(400, std::byte{0x81})), DatagramKind::kForeign) << "maps in maps";
}

// One reader through it all: what one datagram leaves behind must not colour the next.
TEST(UdpDatagram, GarbageNeitherCrashesNorAllocatesNorSpoilsTheNext) {
  std::mt19937 random(20240607);
  const std::array wholes{of_48_bytes().bytes(), (Golden{.error = "c3"}).bytes(), Golden{}.bytes()};
  const Bytes good = wholes[0];
  DatagramReader reader;
  Bytes datagram;
  datagram.reserve(kMaxDatagramBytes);
  int frames = 0;
  for (int i = 0; i < 100'000; ++i) {
    datagram = wholes[random() % wholes.size()];
    for (std::uint32_t edits = random() % 4; edits > 0; --edits) {
      datagram[random() % datagram.size()] = static_cast<std::byte>(random());
    }
    if (random() % 8 == 0) datagram.resize(random() % kMaxDatagramBytes, static_cast<std::byte>(random()));
    if (random() % 16 == 0) std::ranges::generate(datagram, [&] { return static_cast<std::byte>(random()); });
    can::CanFrame frame{.identifier = 0xFFFF};
    can::CanFrame after;
    allocation_guard::arm();
    const DatagramKind kind = reader.read(datagram, frame);
    const DatagramKind kind_after = reader.read(good, after);
    ASSERT_EQ(allocation_guard::disarm().allocations, 0U);
    ASSERT_EQ(kind_after, DatagramKind::kFrame);
    ASSERT_EQ(after.length, 48);
    if (kind == DatagramKind::kFrame) {
      ++frames;
      ASSERT_LE(frame.identifier, 0x7FF);
      ASSERT_LE(frame.length, 64);
    } else {
      ASSERT_EQ(frame.identifier, 0xFFFF) << "touched though refused";
    }
  }
  EXPECT_GT(frames, 10'000) << "the garbage was too dull";
}

}  // namespace
}  // namespace surefoot::host
