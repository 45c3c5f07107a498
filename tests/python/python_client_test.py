"""The examples drive `surefoot sim` over python-can's `udp_multicast`, in a network namespace of their own."""

import os
import re
import shutil
import signal
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from robot_programs import Program, counter_steps, decoded, example_command, running, surefoot_command, truths

_MULTICAST_OVER_LO = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
echo ready
exec cat
"""
_FELL, _USAGE, _NO_ROBOT, _INTERRUPTED = 2, 64, 69, 130
_JOINTS = ["hip_yaw", "hip_roll", "hip_pitch", "knee_pitch", "ankle_pitch", "ankle_roll"]


@pytest.fixture(scope="module")
def inside() -> Iterator[list[str]]:
    """The begin of a command line that runs in the namespace of this module."""
    for program in ("unshare", "nsenter", "ip"):
        assert shutil.which(program), f"{program} is missing; run tools/setup"
    is_root = os.geteuid() == 0
    holder = subprocess.Popen(
        ["unshare", "-n" if is_root else "-rn", "sh", "-c", _MULTICAST_OVER_LO],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    with holder:
        if holder.stdout.readline() != "ready\n":
            pytest.skip(f"this machine permits no network namespace: {holder.stderr.read().strip()}")
        of_user = [] if is_root else ["-U", "--preserve-credentials"]
        yield ["nsenter", "-t", str(holder.pid), *of_user, "-n"]
        holder.stdin.close()


@contextmanager
def _simulator(inside: list[str], folder: Path, *arguments: object) -> Iterator[Program]:
    command = surefoot_command("sim", "--bus", "udp", "--out", folder / "robot", *arguments)
    with running([*inside, *command], folder / "sim") as simulator:
        simulator.await_message("waiting for a master")
        yield simulator


def _example(inside: list[str], name: str, *arguments: object) -> list[object]:
    return [*inside, *example_command(name, "--interface", "udp_multicast", *arguments)]


def _run(command: list[object], folder: Path) -> Program:
    with running(command, folder) as program:
        program.wait()
        return program


@pytest.fixture(scope="module")
def sensors(inside: list[str], tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """What read_sensors.py printed in a bit more than a second, and the folder of the robot that it read."""
    folder = tmp_path_factory.mktemp("sensors")
    with _simulator(inside, folder, "--once") as simulator:
        read = _run(_example(inside, "read_sensors.py", "--ticks", 1001), folder / "read")
        assert read.process.returncode == 0, read.err
        assert simulator.wait() == 0
    return read.out, folder / "robot"


def test_the_table_shows_each_sensor_of_the_robot_in_its_place(sensors: tuple[str, Path]):
    printed, robot = sensors
    assert [line for line in printed.splitlines() if line.startswith("t = ")] == ["t = 0.000 s", "t = 1.000 s"]
    rows = printed.split("t = 1.000 s\n")[1].splitlines()
    frames = dict(frame for frame in decoded(robot / "bus.log") if frame[1]["tick"] == 1000)
    shown = {(row.split()[0], row.split()[1]): [float(n) for n in re.findall(r"(?<= )[+-]?\d+\.\d+", row)] for row in rows}
    for side in ("right", "left"):
        leg, foot = frames[f"LEG_STATE_{side.upper()}"], frames[f"FOOT_FORCE_{side.upper()}"]
        for joint in _JOINTS:
            read = [leg[f"{joint}_{quantity}"] for quantity in ("angle_rad", "rate_rad_s", "torque_nm")]
            assert shown[side, joint] == pytest.approx(read, abs=1e-4)
        corners = [foot[f"{place}_force_n"] for place in ("front_left", "front_right", "rear_left", "rear_right")]
        assert shown["foot", side] == pytest.approx(corners, abs=0.05)
    for quantity, unit in (("angular_rate", "rad_s"), ("specific_force", "m_s2")):
        read = [frames["IMU"][f"{quantity}_{axis}_body_{unit}"] for axis in "xyz"]
        assert shown["torso", quantity] == pytest.approx(read, abs=5e-4)


def test_what_is_read_is_what_is_so(sensors: tuple[str, Path]):
    _, robot = sensors
    frames = [frame for frame in decoded(robot / "bus.log") if frame[1]["tick"] == 1000]
    signals = dict(frames)
    truth = next(truth for truth in truths(robot / "telemetry.lcmlog") if truth.tick == 999)
    for side, name in enumerate(("RIGHT", "LEFT")):
        angles = [signals[f"LEG_STATE_{name}"][f"{joint}_angle_rad"] for joint in _JOINTS]
        assert angles == pytest.approx(truth.angle_rad[side], abs=1e-5)
    assert not truth.has_fallen


def test_reading_keeps_the_robot_on_its_feet(sensors: tuple[str, Path]):
    _, robot = sensors
    heights_m = [truth.body_position_world_m[2] for truth in truths(robot / "telemetry.lcmlog")]
    assert max(heights_m) - min(heights_m) < 0.005


def test_every_frame_of_both_sides_is_as_the_database_says(sensors: tuple[str, Path]):
    _, robot = sensors
    frames = decoded(robot / "bus.log")
    assert {name for name, _ in frames} >= {"SYNC", "LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT", "HEARTBEAT_CONTROLLER"}
    assert counter_steps(frames) == {1}


def test_squatting_ends_on_both_feet(inside: list[str], tmp_path: Path):
    with _simulator(inside, tmp_path, "--once"):
        squat = _run(_example(inside, "stand_and_squat.py", "--squats", 1), tmp_path / "squat")
    assert (squat.process.returncode, squat.err) == (0, "")
    assert squat.out.splitlines()[-1] == "it stands"
    heights_cm = [float(height) for height in re.findall(r"trunk at +([\d.]+) cm", squat.out)]
    assert min(heights_cm) == pytest.approx(45.0, abs=0.5)
    assert heights_cm[-1] == pytest.approx(50.0, abs=0.5)


def test_a_robot_that_fell_is_told_from_one_that_stands(inside: list[str], tmp_path: Path):
    with _simulator(inside, tmp_path, "--set", "mass.trunk_com_body_m=[0.35,0,0.25]") as simulator:
        squat = _run(_example(inside, "stand_and_squat.py"), tmp_path / "squat")
        simulator.await_message("the robot fell")
    assert (squat.process.returncode, squat.out.splitlines()[-1]) == (_FELL, "it fell")


def test_ctrl_c_damps_the_legs_and_the_next_client_finds_the_robot_on_its_feet(inside: list[str], tmp_path: Path):
    with _simulator(inside, tmp_path) as simulator:
        with running(_example(inside, "read_sensors.py"), tmp_path / "read") as read:
            simulator.await_message("a master drives the robot")
            read.signal(signal.SIGINT)
            assert (read.wait(), read.err) == (_INTERRUPTED, "")
        simulator.await_message("the robot stands", times=2)
        again = _run(_example(inside, "read_sensors.py", "--ticks", 1), tmp_path / "again")
        assert again.process.returncode == 0, again.err
        simulator.await_message("a master drives the robot", times=2)
    frames = decoded(tmp_path / "robot" / "bus.log")
    of_client = [frame for frame in frames if frame[0].endswith("CONTROLLER") or "COMMAND" in frame[0]]
    (right, to_right), (left, to_left), (last, heartbeat) = of_client[-3:]
    assert [right, left, last] == ["LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT", "HEARTBEAT_CONTROLLER"]
    assert to_right["mode"] == to_left["mode"] == 0 and heartbeat["nmt_state"] == 4
    assert not any(value for name, value in {**to_right, **to_left}.items() if name.endswith("_nm"))


def test_a_second_client_is_refused_while_the_first_goes_on(inside: list[str], tmp_path: Path):
    with _simulator(inside, tmp_path) as simulator:
        with running(_example(inside, "read_sensors.py"), tmp_path / "first") as first:
            simulator.await_message("a master drives the robot")
            second = _run(_example(inside, "stand_and_squat.py"), tmp_path / "second")
            assert second.process.returncode == _NO_ROBOT
            assert second.err.startswith("another master drives this robot\n  remedy: ")
            assert first.process.poll() is None
            first.signal(signal.SIGINT)
            assert first.wait() == _INTERRUPTED
        simulator.await_message("the robot stands", times=2)
    frames = decoded(tmp_path / "robot" / "bus.log")
    assert not [name for name, _ in frames if name.startswith("EMERGENCY")]


def test_without_a_robot_the_client_names_the_missing_nodes(inside: list[str], tmp_path: Path):
    alone = _run(_example(inside, "read_sensors.py", "--patience", 0.5), tmp_path)
    assert alone.process.returncode == _NO_ROBOT
    assert alone.err.startswith("no robot: still waiting for FOOT_LEFT, FOOT_RIGHT, LEG_LEFT, LEG_RIGHT, TORSO_IMU\n")
    assert alone.err.splitlines()[-1].startswith("  remedy: ")


def test_a_missing_interface_is_refused_with_a_remedy(inside: list[str], tmp_path: Path):
    command = [*inside, *example_command("read_sensors.py", "--channel", "vcan77")]
    refused = _run(command, tmp_path)
    assert refused.process.returncode == _NO_ROBOT
    assert refused.err.startswith("socketcan vcan77: ") and "  remedy: " in refused.err


@pytest.mark.parametrize("name", ["read_sensors.py", "stand_and_squat.py"])
def test_help_gives_examples_and_a_wrong_call_has_an_exit_code_of_its_own(name: str, tmp_path: Path):
    explained = _run(example_command(name, "--help"), tmp_path / "help")
    assert explained.process.returncode == 0
    assert f"  {name} --" in explained.out and "exit codes: 0" in explained.out
    refused = _run(example_command(name, "--interface", "morse"), tmp_path / "refused")
    assert refused.process.returncode == _USAGE and refused.out == ""
    assert refused.err.splitlines()[-1] == "  remedy: see --help"
