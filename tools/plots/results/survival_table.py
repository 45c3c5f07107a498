"""A table of experiments beside its reference: El-Kahlout 2003, tables 4.1 to 4.3."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from tools.plots import look
from tools.plots.results.matrix import draw_matrix

_COLOURS = ("#F4F4F4", look.VERMILLION, "#F0E442", "#BFE8D6")  # by state
_NOT_PRINTED, _FALLS, _STANDS_STILL, _SURVIVES = range(4)


def _draw(axis: Axes, result: dict, states: np.ndarray, title: str) -> None:
    colours = ListedColormap(_COLOURS)
    draw_matrix(axis, states, result["masses_kg"], result["load_times_s"], colours, Normalize(_NOT_PRINTED, _SURVIVES))
    axis.set_ylabel("load (kg)")
    axis.set_title(title, loc="left", size=10)


def _state_here(cell: dict) -> int:
    if cell["survives"]:
        return _SURVIVES
    return _FALLS if cell["outcome"] == "fell" else _STANDS_STILL


def _state_there(cell: dict) -> int:
    return {None: _NOT_PRINTED, False: _FALLS, True: _SURVIVES}[cell["reference"]]


def figure(result: dict) -> Figure:
    """Instants run to the right, loads upwards; cells that differ from the reference carry a cross."""
    times, masses = result["load_times_s"], result["masses_kg"]
    here, there = (
        np.array([state(cell) for cell in result["cells"]]).reshape(len(times), len(masses)).T
        for state in (_state_here, _state_there)
    )
    reference = result["reference"]
    panels = 1 if reference is None else 2
    drawn, axes = plt.subplots(
        panels, 1, figsize=(look.FIGURE_WIDTH_IN, panels * (1.0 + 0.27 * len(masses)) + 0.4), squeeze=False, sharex=True
    )
    drawn.subplots_adjust(hspace=0.35)
    top = axes[0, 0]
    title = f"reflex {result['method']}, plant {result['plant']}: {result['survive']} of {result['of']} survive"
    _draw(top, result, here, title)
    names = {_SURVIVES: "survives", _FALLS: "falls", _STANDS_STILL: "no fall, but\ndoes not walk on"}
    legend = [Patch(facecolor=_COLOURS[state], label=name) for state, name in names.items() if state in here]
    if reference is not None:
        title = f"{reference['name']}: {reference['survive']} of {reference['printed']} survive"
        title += f"; {reference['differ']} cells differ"
        _draw(axes[1, 0], result, there, title)
        row, column = np.nonzero((there != _NOT_PRINTED) & ((there == _SURVIVES) != (here == _SURVIVES)))
        cross = {"marker": "x", "color": look.BLACK, "s": 26, "linewidths": 1.4}
        marks = top.scatter(column, row, **cross, label="differs from the\nreference")
        legend += [marks, Patch(facecolor=_COLOURS[_NOT_PRINTED], edgecolor=look.GREY, label="not printed")]
    axes[-1, 0].set_xlabel("instant of the load (s)")
    drawn.legend(handles=legend, loc="upper left", bbox_to_anchor=(0.905, 0.88))
    return drawn
