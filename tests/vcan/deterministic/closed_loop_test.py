"""Firmware and robot as two free-running processes in virtual time, on the wall clock too: the same frames each time."""

import json
import os
import subprocess
from pathlib import Path

import pytest

_ROOT = Path(__file__).resolve().parents[3]
_SUREFOOT = os.environ["SUREFOOT_BINARY"]
_SCENARIO = str(_ROOT / "tools" / "scenarios" / "no_payload.toml")
_NO_CAN = 77
_SCRIPT = """\
candump -L vcan0 >"$1/candump.log" & dump=$!
sleep 1  # virtual: candump listens
"$2" run "$4" --bus socketcan:vcan0 --clock "$3" --set duration_s=0.5 --out "$1/run" --overwrite --json >"$1/verdict.json" 2>"$1/messages"
sleep 1
kill $dump
"""


def _run(folder: Path, clock: str) -> tuple[bytes, dict]:
    folder.mkdir()
    script = ["sh", "-c", _SCRIPT, "-", str(folder), _SUREFOOT, clock, _SCENARIO]
    command = [str(_ROOT / "tools" / "with-vcan"), "--backend", "uml-time-travel", "--timeout", "250", *script]
    finished = subprocess.run(command, capture_output=True, check=False, stdin=subprocess.DEVNULL)
    if finished.returncode == _NO_CAN:
        pytest.skip(finished.stderr.decode())
    assert finished.stderr == b""
    return (folder / "candump.log").read_bytes(), json.loads((folder / "verdict.json").read_text())


@pytest.mark.parametrize("clock", ["lockstep", "wall"])
def test_two_processes_leave_byte_identical_candump_logs(tmp_path: Path, clock: str):
    (first, verdict), (second, _) = (_run(tmp_path / name, clock) for name in ("first", "second"))
    assert verdict["verdict"] == "walked", verdict["reason"]
    assert first.count(b"\n") > 8 * 12000, "twelve seconds of walking at 8 frames a tick"
    assert first == second
