"""`surefoot report` in a headless browser that has no network: it opens, and shows what was recorded."""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import cantools
import numpy as np
import pytest
from browser import Opened, browser
from command_line import BAD_INPUT, MACHINE_LACKS, ROOT, SHORT, USAGE, assert_refused, surefoot

from tools.plots.read_run import read_run

# Some instants of the main job: standing, walking, in the reflex, after it.
_TIMES_S = [-11.0, -3.0, 1.3, 5.0]
_ANGLE_TOLERANCE_RAD = 1e-4  # 1/65534 of the range of a joint


def _report(*arguments: object, **environment: str) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "tools.report", *map(str, arguments)]
    return subprocess.run(
        command, capture_output=True, check=False, timeout=60, cwd=ROOT, env={**os.environ, **environment}
    )


@pytest.fixture(scope="module")
def report(run_folder: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("report") / "report.html"
    finished = _report(run_folder, "--out", file, "--json")
    assert finished.returncode == 0, finished.stderr.decode()
    assert json.loads(finished.stdout) | {"elapsed_s": 0} == {
        "file": str(file), "size_bytes": file.stat().st_size, "elapsed_s": 0,
    }  # fmt: skip
    return file


@pytest.fixture(scope="module")
def new_page() -> Iterator[Callable[[], Opened]]:
    with browser() as open_page:
        yield open_page


@pytest.fixture(scope="module")
def opened(report: Path, new_page: Callable[[], Opened]) -> Opened:
    page = new_page()
    page.open_file(report)
    return page


def _differing_pixels(first: bytes, second: bytes) -> int:
    return sum(a != b for a, b in zip(first, second, strict=False)) + abs(len(first) - len(second))


def test_it_opens_with_its_verdict_and_every_event(opened: Opened, run_folder: Path) -> None:
    assert opened.page.inner_text(".verdict b") == "walked"
    names = opened.page.eval_on_selector_all(".tick", "ticks => ticks.map(tick => tick.title.split(' ')[0])")
    assert names == [event.name for event in read_run(run_folder).events]


# Axes and grid are grey: colour is of curves.
_COLOURED_PIXELS = """all => all.map(canvas => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let coloured = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [red, green, blue, opacity] = data.subarray(i, i + 4);
    coloured += opacity > 200 && Math.max(red, green, blue) - Math.min(red, green, blue) > 80;
  }
  return coloured;
})"""


def test_plots_are_drawn(opened: Opened) -> None:
    opened.set_time(-11.0)
    coloured = opened.page.eval_on_selector_all(".plot:not([hidden]) canvas", _COLOURED_PIXELS)
    # Every curve is at least as long as the plot is wide, but for the red line of the instant, which is 1 px wide.
    assert len(coloured) >= 8 and all(pixels > 400 for pixels in coloured), coloured


def test_scrubbing_moves_the_robot_to_the_recorded_pose(opened: Opened, run_folder: Path) -> None:
    truth = read_run(run_folder).truth
    pictures = []
    for time_s in _TIMES_S:
        opened.set_time(time_s)
        row = int((truth["time_s"] <= time_s + 1e-9).nonzero()[0][-1])
        drawn = opened.pose()
        recorded = truth["angle_rad"][row].flatten()
        assert max(abs(recorded - drawn["joint_rad"])) < _ANGLE_TOLERANCE_RAD
        assert max(abs(truth["body_position_world_m"][row] - drawn["position_world_m"])) < _ANGLE_TOLERANCE_RAD
        pictures.append(opened.page.locator(".canvas").screenshot())
    for first, second in zip(pictures, pictures[1:], strict=False):
        assert _differing_pixels(first, second) > 1000, "the picture did not change"


# The feet that the page draws from the URDF stand where the simulator's feet stood: on the floor.
def test_the_drawn_robot_stands_on_the_floor(opened: Opened) -> None:
    opened.set_time(-11.0)
    corner_n = opened.pose()["corner_force_n"]
    heights_m = opened.page.evaluate("() => window.surefoot.cornerHeights()")
    assert all(force_n > 0 for force_n in corner_n)
    assert all(abs(height_m) < 2e-3 for height_m in heights_m), heights_m


# The feet that three.js draws from the URDF are where Bullet's were: two independent chains of the same angles.
def test_the_drawn_soles_are_where_the_simulator_has_them(opened: Opened, run_folder: Path) -> None:
    drawn = []
    for time_s in (-11.0, -2.1, 1.27, 1.35, 4.9):
        opened.set_time(time_s)
        drawn.append((opened.pose(), opened.page.evaluate("() => window.surefoot.soles()")))
    asked = json.dumps([pose["joint_rad"] for pose, _ in drawn]).encode()
    told = json.loads(surefoot("model", run_folder / "scenario.toml", "--poses", "-", input=asked).stdout)
    for (pose, soles_m), simulated in zip(drawn, told, strict=True):
        rotation = _rotation(pose["roll_rad"], pose["pitch_rad"], pose["yaw_rad"])
        for sole_m, side in zip(soles_m, ("right_sole", "left_sole"), strict=True):
            expected_m = rotation @ simulated["soles"][side]["place_body_m"] + pose["position_world_m"]
            assert np.abs(expected_m - sole_m).max() < 1e-9


def _rotation(roll_rad: float, pitch_rad: float, yaw_rad: float) -> np.ndarray:
    """World from body, z-y-x."""
    (cr, sr), (cp, sp), (cy, sy) = ((np.cos(a), np.sin(a)) for a in (roll_rad, pitch_rad, yaw_rad))
    about_x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    about_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    return np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]]) @ about_y @ about_x


