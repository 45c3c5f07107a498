"""Talks to bus_echo through python-can: udp_bus_client.py BUS_ECHO ADDRESS GROUP PORT. Prints what the echo counted."""

import random
import socket
import subprocess
import sys

import can

_LENGTHS = (0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64)
_TIMEOUT_S = 20.0


def _fd_frame(identifier: int, data: bytes) -> can.Message:
    return can.Message(arbitration_id=identifier, is_extended_id=False, is_fd=True, bitrate_switch=True, data=data)


def _hear(bus: can.BusABC, identifier: int) -> can.Message:
    """The next frame of that identifier: python-can hears what it sent itself as well."""
    while True:
        message = bus.recv(_TIMEOUT_S)
        assert message is not None, f"no answer {identifier:#x}"
        if message.arbitration_id == identifier:
            return message


def _exchange(group: str, port: int) -> None:
    random.seed(1)
    with can.Bus(interface="udp_multicast", channel=group, port=port, fd=True) as bus:
        for index, length in enumerate(_LENGTHS):
            data = random.randbytes(length)
            identifier = 2 * index + 0x100
            bus.send(_fd_frame(identifier, data))
            answer = _hear(bus, identifier + 1)
            assert bytes(answer.data) == data[::-1] and answer.dlc == length
            assert answer.is_fd and answer.bitrate_switch
            assert not (answer.is_extended_id or answer.is_remote_frame or answer.is_error_frame)


def _send_what_is_foreign(group: str, port: int) -> None:
    """On a bus of its own: python-can chokes on garbage that comes back to it."""
    with can.Bus(interface="udp_multicast", channel=group, port=port, fd=True) as bus:
        bus.send(can.Message(arbitration_id=0x181, is_extended_id=False, data=b"\1\2"))
        bus.send(can.Message(arbitration_id=0x181, is_extended_id=True, is_fd=True, data=b"\1\2"))
        bus.send(can.Message(arbitration_id=0x181, is_extended_id=False, is_remote_frame=True, dlc=2))
        bus.send(can.Message(arbitration_id=0x40, is_extended_id=False, is_error_frame=True))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        for garbage in (b"", b"\x8bgarbage"):
            stranger.sendto(garbage, (group, port))


def main() -> None:
    bus_echo, address, group, port = sys.argv[1:]
    with subprocess.Popen([bus_echo, address], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as echo:
        assert echo.stdout.readline() == "ready\n"
        _exchange(group, int(port))
        _send_what_is_foreign(group, int(port))
        _exchange(group, int(port))  # answered after all of that was read
        totals, _ = echo.communicate("", timeout=_TIMEOUT_S)
    assert echo.returncode == 0
    sys.stdout.write(totals)


if __name__ == "__main__":
    main()
