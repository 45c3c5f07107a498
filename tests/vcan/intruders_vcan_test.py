"""Strangers on the bus of a walking robot: what they send is counted, and moves nobody by a single bit.

One run of firmware and robot goes through all of it; the same walk on the bus in memory says what must happen.
"""

import json
import random
import signal
import subprocess
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from live_bus import (
    SHORT_WALK, WALKING_TICK, await_tick, both, cansend, identifier, listening, next_frame, running_tick, send_as,
)  # fmt: skip
from tests.python.robot_programs import DATABASE, PATIENCE_S, decoded_frame, running, surefoot_command, truth_digests

_SCENARIO = [*SHORT_WALK, "--set", "duration_s=20"]
_QUIET_TICKS = 150  # after each of them: more than any time to ride through
_OLD_TICKS = 1500
_MONITORED_FRAMES = 3000
_FLOOD_FRAMES = 100_000
_OPERATIONAL = 5


def _play(log: Path, frames: list[str]) -> None:
    """All of them with one program: starting a cansend for each takes hundreds of ticks."""
    log.write_text("".join(f"(0.000000) vcan0 {frame}\n" for frame in frames))
    subprocess.run(["canplayer", "-I", log], check=True, timeout=PATIENCE_S)


def _garbage(folder: Path) -> None:
    """Our identifiers with anything but our frames."""
    noise = random.Random(1)
    frames = []
    for name in ("SYNC", "LEG_COMMAND_RIGHT", "HEARTBEAT_CONTROLLER", "LEG_STATE_LEFT", "LOCKSTEP_SERVED", "IMU"):
        message = DATABASE.get_message_by_name(name)
        frames += [
            f"{message.frame_id:03X}##1{noise.randbytes(message.length).hex()}",
            f"{message.frame_id:03X}##1{noise.randbytes(64).hex()}",
            f"{message.frame_id:03X}##1",
            f"{message.frame_id:03X}#{noise.randbytes(8).hex()}",
            f"{message.frame_id:03X}#R",
            f"{message.frame_id:08X}##1{noise.randbytes(message.length).hex()}",
        ]
    _play(folder / "garbage.log", frames)


def _foreign_identifiers(_: Path) -> None:
    for frame in ("123##1" + "5A" * 20, "301#00112233", "7FF##1" + "00" * 64, "000#8100", "203##1" + "00" * 20):
        cansend(frame)


def _replayed_frames(folder: Path) -> None:
    """What was on the bus a moment ago, once more."""
    with listening("LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT", "LEG_STATE_RIGHT", "FOOT_FORCE_LEFT", "SYNC") as bus:
        heard = [next_frame(bus) for _ in range(20)]
    await_tick(running_tick() + 10)
    _play(folder / "heard.log", [f"{frame.arbitration_id:03X}##1{bytes(frame.data).hex()}" for frame in heard])


def _heartbeat_of_a_wrong_version(_: Path) -> None:
    for version in (0, 2, 255):
        send_as("HEARTBEAT_CONTROLLER", nmt_state=_OPERATIONAL, protocol_version=version, tick=0)


def _torques_of_a_tick_long_ago(_: Path) -> None:
    torques = {signal.name: 150.0 for signal in DATABASE.get_message_by_name("LEG_COMMAND_LEFT").signals
               if signal.name.endswith("_nm")}  # fmt: skip
    send_as("LEG_COMMAND_LEFT", mode=1, tick=10, **torques)


def _old_log_played_by_canplayer(folder: Path) -> None:
    subprocess.run(["canplayer", "-I", folder / "old.log", "vcan0=can0"], check=True, timeout=PATIENCE_S)


def _flood(folder: Path) -> None:
    subprocess.run(["canplayer", "-I", folder / "flood.log"], check=True, timeout=PATIENCE_S)


def _write_old_log(folder: Path) -> None:
    """The begin of another run, all of whose ticks are of the past when it is played."""
    sync = f"{identifier('SYNC'):03X}##"
    lines, ticks = [], 0
    for line in (folder / "undisturbed" / "run" / "bus.log").read_text().splitlines(keepends=True):
        ticks += sync in line
        if ticks > _OLD_TICKS:
            break
        lines.append(line)
    (folder / "old.log").write_text("".join(lines))


def _write_flood(folder: Path) -> None:
    """Frames of every shape, half of them under our identifiers, 50 to a millisecond."""
    noise = random.Random(2)
    ours = [message.frame_id for message in DATABASE.messages]
    lines = []
    for k in range(_FLOOD_FRAMES):
        frame_id = noise.choice(ours) if noise.random() < 0.5 else noise.randrange(0x800)
        length = noise.choice([0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64])
        shape = noise.random()
        if shape < 0.7:
            text = f"{frame_id:03X}##{noise.randrange(4)}{noise.randbytes(length).hex()}"
        elif shape < 0.8:
            text = f"{noise.randrange(1 << 29):08X}##1{noise.randbytes(length).hex()}"
        elif shape < 0.9:
            text = f"{frame_id:03X}#{noise.randbytes(min(length, 8)).hex()}"
        else:
            text = f"{frame_id:03X}#R"
        lines.append(f"({k // 50 * 0.001:.6f}) vcan0 {text}\n")
    (folder / "flood.log").write_text("".join(lines))


