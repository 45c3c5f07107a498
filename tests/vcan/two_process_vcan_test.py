"""Firmware and robot as two processes over SocketCAN: the same run, bit for bit, as on the bus in memory."""

import json
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import pytest
from live_bus import SHORT_WALK, candump
from tests.python.robot_programs import counter_steps, decoded, running, surefoot_command, truth_digests

# The main job until it settles: load at 1.2 s, detection, reflex, both feet in the air, stance.
_MAIN_JOB = ["--set", "duration_s=2.5", "--set", "limits.min_cycles_after_recovery=0"]
_TWO_BUSES = [
    *SHORT_WALK, "--set", "gait.single_support_s=1", "--set", "gait.double_support_s=0.7",
    "--set", "detector.learning_s=3.4", "--set", "duration_s=0.2", "--set", "bus.count=2",
]  # fmt: skip

# What a second process and a real start-up make different: heartbeats before tick 0, and wall time.
_OF_THE_WAY = {"bus_log_sha256", "frames_sent", "bus", "bus_load_percent", "tick_us", "real_time_factor", "timing"}


@dataclass
class Run:
    folder: Path
    candump_logs: list[Path]

    @property
    def verdict(self) -> dict:
        return json.loads((self.folder / "verdict.json").read_text())

    def frames(self, *identifiers: int) -> dict[int, list[str]]:
        return by_identifier(self.folder / "bus.log", *identifiers)


def by_identifier(log: Path, *identifiers: int) -> dict[int, list[str]]:
    """Payloads in hexadecimal in their order; of all identifiers if none is given."""
    payloads = defaultdict(list)
    for line in log.read_text().splitlines():
        name, payload = line.split()[2].split("##")
        if not identifiers or int(name, 16) in identifiers:
            payloads[int(name, 16)].append(payload[1:])
    return payloads


def _run(folder: Path, scenario: list[str], *bus: str) -> Path:
    command = surefoot_command("run", *scenario, "--out", folder / "run", *bus)
    with running(command, folder / "said") as program:
        assert program.wait() == 0, program.out + program.err
    return folder / "run"


def _run_on(interfaces: list[str], folder: Path, scenario: list[str]) -> Run:
    logs = [folder / f"{interface}.log" for interface in interfaces]
    if len(interfaces) == 1:
        with candump(interfaces[0], logs[0]):
            return Run(_run(folder, scenario, "--bus", f"socketcan:{interfaces[0]}"), logs)
    with candump(interfaces[0], logs[0]), candump(interfaces[1], logs[1]):
        return Run(_run(folder, scenario, "--bus", f"socketcan:{','.join(interfaces)}"), logs)


@pytest.fixture(scope="module", params=["one bus", "two buses"])
def runs(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Run, Run]:
    """The same scenario on the bus in memory and on vcan."""
    scenario, interfaces = (
        (_MAIN_JOB, ["vcan0"]) if request.param == "one bus" else (_TWO_BUSES, ["vcan0", "vcan1"])
    )
    if not all(Path("/sys/class/net", interface).exists() for interface in interfaces):
        pytest.skip(f"{', '.join(interfaces)} needed: tools/with-vcan -n {len(interfaces)}")
    memory = Run(_run(tmp_path_factory.mktemp("memory"), scenario), [])
    return memory, _run_on(interfaces, tmp_path_factory.mktemp("vcan"), scenario)


def test_the_verdict_is_the_same(runs: tuple[Run, Run]):
    memory, vcan = ({name: value for name, value in run.verdict.items() if name not in _OF_THE_WAY} for run in runs)
    assert vcan == memory
    assert vcan["verdict"] == "walked" and vcan["frames_lost"] == 0


def test_the_torque_frames_are_the_same_bits(runs: tuple[Run, Run]):
    memory, vcan = (run.frames(0x080, 0x201, 0x202) for run in runs)
    assert vcan == memory
    assert len(vcan[0x201]) > 7000


def test_the_world_went_through_the_same_states(runs: tuple[Run, Run]):
    memory, vcan = (truth_digests(run.folder / "telemetry.lcmlog") for run in runs)
    assert vcan.keys() == memory.keys()
    assert [tick for tick in memory if vcan[tick] != memory[tick]] == []


def test_only_announcements_before_the_first_tick_come_on_top(runs: tuple[Run, Run]):
    memory, vcan = (run.frames() for run in runs)
    assert vcan.pop(0x7F0), "a robot in lockstep says that it is one"
    assert memory.keys() == vcan.keys()
    for identifier, payloads in memory.items():
        extra = len(vcan[identifier]) - len(payloads)
        assert extra == 0 or (extra > 0 and identifier > 0x700), hex(identifier)


def test_candump_beside_it_sees_what_the_firmware_recorded(runs: tuple[Run, Run]):
    _, vcan = runs
    recorded, seen = vcan.frames(), [by_identifier(log) for log in vcan.candump_logs]
    for identifier, payloads in recorded.items():
        heard = [log[identifier] for log in seen if identifier in log]
        if identifier in (0x080, 0x77F):  # of the master, to both
            assert len(heard) == len(seen), "not on every bus"
        else:
            assert len(heard) == 1, "on one bus"
        for one in heard:
            assert one[-len(payloads) :] == payloads, hex(identifier)


def test_each_bus_carries_one_leg(runs: tuple[Run, Run]):
    _, vcan = runs
    if len(vcan.candump_logs) == 1:
        pytest.skip("one bus")
    right, left = ({identifier & 0x7F for identifier in by_identifier(log)} for log in vcan.candump_logs)
    assert {1, 3} <= right and {2, 4} <= left and not right & {2, 4} and not left & {1, 3}


def test_candump_logs_decode_to_the_last_frame(runs: tuple[Run, Run]):
    _, vcan = runs
    for log in vcan.candump_logs:
        assert counter_steps(decoded(log)) == {1}
