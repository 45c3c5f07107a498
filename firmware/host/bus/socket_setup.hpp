#pragma once

#include <string>

#include "firmware/host/bus/file_descriptor.hpp"

namespace surefoot::host {

/// Sets an option of type int. @return false and errno where the kernel refuses
[[nodiscard]] bool set_option(int socket, int level, int option, int value) noexcept;

/// Receive buffer for about a second of a full bus, kernel time stamps and the count of overflows. What the
/// kernel refuses stays as it is: each is a comfort.
void prepare_receiving(int socket) noexcept;

/// "Operation not permitted"
[[nodiscard]] std::string error_text(int error);

}  // namespace surefoot::host
