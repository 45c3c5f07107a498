"""The run in one picture: the torso, what the detector saw, where the feet went."""

from matplotlib.figure import Figure

from tools.plots.figures.foot_references import draw_coordinate
from tools.plots.figures.payload_force import draw_force
from tools.plots.figures.torso_angles import draw_pitch, draw_roll
from tools.plots.read_run import Run
from tools.plots.time_figure import Window, time_figure, within


def figure(run: Run, window: Window) -> Figure:
    drawn, (pitch, roll, force, feet, swing) = time_figure(run, window, [1.8, 1.1, 1.8, 1.6, 1.1], "The run at a glance")
    state = within(run.state, window)
    truth = within(run.truth, window)
    draw_pitch(pitch, truth)
    draw_roll(roll, truth)
    draw_force(force, state, run.events)
    draw_coordinate(feet, state, 0)
    draw_coordinate(swing, state, 2)
    feet.set_ylabel("foot X (m)")
    swing.set_ylabel("foot Z (m)")
    return drawn
