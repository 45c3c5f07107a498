"""The examples drive `surefoot sim` over SocketCAN, with candump beside them."""

import re
import signal
from dataclasses import dataclass
from pathlib import Path

import pytest
from live_bus import candump
from tests.python.command_line import wait_until
from tests.python.robot_programs import (
    PATIENCE_S,
    Program,
    counter_steps,
    decoded,
    example_command,
    running,
    surefoot_command,
    truths,
)

_STAND_S, _SQUAT_S, _DEPTH_M = 0.4, 1.2, 0.05  # of stand_and_squat.py
_CLIENT_FRAMES = {"SYNC", "LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT", "HEARTBEAT_CONTROLLER"}


@dataclass
class Squat:
    client: Program
    candump_log: Path
    truths: list


@pytest.fixture(scope="module")
def squat(tmp_path_factory: pytest.TempPathFactory) -> Squat:
    folder = tmp_path_factory.mktemp("squat")
    log = folder / "vcan0.log"
    simulator = surefoot_command("sim", "--bus", "socketcan:vcan0", "--once", "--out", folder / "robot")
    with candump("vcan0", log), running(simulator, folder / "sim") as robot:
        with running(example_command("stand_and_squat.py"), folder / "client") as client:
            client.wait()
        assert robot.wait() == 0
    return Squat(client, log, truths(folder / "robot" / "telemetry.lcmlog"))


def _height_m(squat: Squat, time_s: float) -> float:
    return squat.truths[round(time_s * 1000)].body_position_world_m[2]


def test_the_client_says_that_it_stands(squat: Squat):
    assert (squat.client.process.returncode, squat.client.err) == (0, "")
    assert squat.client.out.splitlines()[-1] == "it stands"


def test_the_trunk_really_goes_down_twice_and_comes_up_again(squat: Squat):
    standing_m = _height_m(squat, 0.9 * _STAND_S)
    for start_s in (_STAND_S, _STAND_S + _SQUAT_S):
        assert _height_m(squat, start_s + _SQUAT_S / 2) == pytest.approx(standing_m - _DEPTH_M, abs=0.005)
        assert _height_m(squat, start_s + _SQUAT_S) == pytest.approx(standing_m, abs=0.005)


def test_the_robot_stays_upright_and_on_the_spot(squat: Squat):
    assert not any(truth.has_fallen for truth in squat.truths)
    assert max(abs(truth.pitch_rad) for truth in squat.truths) < 0.035
    assert max(abs(truth.roll_rad) for truth in squat.truths) < 0.01
    assert squat.truths[-1].slip_m < 0.02


def test_the_height_that_the_client_estimates_is_the_trunks(squat: Squat):
    said = re.findall(r"([\d.]+) s  trunk at +([\d.]+) cm", squat.client.out)
    assert len(said) > 20
    for time_s, height_cm in said:
        assert float(height_cm) / 100 == pytest.approx(_height_m(squat, float(time_s)), abs=0.004)


def test_the_candump_log_decodes_cleanly(squat: Squat):
    frames = decoded(squat.candump_log)
    assert {name for name, _ in frames} >= _CLIENT_FRAMES
    assert counter_steps(frames) == {1}
    ticks = [signals["tick"] for name, signals in frames if name == "SYNC"]
    assert ticks == list(range(len(ticks))) and len(ticks) == len(squat.truths)


def test_sensors_are_read_until_ctrl_c_and_the_robot_is_left_damped(tmp_path: Path):
    log = tmp_path / "vcan0.log"
    simulator = surefoot_command("sim", "--bus", "socketcan:vcan0", "--once")
    with candump("vcan0", log), running(simulator, tmp_path / "sim") as robot:
        with running(example_command("read_sensors.py"), tmp_path / "client") as client:
            robot.await_message("a master drives the robot")
            wait_until(lambda: "t = " in client.out, PATIENCE_S)
            client.signal(signal.SIGINT)
            assert (client.wait(), client.err) == (130, "")
        assert robot.wait() == 0
    assert client.out.startswith("t = 0.000 s\n")
    last = [(name, signals) for name, signals in decoded(log) if name in _CLIENT_FRAMES][-3:]
    assert [name for name, _ in last] == ["LEG_COMMAND_RIGHT", "LEG_COMMAND_LEFT", "HEARTBEAT_CONTROLLER"]
    assert last[0][1]["mode"] == last[1][1]["mode"] == 0 and last[2][1]["nmt_state"] == 4
