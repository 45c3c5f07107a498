"""Where the feet shall be: El-Kahlout 2003, figures 3.3 and 4.3."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Columns, Run
from tools.plots.time_figure import Window, legend_beside, time_figure, within

_LABELS = ("X (m)", "Y (m)", "Z (m)")


def draw_coordinate(axis: Axes, state: Columns, coordinate: int) -> None:
    """One coordinate (0 x forward, 1 y left, 2 z up) of both foot references, body frame."""
    for side, name, line in look.SIDES:
        axis.plot(state["time_s"], state["foot_reference_m"][:, side, coordinate], label=f"{name} foot", **line)
    if coordinate == 0:
        axis.plot(state["time_s"], state["reference_x_body_m"], color=look.GREY, linewidth=1.0, label="midpoint\n$x_{ref}$")
    axis.set_ylabel(_LABELS[coordinate])
    legend_beside(axis)


def figure(run: Run, window: Window) -> Figure:
    drawn, axes = time_figure(run, window, [2.0, 2.0, 2.0], "Foot references, body frame")
    state = within(run.state, window)
    for coordinate, axis in enumerate(axes):
        draw_coordinate(axis, state, coordinate)
    return drawn
