"""The zero-moment point as measured and as filtered: El-Kahlout 2003, figure 4.12."""

import numpy as np
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Run
from tools.plots.time_figure import Window, legend_beside, time_figure, within


def _set_limits(axis, values: np.ndarray) -> None:
    """Spikes of single ticks may leave the picture."""
    low, high = np.percentile(values, [0.1, 99.9])
    margin = 0.1 * (high - low) + 1e-3
    axis.set_ylim(low - margin, high + margin)


def figure(run: Run, window: Window) -> Figure:
    drawn, (along, across) = time_figure(run, window, [3.2, 2.0], "Zero-moment point, body frame")
    state = within(run.state, window)
    along.plot(state["time_s"], state["zmp_x_body_m"], color=look.GREY, linewidth=0.8, label="measured")
    along.plot(state["time_s"], state["filtered_zmp_x_body_m"], color=look.BLUE, linewidth=1.6, label="filtered")
    along.set_ylabel("ZMP x (m)")
    _set_limits(along, state["zmp_x_body_m"])
    legend_beside(along)
    across.plot(state["time_s"], state["zmp_y_body_m"], color=look.GREY, linewidth=0.8, label="measured")
    across.set_ylabel("ZMP y (m)")
    _set_limits(across, state["zmp_y_body_m"])
    legend_beside(across)
    return drawn
