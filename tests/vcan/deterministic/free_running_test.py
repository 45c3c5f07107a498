"""In virtual time two processes that run freely, each on its own clock, leave the same log each time, byte for byte."""

import subprocess
import sys
from pathlib import Path

import pytest

_ROOT = Path(__file__).resolve().parents[3]
_NODE = Path(__file__).with_name("free_running_node.py")
_FRAMES, _RUNS = 2000, 3
_NO_CAN = 77
_SCRIPT = """\
candump -L vcan0 >"$1" & dump=$!
sleep 1  # virtual: candump listens
"$2" "$3" 101 "$4" & "$2" "$3" 102 "$4"
wait $!
sleep 1
kill $dump
"""


def _log_of_one_run(log: Path) -> bytes:
    script = ["sh", "-c", _SCRIPT, "-", str(log), sys.executable, str(_NODE), str(_FRAMES)]
    command = [str(_ROOT / "tools" / "with-vcan"), "--backend", "uml-time-travel", "--timeout", "150", *script]
    finished = subprocess.run(command, capture_output=True, check=False, stdin=subprocess.DEVNULL)
    if finished.returncode == _NO_CAN:
        pytest.skip(finished.stderr.decode())
    assert finished.stderr == b""
    return log.read_bytes()


def test_candump_logs_of_free_running_processes_are_byte_identical(tmp_path: Path):
    logs = [_log_of_one_run(tmp_path / f"{k}.log") for k in range(_RUNS)]
    lines = logs[0].decode().splitlines()
    assert len(lines) == 2 * _FRAMES
    assert {line.split()[2].partition("##")[0] for line in lines} == {"101", "102"}
    # Free-running: on the grid of the clock, no faster and no slower than 1 kHz.
    times = [float(line.split()[0].strip("()")) for line in lines]
    assert times[-1] - times[0] == pytest.approx((_FRAMES - 1) * 1e-3, abs=1e-3)
    # What a node had received when it sent its last frame: all that the other one had sent, give or take one.
    for line in lines[-2:]:
        payload = bytes.fromhex(line.split()[2].partition("##")[2][1:])
        assert abs(int.from_bytes(payload[4:8], "little") - _FRAMES) <= 1
    assert logs[1] == logs[0]
    assert logs[2] == logs[0]
