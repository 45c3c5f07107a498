"""`surefoot report SWEEP`: a grid whose cells open the runs that they tell of."""

import csv
import json
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from browser import Opened, browser
from command_line import BAD_INPUT, ROOT, USAGE, assert_refused, surefoot

# One limit that any walk breaks, and one that none does.
_SWEEP = """\
[set]
reflex.standing_s = 0.5
detector.warm_up_s = 0
detector.learning_s = 4.8
duration_s = 0.2
payload = []

[grid]
limits.max_abs_pitch_deg = [0.001, 40]
seed = [1, 2]
"""


def _report(*arguments: object) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "tools.report", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False, timeout=120, cwd=ROOT)


@pytest.fixture(scope="module")
def swept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Results of a sweep of four rows, and nothing else yet."""
    folder = tmp_path_factory.mktemp("100 % sweep #")  # of characters that mean something in an address
    (folder / "friction.toml").write_text(_SWEEP)
    finished = surefoot("sweep", folder / "friction.toml", "--out", folder / "swept")
    assert finished.returncode == 0, finished.stderr
    return folder / "swept"


@pytest.fixture(scope="module")
def mapped(swept: Path) -> Path:
    """The same with all its runs recorded, and the map."""
    finished = _report(swept, "--json")
    assert finished.returncode == 0, finished.stderr.decode()
    told = json.loads(finished.stdout)
    assert (told["file"], told["rows"], told["rows_that_open"]) == (str(swept / "map.html"), 4, 4)
    return swept


@pytest.fixture(scope="module")
def new_page() -> Iterator[Callable[[], Opened]]:
    with browser() as open_page:
        yield open_page


def _rows(folder: Path) -> list[dict]:
    with (folder / "results.csv").open(newline="") as lines:
        return list(csv.DictReader(lines))


def test_each_cell_tells_the_outcome_of_its_row(mapped: Path, new_page: Callable[[], Opened]) -> None:
    opened = new_page()
    opened.open_file(mapped / "map.html")
    cells = opened.page.locator(".cell")
    # Limits are along, seeds are down: the grid is the results' order, mirrored.
    rows = sorted(_rows(mapped), key=lambda row: (int(row["seed"]), float(row["limits.max_abs_pitch_deg"])))
    assert cells.all_inner_texts() == [row["outcome"] for row in rows]
    assert len({row["outcome"] for row in rows}) == 2, "the sweep has both"
    cells.nth(2).click()
    details = opened.page.inner_text(".details")
    assert rows[2]["command"] in details and rows[2]["reason"] in details


def test_a_cell_opens_its_run(mapped: Path, new_page: Callable[[], Opened]) -> None:
    opened = new_page()
    opened.open_file(mapped / "map.html")
    for number in range(4):
        opened.page.locator(".cell").nth(number).click()
        outcome = opened.page.locator(".cell").nth(number).inner_text()
        with opened.page.expect_navigation():
            opened.page.click("text=open this run")
        opened.page.evaluate("() => window.surefoot.ready")
        assert opened.page.inner_text(".verdict b") == outcome
        opened.page.go_back()
        opened.page.evaluate("() => window.surefoot.ready")


def test_figures_colour_the_cells(mapped: Path, new_page: Callable[[], Opened]) -> None:
    opened = new_page()
    opened.open_file(mapped / "map.html")
    opened.page.select_option("select[data-of=colour]", "distance_m")
    shown = [float(text) for text in opened.page.locator(".cell").all_inner_texts()]
    recorded = sorted(float(row["distance_m"]) for row in _rows(mapped))
    assert sorted(shown) == pytest.approx(recorded, rel=5e-3)
    opened.page.select_option("select[data-of=down]", "")
    assert opened.page.locator(".cell").count() == 2, "two seeds in a cell"
    opened.page.select_option("select[data-of=colour]", "outcome")
    assert all("/2" in text for text in opened.page.locator(".cell").all_inner_texts())


def test_what_is_recorded_is_not_done_again(mapped: Path) -> None:
    reports = sorted(mapped.glob("rows/*/report.html"))
    written = [report.stat().st_mtime_ns for report in reports]
    assert _report(mapped).returncode == 0
    assert [report.stat().st_mtime_ns for report in reports] == written
    assert len(reports) == 4 and not list(mapped.glob("rows/*/bus.log"))


def test_after_the_sweep_ran_again_its_rows_are_recorded_again(mapped: Path) -> None:
    (mapped / "results.csv").touch()
    (mapped / "rows" / "2" / "report.html").unlink()
    assert json.loads(_report(mapped, "--json").stdout)["rows_that_open"] == 4


def test_failed_runs_only_or_none(mapped: Path, tmp_path: Path) -> None:
    sweep = tmp_path / "sweep"
    shutil.copytree(mapped, sweep, ignore=shutil.ignore_patterns("rows"))
    assert json.loads(_report(sweep, "--runs", "none", "--json").stdout)["rows_that_open"] == 0
    failed = sum(row["outcome"] != "walked" for row in _rows(sweep))
    told = json.loads(_report(sweep, "--runs", "failed", "--json", "--out", tmp_path / "elsewhere.html").stdout)
    assert told["rows_that_open"] == failed
    index = (tmp_path / "elsewhere.html").read_text()
    assert '"report":"sweep/rows/' in index, "links lead from where the page is"


def test_a_run_that_ends_otherwise_than_its_row_is_refused(mapped: Path, tmp_path: Path) -> None:
    shutil.copy(mapped / "results.csv", tmp_path)
    text = (tmp_path / "results.csv").read_text()
    (tmp_path / "results.csv").write_text(text.replace(",walked,", ",fell,", 1))
    assert_refused(_report(tmp_path), BAD_INPUT, tmp_path / "rows", "run the sweep again")


@pytest.mark.parametrize(
    "text",
    [
        "row,outcome,reason,command\r\n../../x,fell,,surefoot run\r\n",
        "row,outcome,reason,command\r\n1,fell,,surefoot run\r\n",
        f"row,a,outcome,reason,command\r\n{'9' * 400},1,fell,,surefoot run\r\n",
        "",
        "row,a\r\n",
        "row,seed,outcome,reason,command\r\n",
        "row,outcome,reason,command\r\n0,fell\r\n",
        "a\r\n\x00\r\n",
    ],
)
def test_damaged_results_are_refused(tmp_path: Path, text: str) -> None:
    (tmp_path / "results.csv").write_text(text)
    assert_refused(_report(tmp_path), BAD_INPUT, tmp_path / "results.csv")


@pytest.mark.parametrize(
    "command",
    ["touch {0}", "surefoot run --bus socketcan:can0", "surefoot run a.toml --out {0}", "surefoot run --set", "surefoot '"],
)
def test_a_command_that_no_sweep_writes_is_not_executed(tmp_path: Path, command: str) -> None:
    touched = tmp_path / "touched"
    (tmp_path / "results.csv").write_text(
        f"row,seed,outcome,reason,command\r\n0,1,fell,it fell,{command.format(touched)}\r\n", newline=""
    )
    assert_refused(_report(tmp_path), BAD_INPUT, tmp_path / "results.csv", "not one of a sweep")
    assert not touched.exists()


def test_markup_in_results_stays_text(tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    (tmp_path / "results.csv").write_text(
        "row,seed,outcome,reason,command\r\n0,1,fell,</script><b>bold</b>,surefoot run\r\n", newline=""
    )
    assert _report(tmp_path, "--runs", "none").returncode == 0
    opened = new_page()
    opened.open_file(tmp_path / "map.html")
    opened.page.locator(".cell").click()
    assert "<b>bold</b>" in opened.page.inner_text(".details")


def test_arguments_that_do_not_go_together_are_refused(mapped: Path, short_run: Path) -> None:
    assert_refused(_report(mapped, short_run), USAGE, "surefoot report")
    assert_refused(_report(short_run, "--runs", "all"), USAGE, "surefoot report")


def test_a_figure_that_is_missing_is_none_and_not_nought(tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    rows = ["0,12345678,fell,,nan,surefoot run", "1,12345679,fell,,4.0,surefoot run", "2,12345679,fell,,nan,surefoot run"]
    rows.append(f"3,{'9' * 400},fell,,,surefoot run")
    text = "\r\n".join(["row,seed,outcome,reason,first_detection_s,command", *rows, ""])
    (tmp_path / "results.csv").write_text(text, newline="")
    assert _report(tmp_path, "--runs", "none").returncode == 0
    opened = new_page()
    opened.open_file(tmp_path / "map.html")
    opened.page.select_option("select[data-of=colour]", "first_detection_s")
    assert opened.page.locator(".cell").all_inner_texts() == ["–", "4", "–"]
    assert "12345678" in opened.page.inner_text(".grid"), "whole numbers are not rounded"
