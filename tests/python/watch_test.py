"""`surefoot watch`: the live page shows what is recorded meanwhile, run after run."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from browser import browser
from command_line import MACHINE_LACKS, ROOT, SHORT, USAGE, assert_refused

from tools.plots.read_run import read_run

_MULTICAST_OVER_LO = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
exec "$@"
"""
_SECOND = ["tools/scenarios/khr2_uneven.toml", "--set", "duration_s=0.5"]
_PACE = ["--pace", "4"]


def _watch(*arguments: object, **options: object) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "tools.watch", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False, timeout=30, cwd=ROOT, **options)


@pytest.fixture(scope="module")
def watched(in_own_network: list[str], tmp_path_factory: pytest.TempPathFactory) -> tuple[dict, Path]:
    """What the page showed of two walks of two robots, and where they are recorded."""
    with browser():
        pass  # or skip
    folder = tmp_path_factory.mktemp("watched")
    script = [sys.executable, ROOT / "tests" / "python" / "watched_run.py", folder]
    finished = subprocess.run(
        [*in_own_network, "--fork", "--pid", "--kill-child", "sh", "-c", _MULTICAST_OVER_LO, "sh", *map(str, [*script, *SHORT, *_PACE, "--", *_SECOND, *_PACE])],
        capture_output=True, text=True, timeout=500, check=False, cwd=ROOT,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stderr
    return json.loads(finished.stdout), folder


def test_it_waits_for_a_run(watched: tuple[dict, Path]) -> None:
    assert "Waiting for a run" in watched[0]["before"]


@pytest.mark.parametrize("number", [0, 1])
def test_the_last_pose_drawn_is_one_that_is_recorded(watched: tuple[dict, Path], number: int) -> None:
    told, folder = watched
    truth = read_run(folder / str(number)).truth
    pose = told["walks"][number]["pose"]
    drawn = np.hstack([truth["angle_rad"].reshape(len(truth["time_s"]), -1), truth["body_position_world_m"]])
    rows = np.flatnonzero((drawn == [*pose["joint_rad"], *pose["position_world_m"]]).all(axis=1))
    assert rows.size == 1
    # At this pace a busy machine loses a part of the last second.
    assert np.median(truth["time_s"]) < truth["time_s"][rows[0]] <= pose["time_s"]


@pytest.mark.parametrize("number", [0, 1])
def test_events_and_verdict_are_those_of_the_run(watched: tuple[dict, Path], number: int) -> None:
    told, folder = watched
    shown = told["walks"][number]
    assert shown["name"] == str(folder / str(number))
    assert shown["events"] == [event.name for event in read_run(folder / str(number)).events]
    assert shown["verdict"] == json.loads((folder / str(number) / "verdict.json").read_text())["verdict"]


# How many depends on the machine: 60 a wall second at best, of 4000 ticks at this pace.
def test_some_rows_come_and_by_far_not_all(watched: tuple[dict, Path]) -> None:
    told, folder = watched
    for number, shown in enumerate(told["walks"]):
        ticks = len(read_run(folder / str(number)).state["time_s"])
        assert 10 < shown["received"] < ticks / 2
        assert shown["drawn"] > 0 and shown["plots"] >= 10


def test_who_comes_late_sees_events_and_verdict(watched: tuple[dict, Path]) -> None:
    told, _ = watched
    assert told["joined_late"]["events"] == len(told["walks"][-1]["events"])
    assert told["joined_late"]["verdict"] == told["walks"][-1]["verdict"]


def test_only_this_machine_by_its_own_name_gets_the_page(watched: tuple[dict, Path]) -> None:
    assert watched[0]["own_host"] == 200 and watched[0]["foreign_host"] == 404


def test_a_page_of_another_place_gets_no_feed(watched: tuple[dict, Path]) -> None:
    assert watched[0]["foreign_origin"] == 403 and watched[0]["own_origin"] == 101


def test_what_cannot_be_served_says_why(in_own_network: list[str]) -> None:
    assert_refused(_watch("--port", "70000"), USAGE, "surefoot watch")
    assert_refused(_watch("--frobnicate"), USAGE, "surefoot watch")
    finished = subprocess.run(
        [*in_own_network, sys.executable, "-m", "tools.watch"], capture_output=True, check=False, timeout=30, cwd=ROOT
    )
    assert finished.returncode == MACHINE_LACKS
    assert b"\n  remedy: " in finished.stderr and b"Traceback" not in finished.stderr
