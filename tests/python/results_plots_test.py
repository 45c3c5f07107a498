"""Pictures of tables, studies and maps, from results that are made up."""

import io
import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest

from tools.plots import look
from tools.plots.results import floor_traces, planned_zmp, survival_map, survival_table, walking_plan
from tools.plots.results.__main__ import FIGURES, main

TIMES_S, MASSES_KG = [0.1, 0.2, 0.3], [5.0, 15.0]
PLANT = {"method": "original", "plant": "thesis"}
GRID = {"load_times_s": TIMES_S, "masses_kg": MASSES_KG}


def _cells(survives: str, reference: str) -> list[dict]:
    loads = [(time_s, mass_kg) for time_s in TIMES_S for mass_kg in MASSES_KG]
    return [
        {
            "load_time_s": time_s,
            "mass_kg": mass_kg,
            "survives": here == "+",
            "outcome": {"+": "walked", "f": "fell", "l": "limit"}[here],
            "reference": None if there == "-" else there == "+",
        }
        for (time_s, mass_kg), here, there in zip(loads, survives, reference)
    ]


TABLE = {
    "picture": "table", **PLANT, **GRID, "survive": 4, "of": 6,
    "reference": {"name": "paper", "survive": 3, "printed": 4, "differ": 2},
    "cells": _cells("++f+l+", "++++--"),
}  # fmt: skip


def _walk(name: str, floor: str) -> dict:
    falls = name == "off" and floor == "both"
    times_s = [0.0, 0.5] if falls else [0.0, 0.5, 1.0]
    roll_deg, pitch_deg = ([share * time_s for time_s in times_s] for share in (1.0, 0.5))
    return {
        "controllers": name, "floor": floor, "slope_deg": 2.0 * (floor == "both"), "falls": falls,
        "time_s": times_s, "roll_deg": roll_deg, "pitch_deg": pitch_deg,
    }  # fmt: skip


def _planned(pattern: str, knee: bool = False) -> dict:
    foot = {"x_m": [0.0, 0.1, 0.2], "z_m": [0.0] * 3, "pitch_deg": [0.0, 5.0, 0.0],
            "ankle_x_m": [0.0, 0.1, 0.2], "ankle_z_m": [0.1] * 3}  # fmt: skip
    gait = {"com_height_m": 0.5, "step_length_m": 0.2, "single_support_share": 0.6, "single_support_s": 0.8,
            "double_support_s": 0.2}  # fmt: skip
    return {
        "pattern": pattern, "gait": gait, "margins": {"least_zmp_margin_m": None if knee else 0.02},
        "time_s": [0.0, 0.5, 1.0], "com_x_m": [0.0, 0.1, 0.2], "com_x_m_s": [0.2] * 3, "com_x_m_s2": [0.0] * 3,
        "ideal_zmp_m": [0.0, 0.1, 0.2], "real_zmp_m": [None] * 3 if knee else [0.0, 0.1, 0.2],
        "support_rear_m": [-0.1, 0.0, 0.1], "support_front_m": [0.1, 0.2, 0.3],
        "stance": foot, "swing": foot, "hip_height_m": 0.6,
    }  # fmt: skip


PLAN = {
    "picture": "walking_plan", "robot": "khr2", "pattern": "rolled_in_turn", "toe_angle_deg": 8.0,
    "heel_angle_deg": 8.0, "is_feasible": True, "broken": "none", "turns": [{}], "link_m": 0.3, "toe_m": 0.1,
    "heel_m": 0.1, "before": _planned("rolled_in_turn", knee=True), "after": _planned("rolled_in_turn"),
    "patterns": [_planned(name) for name in ("flat_feet", "rolled_together", "rolled_in_turn")],
}  # fmt: skip
_SAMPLES = {"time_s": [0.0, 0.1], "planned_m": [0.0, 0.1], "measured_m": [0.0, 0.05], "rear_m": [-0.1] * 2,
            "front_m": [0.1] * 2}  # fmt: skip
