"""`surefoot table`, `triggers` and `map`: a few cells end to end, cut short and resumed, and refusals."""

import csv
import io
import json
import os
import signal
import subprocess
from pathlib import Path

import pytest
from command_line import BAD_INPUT, INTERRUPTED, MACHINE_LACKS, USAGE, assert_refused, binary, surefoot, wait_until

CELLS = ["--masses", "2.5,5,15", "--times", "0.6,1.2,3.0,3.6"]


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where journals are, of this test alone."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache" / "surefoot"


def _journals(cache: Path) -> list[Path]:
    return sorted(cache.glob("*.journal"))


def test_a_dozen_cells_of_table_4_1_come_out_as_printed(cache: Path):
    finished = surefoot("table", "off", *CELLS, "--csv")
    assert finished.returncode == 0, finished.stderr
    rows = list(csv.DictReader(io.StringIO(finished.stdout.decode())))
    assert len(rows) == 12
    # 5 kg is where the plant's calibration decides; 2.5 and 15 kg must come out on any plant that is called thesis.
    sure = [row for row in rows if row["mass_kg"] != "5"]
    assert [row["survives"] for row in sure] == [row["reference"] for row in sure]
    for row in rows:
        assert (row["direction"] == "forward") == (row["outcome"] == "fell")
        assert row["after_trigger_s"] == "", "nothing answers the load"
    assert _journals(cache) == [], "what is printed need not be resumed"


