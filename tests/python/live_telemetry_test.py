"""Live telemetry, heard by PyPI's lcm inside a network namespace of its own: no other traffic, nothing left behind."""

import subprocess
import sys
from pathlib import Path

import lcm
import pytest
from command_line import MACHINE_LACKS, ROOT, SHORT, binary, surefoot

from tools.plots.messages import message_types

_MULTICAST_OVER_LO = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
exec "$@"
"""
_TICKS = 9700  # of SHORT, from power-up to its end
_LIVE_ONLY = ("SUREFOOT_TIMING", "SUREFOOT_RUN")
_EVERY_TICKS = 50  # states and truths: few, for a receive buffer that a busy machine leaves unread for a while


@pytest.fixture(scope="module")
def live_run(in_own_network: list[str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what a walk recorded (run/) and what was heard of it meanwhile (heard.lcmlog)."""
    folder = tmp_path_factory.mktemp("live")
    walk = [binary(), "run", *SHORT, "--set", f"telemetry.every_ticks={_EVERY_TICKS}", "--live", "--pace", "4"]
    listen = [sys.executable, str(ROOT / "tests" / "python" / "live_listener.py"), str(folder / "heard.lcmlog")]
    finished = subprocess.run(
        [*in_own_network, "sh", "-c", _MULTICAST_OVER_LO, "sh", *listen, *walk, "--out", str(folder / "run")],
        capture_output=True, text=True, timeout=20, check=False,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stderr
    return folder


def _messages(log: Path) -> list[tuple[str, bytes]]:
    return [(event.channel, event.data) for event in lcm.EventLog(str(log), "r")]


def _ticks(messages: list[tuple[str, bytes]], channel: str, message_type: str) -> list[int]:
    decode = getattr(message_types(), message_type).decode
    return [decode(encoded).tick for name, encoded in messages if name == channel]


@pytest.mark.parametrize(
    ("channel", "message_type", "first", "period"),
    [
        ("SUREFOOT_STATE", "controller_state_t", 0, _EVERY_TICKS),
        ("SUREFOOT_TRUTH", "simulator_truth_t", 0, _EVERY_TICKS),
        ("SUREFOOT_BUS", "bus_statistics_t", 99, 100),
        ("SUREFOOT_TIMING", "timing_statistics_t", 999, 1000),
    ],
)
def test_every_channel_is_heard_at_its_rate(live_run: Path, channel: str, message_type: str, first: int, period: int):
    heard = _ticks(_messages(live_run / "heard.lcmlog"), channel, message_type)
    promised = range(first, _TICKS, period)
    assert set(heard) <= set(promised)
    assert heard == sorted(set(heard)), "out of order, or twice"
    assert len(heard) > len(promised) / 2, "UDP may lose some"


def test_timing_of_a_walk_is_of_the_wall_clock(live_run: Path):
    for channel, encoded in _messages(live_run / "heard.lcmlog"):
        if channel == "SUREFOOT_TIMING":
            timing = message_types().timing_statistics_t.decode(encoded)
            assert 0.0 < timing.tick_p50_us <= timing.tick_p999_us <= timing.tick_max_us
            assert timing.allocations == 0 and timing.telemetry_dropped == 0


def test_who_listens_is_told_where_the_scenario_is(live_run: Path):
    told = [encoded for channel, encoded in _messages(live_run / "heard.lcmlog") if channel == "SUREFOOT_RUN"]
    runs = [message_types().run_t.decode(encoded) for encoded in told]
    assert runs and len({run.started_ns for run in runs}) == 1
    folder = Path(bytes(runs[0].folder).split(b"\0")[0].decode())
    assert folder == live_run / "run" and (folder / "scenario.toml").is_file()


def test_the_log_holds_what_was_heard_but_for_the_wall_clock(live_run: Path):
    recorded = _messages(live_run / "run" / "telemetry.lcmlog")
    heard = [message for message in _messages(live_run / "heard.lcmlog") if message[0] not in _LIVE_ONLY]
    assert {channel for channel, _ in recorded} == {f"SUREFOOT_{name}" for name in ("STATE", "TRUTH", "BUS", "EVENT")}
    rest = iter(recorded)
    assert all(message in rest for message in heard), "heard what is not in the log, or in another order"


def test_live_without_a_multicast_route_is_refused_with_a_remedy(in_own_network: list[str], tmp_path: Path):
    run = tmp_path / "run"
    finished = surefoot("run", *SHORT, "--live", "--out", run, prefix=in_own_network)
    message = finished.stderr.decode()  # liblcm has its own say first
    assert finished.returncode == MACHINE_LACKS, message
    assert finished.stdout == b""
    assert "\nLCM can not open udpm://" in message
    remedy = message.splitlines()[-1]
    assert remedy.startswith("  remedy: ") and "ip route add 224.0.0.0/4 dev lo" in remedy
    assert "a bug" not in message
    assert not (run / "verdict.json").exists()
    finished = surefoot("run", *SHORT, "--out", run, prefix=in_own_network)
    assert finished.returncode == 0, "nothing was recorded, so nothing is in the way of a run without --live"
