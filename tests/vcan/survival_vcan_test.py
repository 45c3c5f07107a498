"""One of the two processes dies, comes back, comes twice or never, or the link goes: the other one says so and is safe."""

import json
import signal
import subprocess
from pathlib import Path

import pytest
from live_bus import SHORT_WALK, WALKING_TICK, await_tick, both, identifier, listening, next_frame, running_tick
from tests.python.robot_programs import DATABASE, Program, decoded, running, surefoot_command, truths

_BUS = ["--bus", "socketcan:vcan0"]
_NO_ROBOT, _FAULT = 69, 3
_FAULT_EMERGENCY = 0xFF00  # and the number of the fault
# On the wall clock a busy machine may have made the firmware latch another fault before.
_SILENT_ROBOT = {"lockstep": "fault 1 (sensor_silent) latched", "wall": "latched"}
_STANDS, _DRIVES = "the robot stands, waiting for a master", "a master drives the robot from its tick 0 on"


def _simulator(*arguments: object) -> list[object]:
    return surefoot_command("sim", *SHORT_WALK, *_BUS, *arguments)


def _firmware(*arguments: object) -> list[object]:
    return surefoot_command("firmware", *SHORT_WALK, *_BUS, *arguments)


def _interrupt(program: Program) -> int:
    program.signal(signal.SIGINT)
    return program.wait()


def _kill(program: Program) -> None:
    program.signal(signal.SIGKILL)
    program.wait()


def _next(name: str) -> dict[str, float]:
    with listening(name) as bus:
        return DATABASE.decode_message(identifier(name), next_frame(bus).data, decode_choices=False)


def _assert_stood_before(robot: Program) -> None:
    """The last master came to a robot on its feet."""
    assert robot.err.rpartition(_DRIVES)[0].endswith(f"{_STANDS}\nsim: "), robot.err


def _await_fault(bus) -> int:
    """Number of the fault that the controller's emergency tells of."""
    frame = next_frame(bus)
    return DATABASE.decode_message(frame.arbitration_id, frame.data, decode_choices=False)["code"] - _FAULT_EMERGENCY


def _power_ups(folder: Path) -> list[list[dict[str, float]]]:
    """Right leg commands that the firmware recorded, from one tick 0 to the next."""
    power_ups: list[list[dict[str, float]]] = []
    for name, signals in decoded(folder / "bus.log"):
        if name == "SYNC" and signals["tick"] == 0:
            power_ups.append([])
        elif name == "LEG_COMMAND_RIGHT":
            power_ups[-1].append(signals)
    return power_ups


@pytest.mark.parametrize("clock", ["lockstep", "wall"])
def test_a_robot_killed_and_started_again_meets_a_firmware_that_stays_safe(tmp_path: Path, clock: str):
    options = ["--clock", clock]
    with both(tmp_path, _simulator(*options), _firmware(*options, "--out", tmp_path / "firmware")) as (robot, firmware):
        await_tick(WALKING_TICK)
        with listening("EMERGENCY_CONTROLLER") as emergencies:
            _kill(robot)
            if clock == "lockstep":
                assert _await_fault(emergencies) == 1
        firmware.await_message(_SILENT_ROBOT[clock])
        with running(_simulator(*options, "--out", tmp_path / "robot"), tmp_path / "second") as second:
            second.await_message("a master drives the robot from its tick")
            await_tick(running_tick() + 300)
            assert _next("LEG_COMMAND_RIGHT")["mode"] == 0
            assert _interrupt(firmware) == _FAULT
            assert _interrupt(second) == 0
    commands = _power_ups(tmp_path / "firmware")[0]
    modes = [command["mode"] for command in commands]
    first_damped = modes.index(0, WALKING_TICK if clock == "lockstep" else len(modes) - 300)
    assert set(modes[first_damped:]) == {0}, "a torque after the fault"
    applied = [torque for truth in truths(tmp_path / "robot" / "telemetry.lcmlog") for torque in sum(truth.torque_nm, ())]
    assert applied and max(map(abs, applied)) < 200.0


