"""Torso angles over time on the four floors: Kim, Park, Oh 2007, Figs 23 and 24."""

import matplotlib.pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look

_LINES = (("roll", "roll_deg", look.BLUE, "-"), ("pitch", "pitch_deg", look.VERMILLION, (0, (5, 1.5))))
_TITLES = {"flat": "1 flat", "local": "2 tiles", "global": "3 slope", "both": "4 tiles on a slope"}
_RANGE_DEG = 6.0


def _draw(axis: Axes, walk: dict) -> None:
    for label, member, colour, dash in _LINES:
        axis.plot(walk["time_s"], walk[member], color=colour, linestyle=dash, linewidth=1.0, label=label)
    if walk["falls"] and walk["time_s"]:
        axis.axvline(walk["time_s"][-1], color=look.BLACK, linewidth=0.8)
        axis.text(walk["time_s"][-1], -0.92 * _RANGE_DEG, " falls", color=look.BLACK)
    slope = f" of {walk['slope_deg']:g}°" if walk["slope_deg"] else ""
    axis.set_title(f"{_TITLES[walk['floor']]}{slope}, controllers {walk['controllers']}", loc="left", size=10)


def figure(result: dict) -> Figure:
    """Floors run downwards, sets of controllers to the right; all on one scale."""
    walks = result["walks"]
    sets, floors = (list(dict.fromkeys(walk[member] for walk in walks)) for member in ("controllers", "floor"))
    drawn, axes = plt.subplots(
        len(floors), len(sets), figsize=(look.FIGURE_WIDTH_IN, 2.0 * len(floors) + 0.6), sharex=True, sharey=True,
        squeeze=False, layout="constrained",
    )  # fmt: skip
    for walk in walks:
        _draw(axes[floors.index(walk["floor"]), sets.index(walk["controllers"])], walk)
    axes[0, 0].set_ylim(-_RANGE_DEG, _RANGE_DEG)
    axes[0, 0].set_xlim(0.0, result["duration_s"])
    axes[0, -1].legend(loc="upper right", ncols=2)
    for axis in axes[-1]:
        axis.set_xlabel("time (s)")
    for axis in axes[:, 0]:
        axis.set_ylabel("torso (deg)")
    drawn.suptitle(f"KHR-2 on the spot, seed {result['seed']}: torso against the vertical", size=11)
    return drawn
