"""What each online controller of a floor walk adds: Kim, Park, Oh 2007, figure 25."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Columns, Run, RunFolderError
from tools.plots.time_figure import Window, legend_beside, time_figure, within

# Order of stabilizer_t.lcm; behind the last comes the total.
CONTROLLERS = (
    "upright_pose", "landing_momentum", "shock_absorber", "landing_timing", "landing_position", "vibration_reduction",
    "damping", "zmp_compensator", "soft_landing", "sway_amplitude", "torso_tilt", "tilt_over", "tilt_landing_position",
    "attitude_feedback", "foot_tilt", "step_adjustment", "ground_seeking",
)  # fmt: skip
_TOTAL = len(CONTROLLERS)
_RIGHT, _LEFT = 0, 1

# Field, place in it, factor to the unit of the label.
_QUANTITIES = (
    ("ankle_roll_rad", _RIGHT, 180.0 / np.pi, "ankle roll\nright (deg)"),
    ("ankle_roll_rad", _LEFT, 180.0 / np.pi, "ankle roll\nleft (deg)"),
    ("ankle_pitch_rad", _RIGHT, 180.0 / np.pi, "ankle pitch\nright (deg)"),
    ("ankle_pitch_rad", _LEFT, 180.0 / np.pi, "ankle pitch\nleft (deg)"),
    ("hip_roll_rad", _RIGHT, 180.0 / np.pi, "hip roll\nright (deg)"),
    ("hip_roll_rad", _LEFT, 180.0 / np.pi, "hip roll\nleft (deg)"),
    ("leg_length_m", _RIGHT, 1e3, "leg length\nright (mm)"),
    ("leg_length_m", _LEFT, 1e3, "leg length\nleft (mm)"),
    ("pelvis_m", 0, 1e3, "pelvis x\n(mm)"),
    ("pelvis_m", 1, 1e3, "pelvis y\n(mm)"),
    ("pelvis_m", 2, 1e3, "pelvis z\n(mm)"),
    ("landing_m", 0, 1e3, "landing x\n(mm)"),
    ("landing_m", 1, 1e3, "landing y\n(mm)"),
    ("sway_m", None, 1e3, "sway\n(mm)"),
    ("sway_centre_m", 0, 1e3, "centre x\n(mm)"),
    ("sway_centre_m", 1, 1e3, "centre y\n(mm)"),
    ("earlier_landing_s", None, 1e3, "earlier\n(ms)"),
)
_COLOURS = (look.BLUE, look.VERMILLION, look.GREEN, look.PURPLE, "#E69F00", "#56B4E9", "#8C6D31", look.GREY)


def _line(controller: int) -> dict:
    dash = "-" if controller < len(_COLOURS) else (0, (4, 1.5))
    return {"color": _COLOURS[controller % len(_COLOURS)], "linestyle": dash}


def _rows(columns: Columns) -> list[tuple[np.ndarray, str]]:
    """What anybody adds to, as an array of ticks by controllers and total, and its label."""
    rows = []
    for field, place, factor, label in _QUANTITIES:
        values = columns[field] if place is None else columns[field][:, :, place]
        if values.any():
            rows.append((factor * values, label))
    return rows


def _draw_activity(axis: Axes, columns: Columns) -> None:
    """A bar for each controller that is on, wherever the schedule lets it act."""
    is_on = np.flatnonzero(columns["is_on"][0])
    for place, controller in enumerate(is_on):
        height = np.where(columns["is_active"][:, controller] != 0, place, np.nan)
        axis.plot(columns["time_s"], height, linewidth=5.0, solid_capstyle="butt", color=_line(controller)["color"])
    axis.yaxis.tick_right()
    axis.set_yticks(range(len(is_on)), [CONTROLLERS[controller].replace("_", " ") for controller in is_on], size=8.5)
    axis.set_ylim(len(is_on) - 0.5, -0.5)
    axis.set_title("may act", loc="left", size=8.5, pad=2.0)


def figure(run: Run, window: Window) -> Figure:
    """Raises RunFolderError for a run of a robot that does not walk on floors."""
    if not run.stabilizer:
        raise RunFolderError(
            f"{run.folder}: tells of no online controllers, for its robot walks without them\n"
            "  remedy: draw another picture, or give a run of the robot khr2"
        )
    columns = within(run.stabilizer, window)
    rows = _rows(columns)
    heights_in = [1.2] + [0.95] * len(rows) + [0.18 * max(int(columns["is_on"][0].sum()), 3)]
    drawn, (torso, *adds, activity) = time_figure(run, window, heights_in, "What the controllers add")
    for field, name, colour in (("torso_roll_rad", "roll", look.VERMILLION), ("torso_pitch_rad", "pitch", look.BLUE)):
        torso.plot(columns["time_s"], np.degrees(columns[field]), color=colour, label=f"{name}, estimated")
    torso.set_ylabel("torso\n(deg)")
    legend_beside(torso)
    for axis, (values, label) in zip(adds, rows):
        for controller, name in enumerate(CONTROLLERS):
            if values[:, controller].any():
                axis.plot(columns["time_s"], values[:, controller], label=name.replace("_", " "), **_line(controller))
        if values[:, :_TOTAL].any(axis=0).sum() > 1:
            axis.plot(columns["time_s"], values[:, _TOTAL], color=look.BLACK, linewidth=0.7, label="total")
        axis.set_ylabel(label)
        axis.tick_params(axis="y", labelsize=8.0)
        legend_beside(axis)
    _draw_activity(activity, columns)
    return drawn
