"""`surefoot sweep`: the same bytes however it was interrupted and wherever its rows ran; no input breaks it."""

import csv
import fcntl
import json
import random
import shlex
import signal
import subprocess
from pathlib import Path

import pytest
from command_line import BAD_INPUT, INTERRUPTED, MACHINE_LACKS, USAGE, assert_refused, binary, surefoot, wait_until
from dask_cluster import DaskCluster

_ROWS = 6
_SWEEP = """\
[set]
reflex.standing_s = 0.5
detector.warm_up_s = 0
detector.learning_s = 4.8
duration_s = 0.3
payload = []
sensor.force_noise_n = 2

[grid]
floor.friction = [0.11, 0.2, 0.3]
seed = [1, 2]
"""


@pytest.fixture(scope="module")
def sweep_file(tmp_path_factory) -> Path:
    file = tmp_path_factory.mktemp("sweep") / "it's.toml"
    file.write_text(_SWEEP)
    return file


@pytest.fixture(scope="module")
def expected_csv(sweep_file, tmp_path_factory) -> bytes:
    """The results of an uninterrupted run on one thread."""
    folder = tmp_path_factory.mktemp("expected")
    finished = surefoot("sweep", sweep_file, "--out", folder, "--jobs", 1)
    assert finished.returncode == 0, finished.stderr
    assert f"rows         {_ROWS}: " in finished.stdout.decode()
    return (folder / "results.csv").read_bytes()


def _kept_rows(folder: Path) -> int:
    journal = folder / "journal.jsonl"
    return max(0, journal.read_bytes().count(b"\n") - 1) if journal.exists() else 0


def _assert_finishes_as_expected(sweep_file: Path, folder: Path, expected: bytes, *more: object) -> None:
    finished = surefoot("sweep", sweep_file, "--out", folder, *more)
    assert finished.returncode == 0, finished.stderr
    assert (folder / "results.csv").read_bytes() == expected


def test_four_threads_leave_the_same_bytes_as_one(sweep_file, expected_csv, tmp_path):
    finished = surefoot("sweep", sweep_file, "--out", tmp_path, "--jobs", 4, "--csv", "-")
    assert finished.returncode == 0
    assert finished.stdout == expected_csv


