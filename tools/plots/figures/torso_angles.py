"""How the torso leans: El-Kahlout 2003, figures 4.2 and 4.4."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.read_run import Columns, Run
from tools.plots.time_figure import Window, legend_beside, time_figure, within


def draw_pitch(axis: Axes, truth: Columns) -> None:
    axis.plot(truth["time_s"], np.degrees(truth["pitch_rad"]), color=look.BLUE, label="pitch β\n(forward +)")
    axis.set_ylabel("torso pitch β (deg)")
    legend_beside(axis)


def draw_roll(axis: Axes, truth: Columns) -> None:
    axis.plot(truth["time_s"], np.degrees(truth["roll_rad"]), color=look.VERMILLION, label="roll\n(to the right +)")
    axis.set_ylabel("torso roll (deg)")
    legend_beside(axis)


def figure(run: Run, window: Window) -> Figure:
    drawn, (pitch, roll) = time_figure(run, window, [3.0, 2.0], "Torso angles")
    truth = within(run.truth, window)
    draw_pitch(pitch, truth)
    draw_roll(roll, truth)
    return drawn
