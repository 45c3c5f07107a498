"""Runs rows of a sweep again, recorded this time, each with a report of its own."""

import os
import shlex
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from tools.plots.read_run import RunFolderError
from tools.report.scenario_view import read_verdict
from tools.report.sweep_map import RESULTS

_ROOT = Path(__file__).resolve().parents[2]
_ENDED = (0, 2, 3)  # walked, fell or limit, fault


def report_of(folder: Path, row: int) -> Path:
    return folder / "rows" / str(row) / "report.html"


def is_recorded(folder: Path, row: int) -> bool:
    """Whether the row's report is there and no older than the results."""
    file = report_of(folder, row)
    return file.is_file() and file.stat().st_mtime_ns >= (folder / RESULTS).stat().st_mtime_ns


def record_rows(folder: Path, rows: list[dict], binary: Path, on_done: Callable[[int], None]) -> None:
    """Runs them on all cores; `on_done` hears how many are done.

    Raises RunFolderError when a row's command fails, or ends otherwise than the results say.
    """
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        running = [pool.submit(_record, folder, row, binary) for row in rows]
        try:
            for done, finished in enumerate(as_completed(running), 1):
                finished.result()
                on_done(done)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise


def _record(folder: Path, row: dict, binary: Path) -> None:
    out = report_of(folder, row["row"]).parent
    _finish([str(binary), "run", *_run_arguments(folder, row), "--out", str(out), "--overwrite"], _ENDED, row)
    verdict = read_verdict(out) or {}
    for said, told in (("verdict", "outcome"), ("reason", "reason"), ("distance_m", "distance_m")):
        if told in row and verdict.get(said) != row[told]:
            raise RunFolderError(
                f"{out}: row {row['row']} ends with {told} {verdict.get(said)}, in {RESULTS} with {row[told]}\n"
                "  remedy: the program has changed since; run the sweep again, into another folder"
            )
    report = [sys.executable, "-m", "tools.report", str(out), "--no-frames"]
    _finish(report, (0,), row, {**os.environ, "PYTHONPATH": str(_ROOT), "SUREFOOT_BINARY": str(binary)})
    for log in ("bus.log", "telemetry.lcmlog"):  # 35 MB a row, and its command brings them back to the last bit
        (out / log).unlink()


def _run_arguments(folder: Path, row: dict) -> list[str]:
    """A scenario and what is set in it, as a sweep writes it; anything else is not executed: a file can come from anywhere."""
    try:
        words = shlex.split(row["command"])
    except ValueError:
        words = []
    given = words[2:]
    settings = given[1:] if given and not given[0].startswith("-") else given
    if words[:2] != ["surefoot", "run"] or len(settings) % 2 or any(word != "--set" for word in settings[::2]):
        raise RunFolderError(
            f"{folder / RESULTS}: row {row['row']}: its command is not one of a sweep: {row['command']}\n"
            "  remedy: run the sweep again"
        )
    return given


def _finish(command: list[str], good: tuple[int, ...], row: dict, environment: dict | None = None) -> None:
    finished = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
    if finished.returncode not in good:
        raise RunFolderError(
            f"row {row['row']}: exit code {finished.returncode} of: {shlex.join(command)}\n{finished.stderr.strip()}\n"
            "  remedy: give the command where the sweep was run: paths of scenarios are as they were there"
        )