def test_frames_around_an_instant_read_as_cantools_reads_them(opened: Opened, run_folder: Path) -> None:
    opened.set_time(1.3)
    opened.page.click('nav button:text("bus")')
    opened.page.wait_for_selector(".frames tbody tr")
    rows = opened.page.eval_on_selector_all(
        ".frames tbody tr", "rows => rows.map(row => Array.from(row.cells, cell => cell.innerText))"
    )
    database = cantools.database.load_file(ROOT / "firmware" / "can" / "surefoot.dbc")
    assert len(rows) >= 8
    for _, identifier, name, data, signals in rows:
        message = database.get_message_by_frame_id(int(identifier, 16))
        assert name == message.name
        shown = " ".join(signals.split())
        for signal, value in message.decode(bytes.fromhex(data), decode_choices=False).items():
            assert f"{signal} " in shown
            choices = message.get_signal_by_name(signal).choices
            if choices is None:
                text = shown.split(f"{signal} ")[1].split(" ")[0]
                assert float(text) == pytest.approx(float(value), abs=1e-6), signal
    opened.page.click('nav button:text("plots")')


@pytest.mark.parametrize("page", ["bus", "timing", "faults", "scenario"])
def test_every_page_has_something_to_say(opened: Opened, page: str) -> None:
    opened.page.click(f'nav button:text("{page}")')
    assert len(opened.page.inner_text(".page")) > 30
    opened.page.click('nav button:text("plots")')


def test_the_space_bar_plays(opened: Opened) -> None:
    opened.set_time(0.0)
    opened.page.keyboard.press("Space")
    opened.page.wait_for_function("() => parseFloat(document.querySelector('.clock').textContent) > 0.05")
    opened.page.keyboard.press("Space")


