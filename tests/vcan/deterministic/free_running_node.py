"""A node that runs freely at 1 kHz on CAN FD: free_running_node.py IDENTIFIER FRAMES

Each frame holds its number, the node's clock, and how many frames it has received by then: an order of events that
differs by one is seen in the log.
"""

import socket
import struct
import sys
import time

_FIRST_TICK_NS = 1_600_000_005_000_000_000  # guests begin at 1.6e9 s
_PERIOD_NS = 1_000_000
_CAN_RAW_FD_FRAMES = 5
_HEADER = struct.Struct("=IBBxx")


def main(identifier: int, frames: int) -> None:
    received = 0
    with socket.socket(socket.AF_CAN, socket.SOCK_RAW, socket.CAN_RAW) as bus:
        bus.setsockopt(socket.SOL_CAN_RAW, _CAN_RAW_FD_FRAMES, 1)
        bus.bind(("vcan0",))
        bus.setblocking(False)
        for k in range(frames):
            while (wait_ns := _FIRST_TICK_NS + k * _PERIOD_NS - time.time_ns()) > 0:
                time.sleep(wait_ns / 1e9)
            try:
                while bus.recv(72):
                    received += 1
            except BlockingIOError:
                pass
            payload = struct.pack("<IIQ", k, received, time.time_ns()).ljust(64, b"\x5a")
            bus.send(_HEADER.pack(identifier, len(payload), 1) + payload)


if __name__ == "__main__":
    main(int(sys.argv[1], 16), int(sys.argv[2]))
