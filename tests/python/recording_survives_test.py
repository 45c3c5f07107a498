"""A run that cannot be recorded, or is cut short, says so and loses nothing that was recorded before."""

import hashlib
import json
import resource
import shutil
import signal
import subprocess
from pathlib import Path

import pytest
from command_line import BAD_INPUT, INTERRUPTED, MACHINE_LACKS, SHORT, assert_refused, binary, surefoot, wait_until
from recorded_log import count_events, count_frames

_FILES = ["bus.log", "scenario.toml", "telemetry.lcmlog", "verdict.json"]


def _names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def _contents(folder: Path) -> dict[str, str]:
    return {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in folder.iterdir()}


@pytest.fixture
def earlier_run(tmp_path: Path, short_run: Path) -> Path:
    """A recorded run that a test may do harm to."""
    return shutil.copytree(short_run, tmp_path / "earlier")


# Folders that cannot be made


@pytest.mark.parametrize("form", [[], ["--json"]], ids=["text", "json"])
@pytest.mark.parametrize("folder", ["file", "file/below", "/proc/surefoot", "/dev/full"])
def test_folder_that_cannot_be_made_is_refused(tmp_path: Path, folder: str, form: list[str]):
    (tmp_path / "file").write_text("mine")
    finished = surefoot("run", *SHORT, "--out", folder, *form, cwd=tmp_path)
    assert_refused(finished, MACHINE_LACKS, f"{folder}: cannot be made", "--out")
    assert (tmp_path / "file").read_text() == "mine"


def test_folder_that_may_not_be_written_is_refused(tmp_path: Path, without_privilege: list[str]):
    (tmp_path / "locked").mkdir(mode=0o555)
    for out, place in (("locked", "locked/bus.log: "), ("locked/below", "locked/below: ")):
        finished = surefoot("run", *SHORT, "--out", out, prefix=without_privilege, cwd=tmp_path)
        assert_refused(finished, MACHINE_LACKS, place, "Permission denied")
    (tmp_path / "runs").mkdir(mode=0o555)
    finished = surefoot("run", *SHORT, prefix=without_privilege, cwd=tmp_path)
    assert_refused(finished, MACHINE_LACKS, "runs/main-", "Permission denied")


@pytest.mark.parametrize("file", _FILES)
def test_folder_in_the_place_of_a_file_is_refused(tmp_path: Path, file: str):
    (tmp_path / "run" / file).mkdir(parents=True)
    for overwrite in ([], ["--overwrite"]):
        finished = surefoot("run", *SHORT, "--out", "run", *overwrite, cwd=tmp_path)
        if file == "verdict.json" and overwrite:
            assert finished.returncode == 0, "an empty folder is nothing to keep"
        else:
            assert_refused(finished, MACHINE_LACKS, f"run/{file}: ")


# Folders that hold a run


def test_earlier_run_is_not_overwritten(earlier_run: Path):
    before = _contents(earlier_run)
    assert_refused(surefoot("run", *SHORT, "--out", earlier_run), MACHINE_LACKS, earlier_run, "--overwrite")
    assert _contents(earlier_run) == before


def test_earlier_run_survives_a_bad_scenario(earlier_run: Path):
    before = _contents(earlier_run)
    finished = surefoot("run", "--set", "duration_s=-1", "--out", earlier_run, "--overwrite")
    assert_refused(finished, BAD_INPUT, "--set duration_s=-1")
    assert _contents(earlier_run) == before


def test_earlier_run_is_overwritten_on_request_and_its_verdict_goes_first(earlier_run: Path):
    finished = surefoot(
        "run", *SHORT, "--out", earlier_run, "--overwrite", preexec_fn=lambda: _limit_file_size(100_000)
    )
    assert_refused(finished, MACHINE_LACKS, earlier_run)
    assert "verdict.json" not in _names(earlier_run), "speaks of a log that is no more"
    finished = surefoot("run", *SHORT, "--out", earlier_run, "--overwrite")
    assert finished.returncode == 0, finished.stderr
    assert _names(earlier_run) == _FILES


