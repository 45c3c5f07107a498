"""Runs the real command line, and says what every refusal of it has in common."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

USAGE, BAD_INPUT, MACHINE_LACKS, INTERRUPTED = 64, 65, 69, 130

# 9.5 s from power-up to time zero instead of 12: what is refused or cut short need not walk far.
SHORT = [
    "--set", "reflex.standing_s=0.5", "--set", "detector.warm_up_s=0", "--set", "detector.learning_s=4.8",
    "--set", "duration_s=0.2", "--set", "payload=[]",
]  # fmt: skip


def binary() -> str:
    path = os.environ.get("SUREFOOT_BINARY")
    assert path, "SUREFOOT_BINARY is not set; run these tests through ctest"
    return path


def surefoot(*arguments: object, prefix: list[str] | None = None, **options: object) -> subprocess.CompletedProcess:
    """One call of the binary, waited for; `prefix` is a command that calls it."""
    command = [*(prefix or []), binary(), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False, timeout=60, **options)


def plot(*arguments: object) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "tools.plots", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False, timeout=60, cwd=ROOT)


def assert_refused(finished: subprocess.CompletedProcess, code: int, *said: object) -> None:
    """Exit code, empty standard output, and a message for people that begins with the place and gives a remedy."""
    message = finished.stderr.decode()  # UTF-8, whatever was in the input
    assert finished.returncode == code, message
    assert finished.stdout == b""
    place, *rest = map(str, said)
    assert message.startswith(place), message
    for words in rest:
        assert words in message
    lines = message.splitlines()
    assert len(lines) >= 2 and lines[-1].startswith("  remedy: "), message
    assert len(lines[-1]) > len("  remedy: see x")
    assert all(character.isprintable() for line in lines for character in line), repr(message)
    assert "a bug" not in message and "Traceback" not in message


def wait_until(is_so: Callable[[], bool], deadline_s: float = 20.0) -> None:
    end = time.monotonic() + deadline_s
    while not is_so():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.002)
