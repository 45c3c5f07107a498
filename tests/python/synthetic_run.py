"""A run folder made up from the formulas of the walk: pictures can be tested without a simulator."""

import json
import math
from pathlib import Path

import lcm

from tools.plots.messages import message_types

PERIOD_S = 2e-3
START_S = -1.5
END_S = 9.0

# (time, code, name, value): the time line of El-Kahlout 2003 for 5 kg at 1.2 s, trigger at 1.2625 s.
EVENTS = [
    (1.2, 16, "payload_attached", 5.0),
    (1.2625, 1, "payload_detected", 1.2625),
    (1.3625, 2, "reflex_done", 0.1),
    (3.3625, 3, "settled", 2.0),
    (3.8625, 4, "shifted", 0.5),
    (4.7749, 5, "restored", 0.9124),
    (5.7749, 6, "rested", 1.0),
]
_PHASE_FROM = [(START_S, 1), (1.2625, 2), (1.3625, 3), (3.3625, 4), (3.8625, 5), (4.7749, 6), (5.7749, 1)]


def phase_at(time_s: float) -> int:
    return [phase for start_s, phase in _PHASE_FROM if start_s <= time_s][-1]


def _foot_x_m(time_s: float) -> float:
    t = time_s % 4.8
    if t < 0.5 or t >= 4.3:
        return 0.08
    if t < 1.9:
        return 0.08 * math.cos(math.pi * (t - 0.5) / 1.4)
    return -0.08 if t < 2.9 else -0.08 * math.cos(math.pi * (t - 2.9) / 1.4)


def _lift_m(time_s: float, start_s: float) -> float:
    t = time_s % 4.8 - start_s
    return 0.015 * (1 - math.cos(2 * math.pi * t / 1.4)) if 0 <= t < 1.4 else 0.0


def _state(time_s: float, walk_s: float):
    message = message_types().controller_state_t()
    message.utime, message.tick = round(time_s * 1e6), round((time_s - START_S) / PERIOD_S)
    message.phase = phase_at(time_s)
    message.reference_x_body_m = -0.09
    x, sway = _foot_x_m(walk_s), 0.13 * math.sin(math.pi * walk_s / 2.4)
    message.foot_reference_m = [
        [-0.09 + x, -0.11 + sway, -0.5 + _lift_m(walk_s, 2.9)],
        [-0.09 - x, 0.11 + sway, -0.5 + _lift_m(walk_s, 0.5)],
    ]
    loaded = time_s >= 1.2
    message.vertical_force_n = 785.0 + 12 * math.sin(9 * time_s) + (49.0 if loaded else 0.0)
    message.filtered_force_n = 785.0 + 8 * math.sin(4 * time_s)
    if loaded:
        message.filtered_force_n += 49.0 * (1 - math.exp(-(time_s - 1.2) / 0.09975))
    message.threshold_n = 800.0 if time_s > -1.0 else 0.0
    message.foot_force_n = [message.vertical_force_n * s for s in (0.5 - 0.4 * sway / 0.13, 0.5 + 0.4 * sway / 0.13)]
    message.zmp_x_body_m = -0.035 + 0.04 * math.sin(5 * time_s)
    message.filtered_zmp_x_body_m = -0.035 + (0.02 * (1 - math.exp(-(time_s - 1.2))) if loaded else 0.0)
    return message


def _truth(time_s: float):
    message = message_types().simulator_truth_t()
    message.utime, message.tick = round(time_s * 1e6), round((time_s - START_S) / PERIOD_S)
    message.pitch_rad = 0.01 * math.sin(2.6 * time_s) + (0.012 if 1.2 < time_s < 3.5 else 0.0)
    message.roll_rad = 0.008 * math.sin(1.3 * time_s)
    message.torque_nm = [[(20 + 22 * j) * math.sin(2 * time_s + side * math.pi) for j in range(6)] for side in (0, 1)]
    return message


def _event(time_s: float, code: int, name: str, value: float):
    message = message_types().event_t()
    message.utime, message.tick = round(time_s * 1e6), round((time_s - START_S) / PERIOD_S)
    message.code, message.value = code, value
    message.name = name.encode().ljust(24, b"\0")
    return message


def write_synthetic_run(folder: Path, end_s: float = END_S) -> Path:
    """Writes scenario.toml, verdict.json and telemetry.lcmlog; returns the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scenario.toml").write_text('plant = "thesis"\n[drive]\ntorque_limit_nm = 200.0\n')
    (folder / "verdict.json").write_text(json.dumps({"verdict": "walked", "reason": "2.1 cycles after recovery"}))
    records = [(time_s, "SUREFOOT_EVENT", _event(time_s, *rest)) for time_s, *rest in EVENTS if time_s <= end_s]
    walk_s = START_S
    for step in range(round((end_s - START_S) / PERIOD_S) + 1):
        time_s = START_S + step * PERIOD_S
        walk_s += PERIOD_S if phase_at(time_s) == 1 else 0.0
        records.append((time_s, "SUREFOOT_STATE", _state(time_s, walk_s)))
        records.append((time_s, "SUREFOOT_TRUTH", _truth(time_s)))
    log = lcm.EventLog(str(folder / "telemetry.lcmlog"), "w", overwrite=True)
    for time_s, channel, message in sorted(records, key=lambda record: record[0]):
        log.write_event(round((time_s - START_S) * 1e6), channel, message.encode())
    log.close()
    return folder
