"""Strangers on the bus of a walking robot: what they send is counted, and moves nobody by a single bit.

One run of firmware and robot goes through all of it; the same scenario on the bus in memory says what must happen.
"""

import json
import signal
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from live_bus import SHORT_WALK, WALKING_TICK, await_tick, both, cansend, identifier, listening, next_frame, running_tick
from tests.python.robot_programs import EXAMPLES, PATIENCE_S, decoded_frame, running, surefoot_command, truths

_SCENARIO = [*SHORT_WALK, "--set", "duration_s=40"]
_QUIET_TICKS = 100  # after each of them
_OLD_TICKS = 1500  # of an old log, all of the past when it is played
_FLOOD_FRAMES = 100_000
_CONTROLLER = "HEARTBEAT_CONTROLLER"


@dataclass
class Story:
    """What was done, each from a tick to another, and what became of it."""

    spans: dict[str, tuple[int, int]] = field(default_factory=dict)
    monitored: list[str] = field(default_factory=list)
    live: dict[int, bytes] = field(default_factory=dict)
    expected: dict[int, bytes] = field(default_factory=dict)
    firmware: dict = field(default_factory=dict)
    robot: dict = field(default_factory=dict)


def _truths(log: Path) -> dict[int, bytes]:
    return {truth.tick: truth.encode() for truth in truths(log)}


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The run folder of the same walk on the bus in memory."""
    folder = tmp_path_factory.mktemp("undisturbed")
    with running(surefoot_command("run", *_SCENARIO, "--out", folder / "run"), folder / "said") as program:
        assert program.wait() == 0, program.out + program.err
    return folder / "run"


def _send(name: str, **signals: float) -> None:
    """A frame of the database with a right CRC."""
    import sys

    sys.path.insert(0, str(EXAMPLES))
    from surefoot_bus import Codec

    frame = Codec().encode(name, **signals)
    cansend(f"{frame.arbitration_id:03X}##1{bytes(frame.data).hex()}")
