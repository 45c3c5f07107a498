"""What the payload detector sees: the filtered vertical force and its learned threshold."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Columns, Event, Run
from tools.plots.time_figure import Window, legend_beside, time_figure, within

_PAYLOAD_DETECTED = 1  # event_t.PAYLOAD_DETECTED


def draw_force(axis: Axes, state: Columns, events: list[Event]) -> None:
    time_s = state["time_s"]
    filtered_n = state["filtered_force_n"]
    threshold_n = np.where(state["threshold_n"] > 0.0, state["threshold_n"], np.nan)  # 0 while it learns
    axis.plot(time_s, state["vertical_force_n"], color=look.GREY, linewidth=0.5, alpha=0.6, label="both feet")
    axis.plot(time_s, filtered_n, color=look.BLUE, label="filtered")
    axis.plot(time_s, threshold_n, color=look.VERMILLION, linestyle="--", label="threshold")
    triggers_s = [e.time_s for e in events if e.code == _PAYLOAD_DETECTED and time_s[0] <= e.time_s <= time_s[-1]]
    if triggers_s:
        axis.plot(triggers_s, np.interp(triggers_s, time_s, filtered_n), "o", color=look.BLACK, markersize=5, label="trigger")
    # Feet ring at touch-down and in the reflex; the picture is about the filtered force and its threshold.
    shown_n = np.concatenate((np.percentile(filtered_n, [2, 98]), threshold_n[np.isfinite(threshold_n)]))
    margin_n = 0.35 * (shown_n.max() - shown_n.min()) + 10.0
    axis.set_ylim(shown_n.min() - margin_n, shown_n.max() + margin_n)
    axis.set_ylabel("vertical force (N)")
    legend_beside(axis)


def draw_foot_forces(axis: Axes, state: Columns) -> None:
    for side, name, line in look.SIDES:
        axis.plot(state["time_s"], state["foot_force_n"][:, side], label=f"{name} foot", **line)
    axis.set_ylabel("foot force (N)")
    legend_beside(axis)


def figure(run: Run, window: Window) -> Figure:
    drawn, (force, feet) = time_figure(run, window, [3.2, 2.0], "Payload detection")
    state = within(run.state, window)
    draw_force(force, state, run.events)
    draw_foot_forces(feet, state)
    return drawn
