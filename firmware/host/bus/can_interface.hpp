#pragma once

#include <string>

#include "firmware/host/bus/file_descriptor.hpp"
#include "firmware/host/bus/host_bus.hpp"

namespace surefoot::host {

/// Opens a non-blocking raw socket for CAN FD on an interface that is up, with the kernel filters of a role
/// and all classes of error frames.
/// @throws BusError  kernel without CAN, no permission, no such interface, not CAN, not FD-capable, down
[[nodiscard]] FileDescriptor open_can_socket(const std::string& interface, BusRole role);

/// Binds the socket to the interface of that name, which may have gone and come again; bound to it
/// already, nothing changes. Drops the error that the socket kept of the outage.
/// @return true when the interface is there, FD-capable and up
[[nodiscard]] bool attach_again(int socket, const std::string& interface, BusRole role) noexcept;

}  // namespace surefoot::host