@pytest.mark.parametrize("blow", [signal.SIGINT, signal.SIGKILL])
def test_a_struck_down_sweep_goes_on_and_leaves_the_same_bytes(blow, sweep_file, expected_csv, tmp_path):
    command = [binary(), "sweep", sweep_file, "--out", tmp_path, "--jobs", "1"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        wait_until(lambda: _kept_rows(tmp_path) > 0 or process.poll() is not None, 60.0)
        process.send_signal(blow)
        _, message = process.communicate(timeout=60)
    has_finished = process.returncode == 0  # on a machine where this test was asleep for a second
    if not has_finished and blow is not signal.SIGKILL:
        assert process.returncode == INTERRUPTED
        assert f"stopped; {_kept_rows(tmp_path)} of {_ROWS} rows are kept\n  remedy: " in message.decode()
    assert has_finished or not (tmp_path / "results.csv").exists()
    _assert_finishes_as_expected(sweep_file, tmp_path, expected_csv)


def test_a_journal_cut_off_in_a_line_goes_on_and_leaves_the_same_bytes(sweep_file, expected_csv, tmp_path):
    _assert_finishes_as_expected(sweep_file, tmp_path, expected_csv)
    journal = tmp_path / "journal.jsonl"
    whole = journal.read_bytes()
    journal.write_bytes(whole[: len(whole) - 200])
    _assert_finishes_as_expected(sweep_file, tmp_path, expected_csv)
    assert sorted(journal.read_bytes().splitlines()) == sorted(whole.splitlines())


def test_a_full_disk_is_said_and_what_was_kept_counts(sweep_file, expected_csv, tmp_path):
    finished = surefoot("sweep", sweep_file, "--out", tmp_path, "--jobs", 1, prefix=["prlimit", "--fsize=2500"])
    assert_refused(finished, MACHINE_LACKS, tmp_path / "journal.jsonl", "cannot be written", "finished trials are kept")
    assert 0 < _kept_rows(tmp_path) < _ROWS
    _assert_finishes_as_expected(sweep_file, tmp_path, expected_csv)


def test_the_rows_of_another_sweep_are_refused_and_kept(sweep_file, tmp_path):
    other = tmp_path / "other.toml"
    other.write_text(_SWEEP.replace("0.11", "0.12"))
    folder = tmp_path / "out"
    folder.mkdir()
    part = surefoot("sweep-rows", other, "--rows", "0-0", "--out", folder / "journal.jsonl")
    assert part.returncode == 0, part.stderr
    before = (folder / "journal.jsonl").read_bytes()
    finished = surefoot("sweep", sweep_file, "--out", folder)
    assert_refused(finished, BAD_INPUT, f"{folder}/journal.jsonl:2", "belongs to another batch: row 0")
    assert (folder / "journal.jsonl").read_bytes() == before


def test_a_folder_that_another_sweep_writes_into_is_refused(sweep_file, tmp_path):
    with (tmp_path / "journal.jsonl").open("w") as journal:
        fcntl.flock(journal, fcntl.LOCK_EX)
        finished = surefoot("sweep", sweep_file, "--out", tmp_path)
    assert_refused(finished, BAD_INPUT, tmp_path / "journal.jsonl", "is being written by another process")


def test_the_command_of_a_row_repeats_it_to_the_last_bit(expected_csv):
    rows = list(csv.DictReader(expected_csv.decode().splitlines()))
    assert [(row["floor.friction"], row["seed"]) for row in rows[:3]] == [("0.11", "1"), ("0.11", "2"), ("0.2", "1")]
    program, *arguments = shlex.split(rows[3]["command"])
    assert program == "surefoot"
    verdict = json.loads(surefoot(*arguments, "--no-record", "--json").stdout)
    assert verdict["verdict"] == rows[3]["outcome"]
    pitch_deg = [float(rows[3]["pitch_min_deg"]), float(rows[3]["pitch_max_deg"])]
    assert list(verdict["torso_pitch_deg"].values()) == pitch_deg
    assert verdict["foot_slip_mm"] == float(rows[3]["foot_slip_mm"])
    assert rows[3]["pitch_min_deg"] != rows[1]["pitch_min_deg"]


def test_json_holds_the_same_figures(sweep_file, expected_csv, tmp_path):
    finished = surefoot("sweep", sweep_file, "--out", tmp_path, "--json")
    rows = list(csv.DictReader(expected_csv.decode().splitlines()))
    for given, row in zip(json.loads(finished.stdout), rows, strict=True):
        assert list(given) == list(row)
        for name, value in given.items():
            assert row[name] == ("nan" if value is None else str(value)) or float(row[name]) == value


def test_a_slurm_array_and_its_merge_leave_the_same_bytes(sweep_file, expected_csv, tmp_path):
    printed = surefoot("sweep", sweep_file, "--out", tmp_path, "--executor", "slurm")
    assert printed.returncode == 0
    script = printed.stdout.decode()
    assert f"#SBATCH --array=0-{_ROWS - 1}\n" in script
    merge = shlex.split(next(line for line in script.splitlines() if "--merge" in line).removeprefix("#"))
    job = tmp_path / "job.sh"
    job.write_text(script)
    for task in range(_ROWS):
        if task == _ROWS - 1:
            early = subprocess.run(merge, capture_output=True, check=False, timeout=60)
            assert_refused(early, BAD_INPUT, f"{tmp_path}/parts: holds {_ROWS - 1} of {_ROWS} rows")
        environment = {"SLURM_ARRAY_TASK_ID": str(task), "SLURM_CPUS_PER_TASK": "1", "PATH": "/usr/bin:/bin"}
        subprocess.run(["bash", job], check=True, env=environment, timeout=60)
    subprocess.run(merge, check=True, capture_output=True, timeout=60)
    assert (tmp_path / "results.csv").read_bytes() == expected_csv


def test_a_killed_dask_worker_loses_no_row(sweep_file, expected_csv, tmp_path):
    with DaskCluster(tmp_path / "dask", workers=2) as cluster:
        command = [binary(), "sweep", sweep_file, "--out", tmp_path, "--executor", "dask"]
        command += ["--scheduler", cluster.address]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            wait_until(lambda: _kept_rows(tmp_path) > 0 or process.poll() is not None, 60.0)
            cluster.kill_a_worker()
            _, message = process.communicate(timeout=120)
    assert process.returncode == 0, message
    assert (tmp_path / "results.csv").read_bytes() == expected_csv


def test_a_scheduler_that_is_none_is_said(sweep_file, tmp_path):
    finished = surefoot("sweep", sweep_file, "--out", tmp_path, "--executor", "dask", "--scheduler", "nonsense://x")
    assert_refused(finished, MACHINE_LACKS, "dask: no scheduler at nonsense://x", "--scheduler")


@pytest.mark.parametrize(
    "arguments",
    [["--executor", "dask"], ["--scheduler", "tcp://127.0.0.1:1"], ["--json", "--csv", "-"], ["--jobs", "0"]],
)
def test_options_that_contradict_each_other_are_refused(arguments, sweep_file):
    assert_refused(surefoot("sweep", sweep_file, *arguments), USAGE, "surefoot sweep: ")


@pytest.mark.parametrize("rows", ["6-6", "0-6", "2-1", "x", "-1", "0-99999999999999999999"])
def test_rows_that_a_sweep_has_not_are_refused(rows, sweep_file):
    assert_refused(surefoot("sweep-rows", sweep_file, f"--rows={rows}"), BAD_INPUT, f"--rows {rows}", "has rows 0-5")


_HOSTILE = {
    "empty": b"",
    "zeros": b"\0" * 100,
    "no UTF-8": b'[set]\nplant = "\xff\xfe"\n',
    "deep": b"[grid]\nseed = " + b"[" * 5000,
    "deep tables": b"[grid]\n" + b".".join([b"a"] * 5000) + b" = 1\n",
    "long key": b"[grid]\n" + b"payload." + b"0" * 100000 + b".mass_kg = [1]\n",
    "long value": b'[grid]\nplant = ["' + b"x" * 100000 + b'"]\n',
    "control characters": b'[grid]\n"floor.\\u001b[2Jfriction" = [1]\n',
    "too large": b"#" * (5 << 20),
    "many rows": b"[grid]\n" + b"".join(b"payload.%d.mass_kg = [1, 2, 3, 4]\n" % i for i in range(40)),
    "wrong place": b"[grid]\npayload.7.mass_kg = [1]\n",
    "no such scenario": b'scenario = "nowhere.toml"\n[grid]\nseed = [1]\n',
    "itself as scenario": b'scenario = "hostile.toml"\n[grid]\nseed = [1]\n',
    "date": b"[grid]\nfloor.friction = [1979-05-27]\n",
}


@pytest.mark.parametrize("name", _HOSTILE)
def test_a_hostile_sweep_file_is_refused_with_its_name_and_a_remedy(name, tmp_path):
    file = tmp_path / "hostile.toml"
    file.write_bytes(_HOSTILE[name])
    finished = surefoot("sweep", file, "--out", tmp_path / "out")
    place = tmp_path / "nowhere.toml" if name == "no such scenario" else file
    assert_refused(finished, BAD_INPUT, place)


def test_a_file_that_cannot_be_a_sweep_is_refused(tmp_path):
    for file in (tmp_path, tmp_path / "missing.toml", Path("/dev/zero")):
        assert_refused(surefoot("sweep", file, "--out", tmp_path / "out"), BAD_INPUT, file)


def test_damaged_sweep_files_never_find_a_bug(tmp_path):
    whole = (_SWEEP + "[random]\nphysics.step_s = {min = 1e-4, max = 5e-4}\n").encode()
    whole = b"draws = 3\n" + whole
    source = random.Random(4)
    file = tmp_path / "damaged.toml"
    for _ in range(60):
        damaged = bytearray(whole)
        for _ in range(source.randint(1, 4)):
            place = source.randrange(len(damaged))
            damaged[place : place + source.randint(0, 3)] = source.randbytes(source.randint(0, 2)) + source.choice(
                [b"", b"[", b"]", b'"', b"=", b".", b"-", b"9", b"\n", b"{", b"}", b"e9"]
            )
        file.write_bytes(damaged)
        finished = surefoot("sweep-rows", file, "--rows", "2000000-2000000")
        assert_refused(finished, BAD_INPUT, "")
