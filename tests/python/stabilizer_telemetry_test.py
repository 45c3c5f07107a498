"""Telemetry of the online controllers, read with PyPI's lcm: what each saw and added, and the picture of it."""

from pathlib import Path

import lcm
import matplotlib.pyplot as plt
import numpy as np
import pytest
from command_line import ROOT, surefoot

from tools.plots import look
from tools.plots.__main__ import main
from tools.plots.figures import controllers
from tools.plots.messages import message_types
from tools.plots.read_run import Run, read_run
from tools.plots.time_figure import default_window

_EVERY_TICKS = 10
_ADDED = (
    "pelvis_m", "leg_length_m", "ankle_roll_rad", "ankle_pitch_rad", "hip_roll_rad", "landing_m", "sway_m",
    "sway_centre_m", "earlier_landing_s",
)  # fmt: skip
_FLAGS = ("holds_lowering", "waits_for_contact")
_TOTAL = 17


@pytest.fixture(scope="module")
def walk_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three seconds of steps on tiles, with a set in which a controller of ours acts beside the paper's."""
    folder = tmp_path_factory.mktemp("floor") / "run"
    finished = surefoot(
        "run", ROOT / "tools" / "scenarios" / "khr2_flat.toml", "--out", folder,
        "--set", "duration_s=3", "--set", "pattern.standing_s=2", "--set", f"telemetry.every_ticks={_EVERY_TICKS}",
        "--set", "stabilizer.set=extended", "--set", "floor.tile_height_m=0.004",
    )  # fmt: skip
    assert finished.returncode == 0, finished.stdout + finished.stderr
    return folder


@pytest.fixture(scope="module")
def walk(walk_folder: Path) -> Run:
    return read_run(walk_folder)


def test_a_floor_walk_has_one_channel_more(walk_folder: Path):
    channels = {record.channel for record in lcm.EventLog(str(walk_folder / "telemetry.lcmlog"), "r")}
    assert channels - {"SUREFOOT_EVENT"} == {f"SUREFOOT_{name}" for name in ("STATE", "TRUTH", "BUS", "STABILIZER")}


def test_the_controllers_are_told_of_with_each_state(walk: Run):
    assert (walk.stabilizer["tick"] == walk.state["tick"]).all()
    assert (np.diff(walk.stabilizer["tick"]) == _EVERY_TICKS).all()
    assert (walk.stabilizer["utime"] == walk.state["utime"]).all()


def test_every_number_is_finite(walk: Run):
    for field, values in walk.stabilizer.items():
        assert np.isfinite(values).all(), field


def test_the_constants_name_the_controllers_in_the_pictures_order():
    message = message_types().stabilizer_t
    assert [getattr(message, name.upper()) for name in controllers.CONTROLLERS] == list(range(_TOTAL))
    assert message.TOTAL == _TOTAL


def test_those_are_on_that_the_effective_scenario_switches_on(walk: Run):
    switches = [walk.scenario["stabilizer"][name] for name in controllers.CONTROLLERS]
    assert 1 < sum(switches) < _TOTAL
    assert (walk.stabilizer["is_on"] == np.array(switches)).all()


def test_only_those_that_are_on_act_or_add(walk: Run):
    columns = walk.stabilizer
    is_off = columns["is_on"][0] == 0
    assert not columns["is_active"][:, is_off].any()
    for field in (*_ADDED, *_FLAGS):
        assert not columns[field][:, :_TOTAL][:, is_off].any(), field
    assert columns["is_active"].any(axis=0).sum() == (~is_off).sum(), "each has its time in a walk of several steps"


def test_the_total_is_the_sum_of_what_each_adds(walk: Run):
    # Of stabilizer::AdjustmentLimits; in this run nothing is cut.
    limits = {
        "pelvis_m": 0.05, "leg_length_m": 0.02, "ankle_roll_rad": 0.15, "ankle_pitch_rad": 0.15, "landing_m": 0.05,
    }  # fmt: skip
    for field in _ADDED:
        each, total = walk.stabilizer[field][:, :_TOTAL], walk.stabilizer[field][:, _TOTAL]
        assert np.abs(total).max() < limits.get(field, np.inf), field
        assert np.allclose(each.sum(axis=1), total, atol=1e-6), field
    for field in _FLAGS:
        each, total = walk.stabilizer[field][:, :_TOTAL], walk.stabilizer[field][:, _TOTAL]
        assert (each.any(axis=1) == (total != 0)).all(), field
    assert np.abs(walk.stabilizer["ankle_roll_rad"][:, _TOTAL]).max() > 1e-3, "tiles give them something to do"


def test_the_stages_follow_each_other_as_the_paper_has_them(walk: Run):
    stage = walk.stabilizer["stage"]
    story = stage[np.concatenate(([True], np.diff(stage) != 0))].tolist()
    assert story[:2] == [0, 1]
    steps = [2, 3, 4, 5] * len(story)
    assert len(story) >= 6 and story[2:] == steps[: len(story) - 2]


def test_what_they_see_is_what_the_robot_does(walk: Run):
    walks = walk.stabilizer["time_s"] >= 0.0
    for axis, field in enumerate(("torso_roll_rate_rad_s", "torso_pitch_rate_rad_s")):
        true_rad_s = walk.truth["body_rate_body_rad_s"][walks, axis]
        assert np.corrcoef(walk.stabilizer[field][walks], true_rad_s)[0, 1] > 0.9, field
        assert np.abs(walk.stabilizer[field][walks]).max() == pytest.approx(np.abs(true_rad_s).max(), rel=0.2), field
    force_n = walk.state["foot_force_n"]
    in_range = force_n < 999.0
    assert np.allclose(walk.stabilizer["ankle_force_n"][in_range], force_n[in_range], atol=1e-2)
    carries = force_n > 50.0
    assert (np.abs(walk.stabilizer["zmp_y_foot_m"][carries & in_range]) <= 0.0701).all(), "beyond the sole's edge"
    assert not walk.stabilizer["zmp_y_foot_m"][force_n < 48.0].any()


def test_the_picture_shows_what_each_adds_in_units(walk_folder: Path, walk: Run):
    assert main([str(walk_folder), "--only", "controllers"]) == 0
    assert (walk_folder / "controllers.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    look.apply()
    figure = controllers.figure(walk, default_window(walk))
    quantities = figure.axes[:-1]
    assert len(quantities) > 4
    for axis in quantities:
        assert axis.get_ylabel().endswith(("(deg)", "(mm)", "(ms)")), axis.get_ylabel()
    (ankle,) = [axis for axis in quantities if axis.get_ylabel() == "ankle roll\nright (deg)"]
    (total,) = [line for line in ankle.lines if line.get_label() == "total"]
    recorded = walk.stabilizer["ankle_roll_rad"][:, _TOTAL, 0][walk.stabilizer["time_s"] >= -1.0]
    assert np.degrees(recorded) == pytest.approx(total.get_ydata())
    plt.close(figure)


def test_the_picture_of_a_robot_without_them_is_refused_with_a_remedy(synthetic_run: Path, capsys):
    assert main([str(synthetic_run), "--only", "controllers"]) == 65
    message = capsys.readouterr().err
    assert str(synthetic_run) in message and "remedy:" in message
