"""The bus log is readable by people who have cantools and surefoot.dbc, and nothing else of ours."""

import hashlib
import json
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import cantools
import pytest
from cantools.logreader import DataFrame, Parser

_DBC = Path(__file__).resolve().parents[2] / "firmware" / "can" / "surefoot.dbc"
_SYNC = 0x080


@pytest.fixture(scope="module")
def database():
    return cantools.database.load_file(_DBC)


@pytest.fixture(scope="module")
def frames(run_folder: Path) -> list[DataFrame]:
    parser = Parser()
    lines = (run_folder / "bus.log").read_text().splitlines()
    parsed = [parser.parse(line) for line in lines]
    unread = [line for line, frame in zip(lines, parsed) if frame is None]
    assert not unread, f"{len(unread)} of {len(lines)} lines are no candump -L lines, the first: {unread[0]}"
    return parsed


@pytest.fixture(scope="module")
def decoded(frames: list[DataFrame], database) -> dict[int, list[dict]]:
    """Signals of every frame by identifier; raises at the first frame that does not decode."""
    by_identifier = defaultdict(list)
    for frame in frames:
        by_identifier[frame.frame_id].append(database.decode_message(frame.frame_id, frame.data, decode_choices=False))
    return by_identifier


def test_every_line_decodes(frames, decoded):
    assert len(frames) > 1000
    assert sum(len(signals) for signals in decoded.values()) == len(frames)


def test_every_frame_has_the_length_that_the_database_says(frames, database):
    wrong = [f for f in frames if len(f.data) != database.get_message_by_frame_id(f.frame_id).length]
    assert not wrong


def test_every_value_is_within_the_range_that_the_database_says(decoded, database):
    for identifier, rows in decoded.items():
        for signal in database.get_message_by_frame_id(identifier).signals:
            values = [row[signal.name] for row in rows]
            if signal.minimum is not None:
                assert min(values) >= signal.minimum, f"{identifier:#x} {signal.name}"
            if signal.maximum is not None:
                assert max(values) <= signal.maximum, f"{identifier:#x} {signal.name}"


def test_the_rolling_counter_of_each_identifier_moves_on_by_one(decoded):
    for identifier, rows in decoded.items():
        if "counter" not in rows[0]:
            continue
        counters = [row["counter"] for row in rows]
        steps = {(after - before) % 256 for before, after in zip(counters, counters[1:])}
        assert steps <= {1}, f"{identifier:#x} steps by {steps}"


def test_sync_counts_the_ticks_without_a_gap(decoded):
    ticks = [row["tick"] for row in decoded[_SYNC]]
    assert ticks == list(range(ticks[0], ticks[0] + len(ticks)))


def test_time_stamps_never_go_back(frames):
    stamps = [frame.timestamp for frame in frames]
    assert all(before <= after for before, after in zip(stamps, stamps[1:]))


def test_the_command_line_of_cantools_decodes_it_too(run_folder: Path):
    head = "".join((run_folder / "bus.log").read_text().splitlines(keepends=True)[:2000])
    finished = subprocess.run(
        [sys.executable, "-m", "cantools", "decode", "--single-line", _DBC],
        input=head,
        capture_output=True,
        text=True,
        check=True,
    )
    lines = finished.stdout.splitlines()
    assert len(lines) == 2000
    assert all("(" in line.split("::")[1] and "counter" in line for line in lines), "a frame was not decoded"
    assert finished.stderr == ""


def test_the_verdict_names_the_hash_of_the_log(run_folder: Path):
    verdict = json.loads((run_folder / "verdict.json").read_text())
    assert verdict["bus_log_sha256"] == hashlib.sha256((run_folder / "bus.log").read_bytes()).hexdigest()


def test_the_verdict_counts_the_frames_of_the_log(run_folder: Path, frames):
    verdict = json.loads((run_folder / "verdict.json").read_text())
    assert verdict["frames_sent"] == len(frames)
    assert verdict["frames_lost"] == 0