def test_latched_and_injected_faults_are_told_and_marked(tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    run = tmp_path / "fault"
    kinds = ["--set", "fault.0.kind=corrupt", "--set", "fault.0.probability=0.5", "--set", "fault.0.for_s=9"]
    surefoot("run", *SHORT, *kinds, "--set", "fault.0.at_s=0.1", "--set", "duration_s=2", "--out", run)
    assert _report(run, "--no-frames").returncode == 0
    opened = new_page()
    opened.open_file(run / "report.html")
    assert opened.page.inner_text(".verdict b") == "fault"
    opened.page.click('nav button:text("faults")')
    told = opened.page.inner_text(".page")
    assert "kind corrupt" in told and "probability 0.5" in told
    latched = [event for event in read_run(run).events if event.code == 32]
    assert latched and all(f"{event.value:.0f} {event.name}" in told for event in latched)
    assert "Cause." in told
    assert opened.page.locator(".tick.bad").count() >= len(latched)


def test_a_run_without_its_scenario_says_what_is_missing(
    short_run: Path, tmp_path: Path, new_page: Callable[[], Opened]
) -> None:
    run = tmp_path / "run"
    shutil.copytree(short_run, run)
    (run / "scenario.toml").unlink()
    assert _report(run, "--no-frames").returncode == 0
    opened = new_page()
    opened.open_file(run / "report.html")
    assert "scenario.toml" in opened.page.inner_text(".stage")
    opened.page.click('nav button:text("scenario")')
    assert "no scenario.toml" in opened.page.inner_text(".page")


def test_the_timing_page_shows_every_tick_in_its_histogram(opened: Opened, run_folder: Path) -> None:
    opened.page.click('nav button:text("timing")')
    titles = opened.page.eval_on_selector_all(".column", "all => all.map(column => column.title)")
    counts = [int(title.split(": ")[1].split(" ")[0]) for title in titles]
    assert sum(counts) == len(read_run(run_folder).state["time_s"])
    heights = opened.page.eval_on_selector_all(".column div", "all => all.map(bar => bar.getBoundingClientRect().height)")
    assert heights[counts.index(max(counts))] == max(heights) > 100
    opened.page.click('nav button:text("plots")')


def test_two_runs_stand_side_by_side(run_folder: Path, tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    fallen = tmp_path / "fallen"
    surefoot("run", "--set", "reflex.method=off", "--set", "duration_s=9", "--out", fallen)
    file = tmp_path / "compared.html"
    assert _report(run_folder, fallen, "--out", file, "--no-frames").returncode == 0
    opened = new_page()
    opened.open_file(file)
    assert opened.page.locator(".verdict b").all_inner_texts() == ["walked", "fell"]
    assert opened.page.locator(".lane").count() == 2
    assert opened.page.locator(".plot").first.locator(".second").count() == 2
    opened.page.set_viewport_size({"width": 1000, "height": 700})
    # The plots follow the window, as soon as the browser has laid them out anew.
    width_px = "place => document.querySelector(place).getBoundingClientRect().width"
    opened.page.wait_for_function(f"() => Math.abs(({width_px})('.plot') - ({width_px})('.plot canvas')) <= 1")
    assert opened.page.evaluate(width_px, ".plot") < 600


def test_an_interrupted_run_shows_what_there_is(run_folder: Path, tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    cut = tmp_path / "cut"
    shutil.copytree(run_folder, cut)
    (cut / "verdict.json").unlink()
    log = cut / "telemetry.lcmlog"
    with log.open("r+b") as file:
        file.truncate(log.stat().st_size // 2 + 7)
    assert _report(cut).returncode == 0
    opened = new_page()
    opened.open_file(cut / "report.html")
    assert opened.page.inner_text(".verdict b") == "interrupted"


# A name, a reason or a scenario is text, whatever is written in it.
def test_markup_in_a_scenario_stays_text(short_run: Path, tmp_path: Path, new_page: Callable[[], Opened]) -> None:
    run = tmp_path / "<b>bold"
    shutil.copytree(short_run, run)
    with (run / "scenario.toml").open("a") as scenario:
        scenario.write("# </script><script>document.title = 'taken'</script>\n")
    file = tmp_path / "report.html"
    assert _report(run, "--out", file, "--no-frames").returncode == 0
    opened = new_page()
    opened.open_file(file)
    assert "taken" not in opened.page.title()
    assert "<b>bold" in opened.page.inner_text(".verdict .name")


_WALKED = '{"verdict": "walked", "distance_m": '


@pytest.mark.parametrize("text", ["[]", "{", "[" * 99999, '{"verdict": 3}', _WALKED + "NaN}", _WALKED + "1e999}"])
def test_a_damaged_verdict_is_refused(short_run: Path, tmp_path: Path, text: str) -> None:
    run = tmp_path / "run"
    shutil.copytree(short_run, run)
    (run / "verdict.json").write_text(text)
    assert_refused(_report(run), BAD_INPUT, run / "verdict.json")


@pytest.mark.parametrize("text", ["fault = 3", "fault = [1]", "duration_s = = 3"])
def test_a_damaged_scenario_is_refused(short_run: Path, tmp_path: Path, text: str) -> None:
    run = tmp_path / "run"
    shutil.copytree(short_run, run)
    (run / "scenario.toml").write_text(text)
    assert_refused(_report(run), BAD_INPUT, run / "scenario.toml")


def test_what_cannot_be_shown_says_why(short_run: Path, tmp_path: Path) -> None:
    assert_refused(_report(tmp_path), BAD_INPUT, tmp_path / "telemetry.lcmlog")
    assert_refused(_report(short_run, "--out", tmp_path / "no" / "x.html"), MACHINE_LACKS, tmp_path / "no" / "x.html")
    assert_refused(_report(), USAGE, "surefoot report")
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    (foreign / "telemetry.lcmlog").write_bytes(b"something else, long enough to have a header")
    assert_refused(_report(foreign), BAD_INPUT, foreign / "telemetry.lcmlog")
