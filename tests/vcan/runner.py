"""Calls tools/with-vcan from outside, and looks for what it may have left behind."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WITH_VCAN = str(ROOT / "tools" / "with-vcan")
USAGE, MACHINE_LACKS, INTERNAL_ERROR, NO_CAN, TIMED_OUT, NO_SUCH_COMMAND = 64, 69, 70, 77, 124, 127
_LIMIT_S = 300.0


def start(*arguments: str, **options: object) -> subprocess.Popen:
    return subprocess.Popen([WITH_VCAN, *arguments], **{"stdin": subprocess.DEVNULL, **options})


def run(*arguments: str, **options: object) -> subprocess.CompletedProcess:
    """One call, waited for; the input is empty unless it is given."""
    if "input" not in options:
        options.setdefault("stdin", subprocess.DEVNULL)
    return subprocess.run([WITH_VCAN, *arguments], capture_output=True, check=False, timeout=_LIMIT_S, **options)


def skip_without(backend: str) -> None:
    """Skips where the machine has no such backend; only a backend that starts counts."""
    finished = run("--backend", backend, "true")
    if finished.returncode == NO_CAN:
        pytest.skip(finished.stderr.decode())
    assert finished.returncode == 0, finished.stderr.decode()


def processes_that_name(text: str) -> list[str]:
    """Command lines of the living processes, this one excepted, in which the text occurs."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            words = (folder / "cmdline").read_bytes()  # empty once it is dead
        except OSError:
            continue
        if text.encode() in words and int(folder.name) != os.getpid():
            found.append(words.replace(b"\0", b" ").decode())
    return found