_INTRUSIONS: list[Callable[[Path], None]] = [
    _garbage, _foreign_identifiers, _replayed_frames, _heartbeat_of_a_wrong_version, _torques_of_a_tick_long_ago,
    _old_log_played_by_canplayer, _flood,
]  # fmt: skip


@dataclass
class Story:
    """What was done, each from a tick to another, and what became of it."""

    spans: dict[str, tuple[int, int]]
    monitored: Counter
    live: dict[int, bytes]
    expected: dict[int, bytes]
    firmware: dict
    fault_tick: int
    robot_said: str


@pytest.fixture(scope="module")
def story(tmp_path_factory: pytest.TempPathFactory) -> Story:
    folder = tmp_path_factory.mktemp("intruders")
    reference = surefoot_command("run", *_SCENARIO, "--out", folder / "undisturbed" / "run")
    with running(reference, folder / "undisturbed") as undisturbed:
        assert undisturbed.wait() == 0, undisturbed.out + undisturbed.err
    _write_old_log(folder)
    _write_flood(folder)
    simulator = surefoot_command("sim", *_SCENARIO, "--bus", "socketcan:vcan0", "--out", folder / "robot")
    firmware = surefoot_command("firmware", *_SCENARIO, "--bus", "socketcan:vcan0", "--out", folder / "firmware")
    spans = {}
    with both(folder, simulator, firmware) as (robot, controller):
        await_tick(WALKING_TICK)
        with listening() as bus:
            heard = [next_frame(bus) for _ in range(_MONITORED_FRAMES)]
        monitored = Counter(decoded_frame(frame.arbitration_id, bytes(frame.data))[0] for frame in heard)
        for intrude in _INTRUSIONS:
            begin = running_tick()
            intrude(folder)
            spans[intrude.__name__] = (begin, await_tick(running_tick() + _QUIET_TICKS))
        fault_tick = running_tick()
        for _ in range(2):  # one of them may have the counter of the foot's own last one
            send_as("HEARTBEAT_FOOT_LEFT", nmt_state=_OPERATIONAL, protocol_version=2, has_inertial_sensors=0, tick=0)
        controller.await_message("latched")
        await_tick(running_tick() + 500)
        controller.signal(signal.SIGINT)
        assert controller.wait() == 3
        robot.signal(signal.SIGINT)
        assert robot.wait() == 0
    report = json.loads((folder / "firmware" / "firmware.json").read_text())
    return Story(
        spans=spans, monitored=monitored, firmware=report, fault_tick=fault_tick, robot_said=robot.err,
        live=truth_digests(folder / "robot" / "telemetry.lcmlog"),
        expected=truth_digests(folder / "undisturbed" / "run" / "telemetry.lcmlog"),
    )  # fmt: skip


def test_it_walks_as_if_nobody_were_there_before_the_first_of_them(story: Story):
    begin = min(begin for begin, _ in story.spans.values())
    assert begin >= WALKING_TICK
    assert [tick for tick in range(begin) if story.live[tick] != story.expected[tick]] == []


@pytest.mark.parametrize("intrusion", [intrude.__name__ for intrude in _INTRUSIONS])
def test_nothing_moves_by_a_bit_and_it_walks_on(story: Story, intrusion: str):
    begin, end = story.spans[intrusion]
    assert end <= max(story.expected), "the undisturbed walk is too short for this machine"
    assert [tick for tick in range(begin, end) if story.live[tick] != story.expected[tick]] == []


def test_what_was_sent_did_arrive_and_was_counted(story: Story):
    assert sum(story.firmware["frames"]["rejected"]) > 1000
    assert story.firmware["bus"]["foreign_shape"] > 100
    assert story.firmware["bus"]["queue_overflow"] == 0


def test_a_python_monitor_decodes_every_frame_of_the_walk(story: Story):
    each_tick = ["SYNC", "LEG_STATE_RIGHT", "LEG_STATE_LEFT", "FOOT_FORCE_RIGHT", "FOOT_FORCE_LEFT", "IMU",
                 "LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT"]  # fmt: skip
    assert set(story.monitored) >= set(each_tick)
    assert sum(story.monitored.values()) == _MONITORED_FRAMES


def test_a_node_that_speaks_another_version_ends_the_walk_in_a_latched_fault_on_both_feet(story: Story):
    assert story.firmware["fault"] == 9
    assert max(story.live) > story.fault_tick + 400
    assert "fell" not in story.robot_said
