"""Programs that meet on a CAN bus, started side by side; and what a candump log of them must be like."""

import hashlib
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import cantools
import lcm
from cantools.logreader import Parser
from crccheck.crc import Crc16Ibm3740

from tests.python.command_line import ROOT, binary, wait_until
from tools.plots.messages import message_types

PATIENCE_S = 120.0  # no measure of anything: a guest machine under load may take long
EXAMPLES = ROOT / "examples"
DATABASE = cantools.database.load_file(ROOT / "firmware" / "can" / "surefoot.dbc")


class Program:
    """A started process; what it prints goes to files."""

    def __init__(self, command: list[object], folder: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self._out, self._err = folder / "stdout", folder / "stderr"
        with self._out.open("w") as out, self._err.open("w") as err:
            self.process = subprocess.Popen([str(word) for word in command], stdout=out, stderr=err)

    @property
    def out(self) -> str:
        return self._out.read_text()

    @property
    def err(self) -> str:
        return self._err.read_text()

    def await_message(self, text: str, times: int = 1) -> None:
        """Until the program has said so on stderr."""
        with suppress(AssertionError):  # what was said instead tells more than the time that passed
            wait_until(lambda: self.err.count(text) >= times or self.process.poll() is not None, PATIENCE_S)
        assert self.err.count(text) >= times, f"not said {times} times: {text}\n{self.err}"

    def signal(self, number: int) -> None:
        self.process.send_signal(number)

    def wait(self) -> int:
        return self.process.wait(timeout=PATIENCE_S)


@contextmanager
def running(command: list[object], folder: Path) -> Iterator[Program]:
    """Killed at the end, if it still runs."""
    program = Program(command, folder)
    try:
        yield program
    finally:
        program.process.kill()
        program.process.wait()


def surefoot_command(subcommand: str, *arguments: object) -> list[object]:
    return [binary(), subcommand, *arguments]


def example_command(name: str, *arguments: object) -> list[object]:
    return [sys.executable, EXAMPLES / name, *arguments]


def decoded(candump_log: Path) -> list[tuple[str, dict[str, float]]]:
    """Name and signals of every frame. Fails at a line that is none, an unknown identifier, a wrong length, a frame
    that is not CAN FD with bit rate switch, a wrong CRC, or a value outside the range of the database."""
    parser = Parser()
    text = candump_log.read_text()
    assert text.endswith("\n"), "ends in a line"
    frames = []
    for line in text.splitlines():
        parsed = parser.parse(line)
        assert parsed is not None, line
        name, signals = decoded_frame(parsed.frame_id, parsed.data)
        flags = int(line.split("##")[1][0], 16)
        assert flags & 1, f"no bit rate switch: {line}"
        frames.append((name, signals))
    return frames


def decoded_frame(identifier: int, data: bytes) -> tuple[str, dict[str, float]]:
    message = DATABASE.get_message_by_frame_id(identifier)  # KeyError: not of ours
    assert len(data) == message.length, message.name
    signals = message.decode(data, decode_choices=False, allow_truncated=False)
    offset = message.get_signal_by_name("crc").start // 8
    covered = identifier.to_bytes(2, "little") + data[:offset] + data[offset + 2 :]
    assert signals["crc"] == Crc16Ibm3740.calc(covered), f"{message.name} {data.hex()}"
    for signal in message.signals:
        assert signal.minimum <= signals[signal.name] <= signal.maximum, f"{message.name} {signals}"
    return message.name, signals


def counter_steps(frames: list[tuple[str, dict[str, float]]]) -> set[int]:
    """By how much the rolling counters move from frame to frame of a name."""
    last: dict[str, int] = {}
    steps = set()
    for name, signals in frames:
        if name in last:
            steps.add((signals["counter"] - last[name]) % 256)
        last[name] = signals["counter"]
    return steps


def truths(telemetry_log: Path) -> list:
    """What really happened, tick by tick, as the simulated robot recorded it."""
    decode = message_types().simulator_truth_t.decode
    return [decode(encoded) for encoded in _encoded_truths(telemetry_log)]


def truth_digests(telemetry_log: Path) -> dict[int, bytes]:
    """The same by tick, as digests: two of them are equal when all bits are."""
    decode = message_types().simulator_truth_t.decode
    return {decode(encoded).tick: hashlib.sha256(encoded).digest() for encoded in _encoded_truths(telemetry_log)}


def _encoded_truths(telemetry_log: Path) -> Iterator[bytes]:
    log = lcm.EventLog(str(telemetry_log), "r")
    return (event.data for event in log if event.channel == "SUREFOOT_TRUTH")
