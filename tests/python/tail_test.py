"""`surefoot tail` prints every event, recorded or live, and says what its value means."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import BAD_INPUT, ROOT, USAGE, assert_refused, binary

from tools.plots.read_run import read_run
from tools.tail.event_line import event_line

_TAIL = [sys.executable, "-m", "tools.tail"]
_LISTEN_THEN_RUN = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
mkfifo "$READY"
"$PYTHON" -m tools.tail --json --count 3 2>"$READY" & tail=$!
read -r listening <"$READY"
"$@" >/dev/null
wait $tail
"""


def _tail(*arguments: object) -> subprocess.CompletedProcess:
    return subprocess.run([*_TAIL, *map(str, arguments)], capture_output=True, check=False, timeout=60, cwd=ROOT)


def test_it_prints_every_recorded_event(run_folder: Path):
    lines = _tail(run_folder).stdout.decode().splitlines()
    events = read_run(run_folder).events
    assert [line.split()[2] for line in lines] == [event.name for event in events]
    assert [float(line.split()[0]) for line in lines] == pytest.approx([event.time_s for event in events], abs=1e-4)
    [attached] = [line for line in lines if "payload_attached" in line]
    assert attached.endswith("5 kg") and "\033" not in attached


def test_json_lines_hold_the_same(run_folder: Path):
    rows = [json.loads(line) for line in _tail(run_folder, "--json").stdout.splitlines()]
    events = read_run(run_folder).events
    assert [(row["name"], row["value"]) for row in rows] == [(event.name, event.value) for event in events]
    assert [row["time_s"] for row in rows] == pytest.approx([event.time_s for event in events])


def test_live_events_arrive(in_own_network: list[str], tmp_path: Path):
    walk = [binary(), "run", "--live", "--pace", "20", "--set", "duration_s=1", "--out", tmp_path / "run"]
    finished = subprocess.run(
        [*in_own_network, "env", f"PYTHON={sys.executable}", f"READY={tmp_path}/ready", "sh", "-c", _LISTEN_THEN_RUN, "sh", *map(str, walk)],
        capture_output=True, text=True, timeout=30, check=False, cwd=ROOT,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stderr
    names = [json.loads(line)["name"] for line in finished.stdout.splitlines()]
    assert names == ["standing_done", "restored", "rested"]


def test_values_have_their_meaning():
    assert event_line(2.0, "fell", 0.610865, False).endswith("pitch +35.0 deg")
    assert event_line(2.0, "fault_latched", 1.0, False).endswith("1 sensor_silent")
    assert event_line(2.0, "push_begins", 0.0, False).endswith("number 0 of the scenario")
    assert "\033[31m" in event_line(2.0, "fell", 0.0, True)


def test_what_is_no_run_is_refused(tmp_path: Path):
    assert_refused(_tail(tmp_path), BAD_INPUT, tmp_path / "telemetry.lcmlog")
    assert_refused(_tail("--frobnicate"), USAGE, "surefoot tail")