_WALKED = {"robot": "khr2", "pattern": "flat_feet", "verdict": "walked", "rms_difference_m": 0.02, "samples": _SAMPLES}
_NOT_WALKED = {**_WALKED, "verdict": "fell", "rms_difference_m": None, "samples": {name: [] for name in _SAMPLES}}
AXES = {
    "columns": {"title": "load at, s", "labels": ["0.3", "0.9"]},
    "rows": {"title": "load, kg", "labels": ["5.0", "10.0", "15.0"]},
    "repeats": {"title": "", "labels": [""]},
}
RESULTS = {
    "table": TABLE,
    "table alone": {**TABLE, "reference": None, "cells": _cells("++f+f+", "------")},
    "random loads": {"picture": "random_loads", **PLANT, "seed": 1, "survive": 4, "of": 6, "cells": TABLE["cells"]},
    "band": {
        "picture": "band", **PLANT, "frictions": [0.1, 0.2], "toes_m": [0.12, 0.13], "of": 6,
        "counts": [{"survive": count} for count in (1, 2, 3, 6)],
    },
    "delays": {
        "picture": "trigger_delays", **PLANT, **GRID, "longest_delay_s": 1.0,
        "delays": [{"delay_s": delay_s} for delay_s in (0.05, 0.03, None, 0.02, 0.06, 0.04)],
        "thesis": [{"load_time_s": 0.2, "mass_kg": 5.0, "delay_s": 0.0625}],
    },
    "delays, none seen": {
        "picture": "trigger_delays", **PLANT, **GRID, "longest_delay_s": 1.0, "thesis": [],
        "delays": [{"delay_s": None}] * 6,
    },
    "alarms": {"picture": "false_alarms", **PLANT, "cycles": 20, "false_alarms": 0, "run_margins_n": [2.5, 2.6, 3.0]},
    "map": {
        "picture": "map", "title": "a map", "plant": "thesis", **AXES, "of_each_cell": 2, "of_each_method": 12,
        "method_title": "reflex",
        "methods": [
            {"method": "off", "survive": 3, "cells": [[2, 1], [0, 0], [0, 0]]},
            {"method": "capture", "survive": 12, "cells": [[2, 2], [2, 2], [2, 2]]},
        ],
    },
    "floor traces": {
        "picture": "floor_traces", "seed": 1, "duration_s": 1.0,
        "walks": [_walk(name, floor) for name in ("off", "extended") for floor in ("flat", "both")],
    },
    "plan": PLAN,
    "planned ZMP": {"picture": "planned_zmp", "walks": [_WALKED, _NOT_WALKED]},
    "plan, checked only": {**PLAN, "turns": [], "is_feasible": False, "broken": "zmp"},
}  # fmt: skip


def test_every_kind_of_picture_is_tried():
    assert {result["picture"] for result in RESULTS.values()} == set(FIGURES)


@pytest.mark.parametrize("name", RESULTS)
def test_a_result_becomes_a_picture(name: str, tmp_path: Path, monkeypatch):
    monkeypatch.setattr("sys.stdin", io.StringIO(json.dumps(RESULTS[name])))
    assert main([str(tmp_path / "picture.png")]) == 0
    assert (tmp_path / "picture.png").read_bytes().startswith(b"\x89PNG\r\n\x1a\n")
    plt.close("all")


def test_cells_that_differ_from_the_reference_carry_a_cross_and_no_others():
    look.apply()
    figure = survival_table.figure(TABLE)
    (crosses,) = figure.axes[0].collections
    assert sorted(map(tuple, crosses.get_offsets().tolist())) == [(1.0, 0.0)]  # 5 kg at 0.2 s
    drawn = np.asarray(figure.axes[0].images[0].get_array())
    plt.close(figure)
    assert drawn.tolist() == [[3, 1, 2], [3, 3, 3]]  # loads upwards, instants to the right


def test_the_methods_of_a_map_share_one_scale_and_carry_their_counts():
    look.apply()
    figure = survival_map.figure(RESULTS["map"])
    panels = figure.axes[:2]
    assert {axis.images[0].get_clim() for axis in panels} == {(0.0, 1.0)}
    assert ["3 of 12" in panels[0].get_title(), "12 of 12" in panels[1].get_title()] == [True, True]
    assert np.asarray(panels[0].images[0].get_array()).tolist() == [[1.0, 0.5], [0.0, 0.0], [0.0, 0.0]]
    plt.close(figure)


def test_floors_run_downwards_sets_to_the_right_and_a_fall_is_marked():
    look.apply()
    figure = floor_traces.figure(RESULTS["floor traces"])
    titles = [axis.get_title(loc="left") for axis in figure.axes]
    assert ["controllers off" in title for title in titles] == [True, False, True, False]
    assert ["1 flat" in title for title in titles] == [True, True, False, False]
    assert [[text.get_text().strip() for text in axis.texts] for axis in figure.axes] == [[], [], ["falls"], []]
    roll, pitch, *_ = figure.axes[1].lines
    assert (roll.get_ydata()[-1], pitch.get_ydata()[-1]) == (1.0, 0.5)
    plt.close(figure)


def test_a_plan_shows_what_was_before_only_where_something_was_changed():
    look.apply()
    titles = {
        name: [axis.get_title(loc="left") for axis in walking_plan.figure(RESULTS[name]).axes]
        for name in ("plan", "plan, checked only")
    }
    plt.close("all")
    assert "ZMP before compensation: a knee is stretched" in titles["plan"]
    assert not any("before" in title for title in titles["plan, checked only"])
    assert sum(title.startswith("Pattern ") for title in titles["plan"]) == 3


def test_each_walk_has_a_panel_and_one_that_fell_at_once_says_so():
    titles = [axis.get_title(loc="left") for axis in planned_zmp.figure(RESULTS["planned ZMP"]).axes]
    assert titles == ["khr2, flat_feet: walked, RMS 20 mm apart", "khr2, flat_feet: fell, no steps to show"]


def test_a_picture_that_cannot_be_written_is_said(tmp_path: Path, monkeypatch, capsys):
    monkeypatch.setattr("sys.stdin", io.StringIO(json.dumps(RESULTS["band"])))
    assert main([str(tmp_path / "nowhere" / "picture.png")]) == 69
    assert "plot:" in capsys.readouterr().err
    plt.close("all")
