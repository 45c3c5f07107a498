"""The network of tools/with-vcan, seen from inside: can-utils, python-can, multicast, and what else programs expect."""

import multiprocessing.shared_memory
import os
import pty
import socket
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import can
import pytest

_FRAMES = ["123#", "7FF#0011223344556677", "1F334455#AA", "123##1" + "5A" * 64, "080##0", "1F334455##3" + "C3" * 48]


@contextmanager
def candump(interface: str, count: int) -> Iterator[subprocess.Popen]:
    """A candump of so many frames that is known to listen."""
    before = _receivers(interface)
    with subprocess.Popen(["candump", "-L", "-n", str(count), interface], stdout=-1, text=True) as process:
        while _receivers(interface) == before:
            assert process.poll() is None
        yield process


def _receivers(interface: str) -> int:
    """Sockets that take every frame of the interface."""
    text = Path("/proc/net/can/rcvlist_all").read_text()
    return sum(line.split()[0] == interface for line in text.splitlines() if line.split())


def _send(interface: str, frame: str) -> None:
    subprocess.run(["cansend", interface, frame], check=True)


def _without_fdf(frame: str) -> str:
    """Newer kernels set the flag CANFD_FDF (4) in every CAN FD frame."""
    name, mark, rest = frame.partition("##")
    return f"{name}{mark}{int(rest[0], 16) & ~4:X}{rest[1:]}" if mark else frame


def _frames(log: str) -> list[str]:
    return [line.split()[2] for line in log.splitlines()]


def test_every_kind_of_frame_goes_from_cansend_to_candump():
    with candump("vcan0", len(_FRAMES)) as dump:
        for frame in _FRAMES:
            _send("vcan0", frame)
        log, _ = dump.communicate(timeout=60)
    assert [_without_fdf(frame) for frame in _frames(log)] == _FRAMES


def test_canplayer_replays_a_log_of_can_fd_frames(tmp_path: Path):
    log = tmp_path / "bus.log"
    lines = [f"({k * 0.001:.6f}) can0 {0x100 + k:03X}##1{k % 256:02X}{'77' * 63}\n" for k in range(200)]
    log.write_text("".join(lines))
    with candump("vcan0", len(lines)) as dump:
        subprocess.run(["canplayer", "-t", "-I", str(log), "vcan0=can0"], check=True)
        replayed, _ = dump.communicate(timeout=60)
    assert [_without_fdf(frame) for frame in _frames(replayed)] == _frames("".join(lines))


def test_python_can_and_can_utils_understand_each_other():
    payload = bytes(range(64))
    with can.Bus(interface="socketcan", channel="vcan0", fd=True) as bus:
        with candump("vcan0", 1) as dump:
            fast = {"is_fd": True, "bitrate_switch": True, "is_extended_id": False}
            bus.send(can.Message(arbitration_id=0x201, data=payload, **fast))
            log, _ = dump.communicate(timeout=60)
        assert log.split()[2].startswith("201##") and log.split()[2].endswith(payload.hex().upper())
        _send("vcan0", "181##1" + payload.hex())
        message = bus.recv(timeout=60)
    assert (message.arbitration_id, message.is_fd, message.bitrate_switch) == (0x181, True, True)
    assert bytes(message.data) == payload


@pytest.mark.skipif(not Path("/sys/class/net/vcan1").exists(), reason="one interface only")
def test_interfaces_are_separate_networks():
    channels = ["vcan0", "vcan1", "vcan1"]
    first, second, listener = (can.Bus(interface="socketcan", channel=channel) for channel in channels)
    with first, second, listener:
        first.send(can.Message(arbitration_id=1, is_extended_id=False))
        second.send(can.Message(arbitration_id=2, is_extended_id=False))
        assert listener.recv(timeout=60).arbitration_id == 2


def test_multicast_comes_back_over_loopback():
    group, port = "239.255.76.67", 17667
    receiver, sender = (socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2))
    with receiver, sender:
        receiver.bind((group, port))
        membership = socket.inet_aton(group) + socket.inet_aton("0.0.0.0")
        receiver.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, membership)
        receiver.settimeout(60)
        sender.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, 0)
        sender.sendto(b"telemetry", (group, port))
        assert receiver.recv(100) == b"telemetry"


def test_shared_memory_and_terminals_work():
    memory = multiprocessing.shared_memory.SharedMemory(create=True, size=4096)
    try:
        memory.buf[:4] = b"seen"
        assert bytes(Path(f"/dev/shm/{memory.name}").read_bytes()[:4]) == b"seen"
    finally:
        memory.close()
        memory.unlink()
    controller, terminal = pty.openpty()
    assert os.ttyname(terminal).startswith("/dev/pts/")
    os.close(controller)
    os.close(terminal)
