"""`surefoot bus`, and scenarios whose bus cannot carry its traffic."""

import json

import pytest
from command_line import BAD_INPUT, SHORT, assert_refused, surefoot

KILOHERTZ_2 = ["--set", "control_period_s=0.0005", "--set", "bus.command_latency_s=0.0005"]


def budget(*overrides: str) -> dict:
    finished = surefoot("bus", *SHORT, *(part for text in overrides for part in ("--set", text)), "--json")
    assert finished.returncode == 0, finished.stderr
    return json.loads(finished.stdout)


@pytest.mark.parametrize("count", [1, 2])
def test_no_frame_takes_longer_than_the_analysis_says(count: int) -> None:
    report = budget(f"bus.count={count}", "bus.node_jitter_s=60e-6", "bus.node_latency_s=30e-6")
    assert len(report["buses"]) == count
    for bus in report["buses"]:
        assert 0 < bus["load_percent"] <= bus["worst_load_percent"]
        for stream in bus["identifiers"]:
            assert stream["observed_us"] <= stream["worst_case_us"], stream
            assert (stream["frames"] > 0) == ("EMERGENCY" not in stream["name"]), stream


def test_the_tick_adds_up() -> None:
    tick = budget()["tick_us"]
    parts = ("sync_and_states", "nodes", "compute", "commands", "heartbeat")
    assert sum(tick[part] for part in parts) == pytest.approx(tick["total"])
    assert tick["total"] + tick["spare"] == pytest.approx(1000.0)


def test_the_table_reads_in_a_terminal() -> None:
    finished = surefoot("bus", *SHORT)
    assert finished.returncode == 0, finished.stderr
    lines = finished.stdout.decode().splitlines()
    assert max(map(len, lines)) <= 120
    for name in ("SYNC", "LEG_STATE_RIGHT", "LEG_COMMAND_LEFT", "HEARTBEAT_TORSO_IMU", "EMERGENCY_CONTROLLER"):
        assert any(f" {name} " in line for line in lines), name


@pytest.mark.parametrize("command", ["run", "bus"])
def test_a_bus_that_cannot_carry_its_traffic_is_refused_with_the_figures(command: str) -> None:
    finished = surefoot(command, *SHORT, *KILOHERTZ_2)
    assert_refused(finished, BAD_INPUT, "--set control_period_s=0.0005: ", "780.4 us", "280.4 us (56.1 %) more",
                   "bus.count = 2", "control_period_s = 0.0008 or more")  # fmt: skip


def test_two_buses_carry_two_kilohertz() -> None:
    finished = surefoot("run", *SHORT, *KILOHERTZ_2, "--set", "bus.count=2", "--no-record", "--json")
    assert finished.returncode == 0, finished.stderr
    for bus in json.loads(finished.stdout)["bus"]:
        for stream in bus["identifiers"]:
            assert stream["observed_us"] <= stream["worst_case_us"], stream


@pytest.mark.parametrize(
    ("override", "said"),
    [
        ("bus.data_bit_rate_hz=3e6", "a whole number of nanoseconds, not 333.333"),
        ("bus.nominal_bit_rate_hz=300e3", "a whole number of nanoseconds"),
        ("bus.data_bit_rate_hz=5e5", "expected bus.nominal_bit_rate_hz = 1000000 or more"),
        ("bus.count=3", "expected 1 to 2"),
        ("bus.node_latency_s=300e-6", "the bus cannot carry its traffic"),
        ("bus.node_jitter_s=-1", "expected 0 to 0.01 s"),
    ],
)
def test_an_impossible_bus_is_refused(override: str, said: str) -> None:
    assert_refused(surefoot("bus", "--set", override), BAD_INPUT, f"--set {override}: ", said)