def test_runs_that_start_at_the_same_time_do_not_share_a_folder(tmp_path: Path):
    runs = [
        subprocess.Popen([binary(), "run", *SHORT], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for _ in range(4)
    ]
    outputs = [run.communicate(timeout=60) for run in runs]
    assert [run.returncode for run in runs] == [0] * 4, outputs
    folders = list((tmp_path / "runs").iterdir())
    assert len(folders) == 4
    assert all(_names(folder) == _FILES for folder in folders)


# Full disks


def _limit_file_size(size: int) -> None:
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


# Thinned out, telemetry is the smaller of the two files, and bus.log meets the limit.
@pytest.mark.parametrize("form", [[], ["--json"]], ids=["text", "json"])
@pytest.mark.parametrize("size", [20_000, 1_000_003])
@pytest.mark.parametrize("every_ticks", [1, 1000])
def test_file_that_cannot_grow_keeps_what_it_has(tmp_path: Path, every_ticks: int, size: int, form: list[str]):
    run = tmp_path / "run"
    finished = surefoot(
        "run", *SHORT, "--set", f"telemetry.every_ticks={every_ticks}", "--out", run, *form,
        preexec_fn=lambda: _limit_file_size(size),
    )  # fmt: skip
    assert_refused(finished, MACHINE_LACKS, f"{run}/", ": File too large", "what was recorded until then is kept")
    full = Path(finished.stderr.decode().split(": ")[0]).name
    assert full == "bus.log" or every_ticks == 1
    assert _names(run) == ["bus.log", "scenario.toml", "telemetry.lcmlog"]
    assert size - 600 < (run / full).stat().st_size <= size, "gave up more than the event or line that did not fit"
    assert count_frames(run / "bus.log") > 100
    assert count_events(run / "telemetry.lcmlog") > 0
    _assert_replays(run)


def test_disk_that_is_full_at_once_leaves_no_half_scenario(tmp_path: Path):
    run = tmp_path / "run"
    finished = surefoot("run", *SHORT, "--out", run, preexec_fn=lambda: _limit_file_size(1000))
    assert_refused(finished, MACHINE_LACKS, f"{run}/scenario.toml: cannot be written: File too large")
    assert not (run / "scenario.toml").exists() and not (run / "scenario.toml.unfinished").exists()
    finished = surefoot("run", *SHORT, "--out", run)
    assert finished.returncode == 0, "nothing was recorded, so nothing is in the way of the second attempt"


# A file system of its own, where that may be mounted, is filled; its files are brought out for the checks.
_ON_A_SMALL_DISK = """\
mount -t tmpfs -o size=2m tmpfs "$0" || exit 99
"$@"; code=$?
cp -r "$0/run" "$0.kept"
exit $code"""


def test_full_disk_keeps_what_was_recorded(tmp_path: Path):
    disk, kept = tmp_path / "disk", tmp_path / "disk.kept"
    disk.mkdir()
    finished = surefoot(
        "run", *SHORT, "--out", disk / "run", prefix=["unshare", "-m", "sh", "-c", _ON_A_SMALL_DISK, str(disk)]
    )
    if finished.returncode == 99 or b"unshare: " in finished.stderr:  # not permitted, or a chroot: next best
        kept = disk / "run"
        finished = surefoot("run", *SHORT, "--out", kept, preexec_fn=lambda: _limit_file_size(1 << 20))
    assert_refused(finished, MACHINE_LACKS, disk / "run", "what was recorded until then is kept")
    assert _names(kept) == ["bus.log", "scenario.toml", "telemetry.lcmlog"]
    assert count_frames(kept / "bus.log") > 1000
    assert count_events(kept / "telemetry.lcmlog") > 100
    _assert_replays(kept)


@pytest.mark.parametrize("arguments", [["keys"], ["--help"], ["run", *SHORT, "--json", "--out", "run"]])
def test_output_that_gets_lost_is_a_failure(tmp_path: Path, arguments: list[str]):
    with Path("/dev/full").open("wb") as full:
        finished = subprocess.run(
            [binary(), *arguments], stdout=full, stderr=subprocess.PIPE, cwd=tmp_path, timeout=60, check=False
        )
    assert finished.returncode == MACHINE_LACKS
    assert finished.stderr.decode().startswith("standard output: cannot be written\n  remedy: ")
    if "run" in arguments:
        assert _names(tmp_path / "run") == _FILES


# Interruptions


def _interrupt(run: Path, number: signal.Signals, *arguments: str) -> tuple[int, bytes, bytes]:
    """Starts a run, sends the signal once a part of bus.log is in the file, and not in the middle of a write."""
    process = subprocess.Popen(
        [binary(), "run", "--pace", "5", "--out", run, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    log = run / "bus.log"
    sizes = [0]

    def is_between_two_writes() -> bool:
        sizes.append(log.stat().st_size if log.exists() else 0)
        return process.poll() is not None or 0 < sizes[-2] == sizes[-1]

    try:
        wait_until(is_between_two_writes)
        process.send_signal(number)
        stdout, stderr = process.communicate(timeout=20)
    finally:
        process.kill()
    return process.returncode, stdout, stderr


def _assert_replays(run: Path, may_end_in_mid_tick: bool = True) -> None:
    finished = surefoot("replay", run)
    assert finished.returncode == 0, finished.stderr
    assert b" 0 differ\n" in finished.stdout
    assert may_end_in_mid_tick or b"middle of a tick" not in finished.stdout


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted_run_is_whole_as_far_as_it_went(tmp_path: Path, number: signal.Signals):
    run = tmp_path / "run"
    code, stdout, stderr = _interrupt(run, number, "--json")
    assert code == INTERRUPTED and stderr == b""
    verdict = json.loads(stdout)
    assert json.loads((run / "verdict.json").read_text()) == verdict
    assert verdict["verdict"] == "interrupted" and "what was recorded is kept" in verdict["reason"]
    assert verdict["bus_log_sha256"] == _contents(run)["bus.log"]
    assert _names(run) == _FILES
    assert count_frames(run / "bus.log") == verdict["frames_sent"]
    assert count_events(run / "telemetry.lcmlog") > 100
    _assert_replays(run, may_end_in_mid_tick=False)


def test_interrupted_run_says_so_in_words_too(tmp_path: Path):
    code, stdout, _ = _interrupt(tmp_path / "run", signal.SIGINT)
    assert code == INTERRUPTED
    assert b"verdict      interrupted: stopped at" in stdout


def test_killed_run_leaves_valid_shorter_files_and_no_verdict(tmp_path: Path):
    run = tmp_path / "run"
    code, _, _ = _interrupt(run, signal.SIGKILL)
    assert code == -signal.SIGKILL
    assert _names(run) == ["bus.log", "scenario.toml", "telemetry.lcmlog"]
    assert count_frames(run / "bus.log") > 100
    count_events(run / "telemetry.lcmlog")
    _assert_replays(run)