def test_an_interrupted_table_goes_on_where_it_stopped_and_prints_the_same_bytes(cache: Path):
    arguments = ["table", "original", "--masses", "5,15", "--times", "0.6,1.2,3.0,3.6", "--falls"]
    whole = surefoot(*arguments, "--jobs", "2")
    assert whole.returncode == 0, whole.stderr

    process = subprocess.Popen([binary(), *arguments, "--jobs", "1"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    wait_until(lambda: any(path.read_text().count("\n") >= 3 for path in _journals(cache)), 60.0)
    process.send_signal(signal.SIGINT)
    out, message = process.communicate(timeout=60)
    assert process.returncode == INTERRUPTED, message
    assert out == b""
    assert b"of 8 runs" in message and b"remedy: the same command goes on" in message
    (journal,) = _journals(cache)
    kept = journal.read_text()
    assert 3 <= kept.count("\n") < 9

    resumed = surefoot(*arguments)
    assert resumed.returncode == 0, resumed.stderr
    assert resumed.stdout == whole.stdout
    assert _journals(cache) == []

    # What the journal holds is not run again, unless that is asked for.
    head, first, *rest = kept.splitlines()
    line = json.loads(first)
    assert line["verdict"]["outcome"] == 0
    line["verdict"]["outcome"] = 2  # a limit broke
    journal.write_text("\n".join([head, json.dumps(line), *rest, ""]))
    believed = surefoot(*arguments).stdout
    assert believed != whole.stdout and b" l! " in believed
    journal.write_text("\n".join([head, json.dumps(line), *rest, ""]))
    assert surefoot(*arguments, "--fresh").stdout == whole.stdout


def test_requiring_more_survivors_than_there_are_fails(cache: Path):
    finished = surefoot("table", "off", "--masses", "15", "--times", "1.2", "--require", "1")
    assert finished.returncode == 2
    assert b"0 of 1 cells survive" in finished.stdout
    assert b"--require 1 is not met" in finished.stderr


def test_another_table_can_be_compared_with(cache: Path, tmp_path: Path):
    reference = tmp_path / "mine.csv"
    reference.write_text("load_time_s,15\n1.2,1\n")
    finished = surefoot("table", "off", "--masses", "15", "--times", "1.2", "--compare", reference)
    assert b"f!" in finished.stdout and b"1 differ (!): 0 survive here only, 1 there only" in finished.stdout


def test_pictures_are_drawn_beside_what_is_printed(cache: Path, tmp_path: Path):
    picture = tmp_path / "table.png"
    finished = surefoot("table", "off", "--masses", "15", "--times", "1.2,1.4", "--png", picture)
    assert finished.returncode == 0, finished.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert_refused(surefoot("table", "off", "--png", tmp_path / "nowhere" / "x.png"), MACHINE_LACKS, tmp_path)


def test_a_map_sets_method_beside_method(cache: Path, tmp_path: Path):
    spec = tmp_path / "map.toml"
    spec.write_text(
        'title = "loads"\nmethods = ["off", "original"]\n'
        '[columns]\ntitle = "at, s"\nkey = "payload.0.at_s"\nvalues = [0.6, 1.2]\n'
        '[rows]\ntitle = "load, kg"\nkey = "payload.0.mass_kg"\nvalues = [5.0, 15.0]\n'
    )
    finished = surefoot("map", spec, "--json")
    assert finished.returncode == 0, finished.stderr
    off, original = json.loads(finished.stdout)["methods"]
    assert off["cells"][1] == [0, 0], "15 kg need a reflex"
    assert original["cells"][0] == [1, 1]
    assert _journals(cache) == []


def test_the_printed_specification_of_a_kind_is_one(cache: Path, tmp_path: Path):
    spec = tmp_path / "mine.toml"
    spec.write_bytes(surefoot("map", "--kind", "push", "--print").stdout)
    assert_refused(surefoot("map", spec, "--set", "nonsense=1"), BAD_INPUT, "--set nonsense=1")


def test_the_detector_sees_a_heavy_load_soon_and_no_load_in_noise(cache: Path):
    finished = surefoot("triggers", "delay", "--masses", "15", "--times", "1.2", "--json")
    assert finished.returncode == 0, finished.stderr
    (cell,) = json.loads(finished.stdout)["delays"]
    assert 0.0 < cell["delay_s"] <= 0.15
    finished = surefoot("triggers", "noise", "--cycles", "2", "--cycles-per-run", "1", "--json")
    assert finished.returncode == 0, finished.stderr
    study = json.loads(finished.stdout)
    assert study["false_alarms"] == 0 and len(set(study["run_margins_n"])) == 2, "each run has its own seed"
    assert 0.0 < study["smallest_margin_n"] < 30.0


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["table"], USAGE, "surefoot table: "),
        (["table", "original", "--masses", "5,x"], USAGE, "surefoot table: "),
        (["table", "original", "--random", "5", "--masses", "5"], USAGE, "surefoot table: "),
        (["table", "original", "--random", "5", "--band"], USAGE, "surefoot table: "),
        (["table", "original", "--png", "picture.txt"], USAGE, "surefoot table: "),
        (["table", "no\x1bnsense"], BAD_INPUT, "--set reflex.method="),
        (["table", "original", "--times", "4000"], BAD_INPUT, "--set duration_s="),
        (["table", "original", "--compare", "/nowhere.csv"], BAD_INPUT, "/nowhere.csv"),
        (["table", "original", "--scenario", "/nowhere.toml"], BAD_INPUT, "/nowhere.toml"),
        (["triggers", "sometimes"], USAGE, "surefoot triggers: "),
        (["triggers", "noise", "--cycles", "0"], USAGE, "surefoot triggers: "),
        (["map"], USAGE, "surefoot map: "),
        (["map", "--kind", "sideways"], USAGE, "surefoot map: "),
        (["map", "/nowhere.toml"], BAD_INPUT, "/nowhere.toml"),
        (["map", "--kind", "push", "--methods", "luck"], BAD_INPUT, "--set reflex.method=luck"),
    ],
)
def test_what_cannot_be_used_is_refused_with_place_and_remedy(cache: Path, arguments: list[str], code: int, said: str):
    assert_refused(surefoot(*arguments), code, said)


def test_a_cache_that_cannot_be_written_is_said(tmp_path: Path):
    (tmp_path / "cache").write_text("a file where a folder should be")
    environment = {**os.environ, "XDG_CACHE_HOME": str(tmp_path / "cache")}
    finished = surefoot("table", "off", "--masses", "5", "--times", "1.2", env=environment)
    assert_refused(finished, MACHINE_LACKS, tmp_path)
