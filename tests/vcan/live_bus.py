"""A live bus, seen with can-utils and python-can from inside tools/with-vcan."""

import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import can
from tests.python.command_line import wait_until
from tests.python.robot_programs import DATABASE, EXAMPLES, PATIENCE_S, Program, running

sys.path.append(str(EXAMPLES))
from surefoot_bus import Codec

# 9.5 s of the robot's time from power-up to time zero instead of 12; it walks from 1.3 s on.
SHORT_WALK = [
    "--set", "reflex.standing_s=0.5", "--set", "detector.warm_up_s=0", "--set", "detector.learning_s=4.8",
    "--set", "payload=[]",
]  # fmt: skip
WALKING_TICK = 2000
_END = "7FE#E0D0"  # of nobody
_CODEC = Codec()


def identifier(name: str) -> int:
    return DATABASE.get_message_by_name(name).frame_id


@contextmanager
def candump(interface: str, log: Path) -> Iterator[None]:
    """Logs all that crosses the interface meanwhile."""
    before = _listeners(interface)
    with log.open("w") as file:
        process = subprocess.Popen(["candump", "-L", "-r", "67108864", interface], stdout=file)
        try:
            wait_until(lambda: _listeners(interface) > before)
            yield
            cansend(_END, interface)  # what crossed before it has been written when it is in the log
            wait_until(lambda: _tail(log).endswith(f"{_END}\n"), PATIENCE_S)
        finally:
            process.send_signal(signal.SIGINT)
            process.wait(timeout=PATIENCE_S)
    log.write_text(log.read_text().rpartition("(")[0])


def _tail(log: Path) -> str:
    with log.open("rb") as file:
        file.seek(max(0, log.stat().st_size - 100))
        return file.read().decode()


def _listeners(interface: str) -> int:
    """Sockets that take every frame of the interface."""
    text = Path("/proc/net/can/rcvlist_all").read_text()
    return sum(line.split()[:1] == [interface] for line in text.splitlines())


@contextmanager
def listening(*names: str, interface: str = "vcan0") -> Iterator[can.BusABC]:
    """python-can with kernel filters for these frames of the database; all frames without any."""
    filters = [{"can_id": identifier(name), "can_mask": 0x7FF, "extended": False} for name in names]
    with can.Bus(interface="socketcan", channel=interface, fd=True, can_filters=filters or None) as bus:
        yield bus


def next_frame(bus: can.BusABC) -> can.Message:
    """The next one that the bus' filters let through. python-can binds its socket before it sets them: on a busy bus
    others may stand in it already."""
    wanted = {each["can_id"] for each in bus.filters or []}
    while True:
        frame = bus.recv(PATIENCE_S)
        assert frame is not None, "silence"
        if not wanted or frame.arbitration_id in wanted:
            return frame


def await_tick(tick: int) -> int:
    """Until the master has sent SYNC of that tick or a later one, which is returned."""
    end_s = time.monotonic() + PATIENCE_S
    now = -1
    with listening("SYNC") as bus:
        while now < tick:
            assert time.monotonic() < end_s, f"waited in vain for tick {tick}, the last was {now}"
            decoded = _CODEC.decode(next_frame(bus))  # None: damaged by an intruder
            now = decoded[1]["tick"] if decoded else now
    return now


def running_tick() -> int:
    return await_tick(0)


@contextmanager
def both(folder: Path, simulator: list[object], firmware: list[object]) -> Iterator[tuple[Program, Program]]:
    """Simulated robot and firmware side by side."""
    with running(simulator, folder / "sim_said") as robot, running(firmware, folder / "firmware_said") as controller:
        yield robot, controller


def cansend(frame: str, interface: str = "vcan0") -> None:
    subprocess.run(["cansend", interface, frame], check=True, timeout=PATIENCE_S)


def send_as(name: str, **signals: float) -> None:
    """A frame of the database with a counter that moves and a right CRC, whoever is to send it."""
    frame = _CODEC.encode(name, **signals)
    cansend(f"{frame.arbitration_id:03X}##1{bytes(frame.data).hex()}")
