#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace surefoot::host {

/// Why a bus could not be opened; the text names the remedy.
class BusError : public std::runtime_error {
 public:
  enum class Cause : std::uint8_t {
    kBadAddress,    ///< the text: exit code 65
    kMachineLacks,  ///< interface, kernel, permission, route: exit code 69
  };

  /// @param what    "vcan9: no such interface"
  /// @param remedy  goes on a line of its own, "  remedy: ..."
  BusError(Cause cause, const std::string& what, const std::string& remedy)
      : std::runtime_error(what + "\n  remedy: " + remedy), cause_(cause) {}

  [[nodiscard]] Cause cause() const noexcept { return cause_; }

 private:
  Cause cause_;
};

}  // namespace surefoot::host
