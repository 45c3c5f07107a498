"""`surefoot bus --log` against canbusload of can-utils: the same frames, the same bits.

canbusload counts classic frames alone; FD frames have a second opinion in tests/python/bus_bits_test.py. Of a
remote frame that asks for 8 bytes (123#R8) it counts 8 bytes that are not there; ours does not.
"""

import json
import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from tests.python.command_line import surefoot, wait_until

INTERFACE = "vcan0"
RANDOM_FRAMES = 1000

# What random frames seldom are: long runs, a CRC that ends in five equal bits, remote frames, no payload.
CORNERS = ["000#", "000#0000000000000000", "7FF#FFFFFFFFFFFFFFFF", "009#", "078#0F0F0F0F0F0F0F0F", "123#R"]

_LINE = re.compile(rf"^ *{INTERFACE}@1000000 +(\d+) +(\d+) +\d+ +\d+%", re.MULTILINE)


@contextmanager
def running(command: list[str], output: Path) -> Iterator[subprocess.Popen]:
    with output.open("w") as file, subprocess.Popen(command, stdout=file, stderr=subprocess.STDOUT) as process:
        try:
            yield process
        finally:
            process.terminate()


def sums(report: Path) -> tuple[int, int]:
    """Frames and bits of all seconds that canbusload has reported."""
    seconds = _LINE.findall(report.read_text())
    return sum(int(frames) for frames, _ in seconds), sum(int(bits) for _, bits in seconds)


def send(*command: str) -> None:
    subprocess.run(command, check=True, timeout=60)


@pytest.mark.parametrize("source", ["corners", "random"])
def test_classic_frames_have_as_many_bits_as_canbusload_counts(tmp_path: Path, source: str) -> None:
    count = len(CORNERS) if source == "corners" else RANDOM_FRAMES
    report, log = tmp_path / "canbusload.txt", tmp_path / "candump.log"
    candump = ["candump", "-L", "-n", str(count), INTERFACE]
    with running(["canbusload", "-e", f"{INTERFACE}@1000000"], report), running(candump, log) as recording:
        wait_until(lambda: bool(_LINE.search(report.read_text())))  # both listen
        if source == "corners":
            for frame in CORNERS:
                send("cansend", INTERFACE, frame)
        else:
            send("cangen", INTERFACE, "-g", "1", "-n", str(count))
        assert recording.wait(timeout=60) == 0
        wait_until(lambda: sums(report)[0] >= count)
    frames, bits = sums(report)

    finished = surefoot("bus", "--log", log, "--bitrate", "1000000", "--json")
    assert finished.returncode == 0, finished.stderr
    load = json.loads(finished.stdout)[INTERFACE]
    assert (load["classic_frames"], load["fd_frames"]) == (frames, 0) == (count, 0)
    assert load["nominal_bits"] == bits