@pytest.mark.parametrize("clock", ["lockstep", "wall"])
def test_a_firmware_told_to_start_again_walks_the_new_robot(tmp_path: Path, clock: str):
    options = ["--clock", clock]
    folder = tmp_path / "firmware"
    with both(tmp_path, _simulator(*options), _firmware(*options, "--start-again", "--out", folder)) as (robot, firmware):
        await_tick(WALKING_TICK)
        _kill(robot)
        firmware.await_message(_SILENT_ROBOT[clock])
        with running(_simulator(*options, "--out", tmp_path / "robot"), tmp_path / "second") as second:
            firmware.await_message("all five nodes are there: tick 0", times=2)
            second.await_message(_DRIVES)
            _assert_stood_before(second)
            if clock == "lockstep":
                await_tick(WALKING_TICK)
                assert _next("LEG_COMMAND_RIGHT")["mode"] == 1
            assert _interrupt(firmware) in ((0,) if clock == "lockstep" else (0, _FAULT))
            assert _interrupt(second) == 0
    assert json.loads((folder / "firmware.json").read_text())["starts"] >= 2
    before, after = _power_ups(folder)[:2]
    if clock == "lockstep":
        assert after[:WALKING_TICK] == before[:WALKING_TICK], "another walk than the first"


@pytest.mark.parametrize("clock", ["lockstep", "wall"])
def test_a_killed_firmware_leaves_a_robot_that_the_next_one_walks(tmp_path: Path, clock: str):
    options = ["--clock", clock]
    with both(tmp_path, _simulator(*options, "--out", tmp_path / "robot"), _firmware(*options)) as (robot, firmware):
        await_tick(WALKING_TICK)
        _kill(firmware)
        robot.await_message("the master has fallen silent after its tick")
        # At once: it waits until the robot stands again.
        with running(_firmware(*options, "--out", tmp_path / "firmware"), tmp_path / "second") as second:
            robot.await_message(_DRIVES, times=2)
            _assert_stood_before(robot)
            if clock == "lockstep":
                await_tick(WALKING_TICK)
                assert _next("LEG_COMMAND_LEFT")["mode"] == 1
            assert _interrupt(second) in ((0,) if clock == "lockstep" else (0, _FAULT))
        assert _interrupt(robot) == 0
    decoded(tmp_path / "firmware" / "bus.log")
    if clock == "lockstep":
        assert not truths(tmp_path / "robot" / "master_2" / "telemetry.lcmlog")[-1].has_fallen


def test_a_second_firmware_is_refused_and_the_first_walks_on(tmp_path: Path):
    with both(tmp_path, _simulator(), _firmware()) as (robot, first):
        await_tick(WALKING_TICK)
        with running(_firmware(), tmp_path / "second") as second:
            assert second.wait() == _NO_ROBOT
        assert "another master drives this bus" in second.err and "  remedy: " in second.err
        await_tick(running_tick() + 200)
        assert _next("LEG_COMMAND_RIGHT")["mode"] == 1
        assert _interrupt(first) == 0, first.err
        assert "fell" not in robot.err


def test_a_firmware_without_a_robot_names_the_missing_nodes_and_gives_up(tmp_path: Path):
    with running(_firmware("--patience", 1), tmp_path) as alone:
        assert alone.wait() == _NO_ROBOT
    assert "no robot on this bus: still waiting for right leg board, left leg board" in alone.err
    assert "  remedy: " in alone.err


def test_a_link_that_goes_down_and_up_again_ends_in_a_latched_fault_and_hangs_nobody(tmp_path: Path):
    with both(tmp_path, _simulator(), _firmware("--out", tmp_path / "firmware")) as (robot, firmware):
        await_tick(WALKING_TICK)
        subprocess.run(["ip", "link", "set", "vcan0", "down"], check=True)
        firmware.await_message("fault 1 (sensor_silent) latched")
        subprocess.run(["ip", "link", "set", "vcan0", "up"], check=True)
        await_tick(running_tick() + 100)
        assert _next("LEG_COMMAND_RIGHT")["mode"] == 0
        assert _interrupt(firmware) == _FAULT
        assert _interrupt(robot) == 0
    report = json.loads((tmp_path / "firmware" / "firmware.json").read_text())
    assert report["bus"]["link_down"] > 0
    decoded(tmp_path / "firmware" / "bus.log")


def test_ctrl_c_ends_either_with_whole_logs(tmp_path: Path):
    simulator, firmware = _simulator("--out", tmp_path / "robot"), _firmware("--out", tmp_path / "firmware")
    with both(tmp_path, simulator, firmware) as (robot, controller):
        await_tick(WALKING_TICK)
        assert _interrupt(controller) == 0
        assert _interrupt(robot) == 0
    ticks = json.loads((tmp_path / "firmware" / "firmware.json").read_text())["ticks"]
    assert len(_power_ups(tmp_path / "firmware")[0]) == ticks
    recorded = truths(tmp_path / "robot" / "telemetry.lcmlog")
    assert [truth.tick for truth in recorded] == list(range(len(recorded))) and ticks - len(recorded) <= 1
