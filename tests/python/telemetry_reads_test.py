"""The telemetry log is readable with PyPI's lcm and classes of lcm-gen -p, and tells the run's story."""

import json
from pathlib import Path

import lcm
import numpy as np
import pytest

from tools.plots.read_run import Run, read_run

# What must happen after the load, in this order (El-Kahlout 2003, section 3.3).
_STORY = ["payload_attached", "payload_detected", "reflex_done", "settled", "shifted", "restored", "rested"]
_TICK_S = 1e-3


@pytest.fixture(scope="module")
def run(run_folder: Path) -> Run:
    return read_run(run_folder)


def _event_times_s(run: Run) -> dict[str, float]:
    """Times of the events from the load on; each happens once."""
    placed_s = next(event.time_s for event in run.events if event.name == "payload_attached")
    return {event.name: event.time_s for event in run.events if event.time_s >= placed_s}


def test_the_log_holds_the_promised_channels_and_no_others(run_folder: Path):
    channels = {record.channel for record in lcm.EventLog(str(run_folder / "telemetry.lcmlog"), "r")}
    assert channels == {"SUREFOOT_STATE", "SUREFOOT_TRUTH", "SUREFOOT_EVENT", "SUREFOOT_BUS"}


def test_every_tick_has_one_state_and_one_truth(run: Run):
    assert (np.diff(run.state["tick"]) == 1).all()
    assert (np.diff(run.truth["tick"]) == 1).all()
    assert np.allclose(np.diff(run.state["time_s"]), _TICK_S, atol=1e-9)


def test_every_recorded_number_is_finite(run: Run):
    for columns in (run.state, run.truth, run.bus):
        for field, values in columns.items():
            assert np.isfinite(values).all(), field


def test_the_events_tell_the_story_in_order(run: Run):
    times_s = _event_times_s(run)
    assert [event.name for event in run.events if event.name in _STORY and event.time_s >= 1.0] == _STORY
    assert times_s["payload_attached"] == pytest.approx(1.2, abs=_TICK_S)
    assert 0.0 < times_s["payload_detected"] - times_s["payload_attached"] < 0.15


# Reflex 0.1 s, settling 2 s, shift 0.5 s, rest of half the settling time.
@pytest.mark.parametrize(
    ("earlier", "later", "duration_s"),
    [
        ("payload_detected", "reflex_done", 0.1),
        ("reflex_done", "settled", 2.0),
        ("settled", "shifted", 0.5),
        ("restored", "rested", 1.0),
    ],
)
def test_each_phase_lasts_as_long_as_configured(run: Run, earlier: str, later: str, duration_s: float):
    times_s = _event_times_s(run)
    assert times_s[later] - times_s[earlier] == pytest.approx(duration_s, abs=1.01 * _TICK_S)


def test_the_verdict_lists_the_same_events(run: Run):
    listed = [(event["name"], event["time_s"]) for event in run.verdict["events"]]
    recorded = [(event.name, event.time_s) for event in run.events]
    assert [name for name, _ in listed] == [name for name, _ in recorded]
    assert [time_s for _, time_s in listed] == pytest.approx([time_s for _, time_s in recorded], abs=1e-6)


def test_the_verdict_agrees_with_the_recorded_torso_angles(run: Run):
    scored = run.truth["time_s"] >= 0.0
    for field, key in (("pitch_rad", "torso_pitch_deg"), ("roll_rad", "torso_roll_deg")):
        angles_deg = np.degrees(run.truth[field][scored])
        assert run.verdict[key]["min"] == pytest.approx(angles_deg.min(), abs=1e-3)
        assert run.verdict[key]["max"] == pytest.approx(angles_deg.max(), abs=1e-3)


def test_the_run_folder_holds_the_effective_scenario(run: Run):
    assert run.scenario["payload"][0]["mass_kg"] == 5.0
    assert run.torque_limit_nm == pytest.approx(200.0)


def test_the_verdict_keeps_its_names(run_folder: Path):
    verdict = json.loads((run_folder / "verdict.json").read_text())
    promised = {
        "verdict", "reason", "torso_pitch_deg", "torso_roll_deg", "cycles_after_recovery", "events", "bus_log_sha256",
        "allocations_in_loop", "tick_us", "real_time_factor", "peak_torque_nm", "foot_slip_mm", "frames_sent",
        "frames_lost", "bus_load_percent",
    }  # fmt: skip
    assert promised <= verdict.keys()
    assert {"p50", "p999", "max"} <= verdict["tick_us"].keys()
