"""The frame of every picture: rows over one time axis, phases shaded, events marked and named."""

from collections.abc import Sequence

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from tools.plots import look
from tools.plots.event_labels import LABEL_SIZE_PT, label_width_in, stack_labels, words
from tools.plots.read_run import Event, Run

_LEFT_IN, _RIGHT_IN, _BOTTOM_IN, _TITLE_IN, _LEVEL_IN, _GAP_IN = 0.95, 1.75, 0.95, 0.45, 0.19, 0.16
_LEAD_IN_S = 1.0  # of the start-up, before the scenario's time zero

Window = tuple[float, float]


def default_window(run: Run) -> Window:
    """From just before time zero to the end; all of it when the run ended during start-up."""
    first, last = float(run.state["time_s"][0]), float(run.state["time_s"][-1])
    return (max(first, -_LEAD_IN_S), last) if last > 0.0 else (first, max(last, first + 1e-3))


def within(columns: dict[str, np.ndarray], window: Window) -> dict[str, np.ndarray]:
    """The rows whose time lies in the window."""
    keep = (columns["time_s"] >= window[0]) & (columns["time_s"] <= window[1])
    return {field: values[keep] for field, values in columns.items()}


def phase_spans(time_s: np.ndarray, phase: np.ndarray) -> list[tuple[float, float, int]]:
    """Stretches of constant phase as (from, to, phase); each ends where the next begins."""
    if len(phase) == 0:
        return []
    starts = np.concatenate(([0], np.flatnonzero(np.diff(phase)) + 1))
    ends = np.append(time_s[starts[1:]], time_s[-1])
    return [(float(time_s[s]), float(end), int(phase[s])) for s, end in zip(starts, ends)]


def _title(run: Run) -> str:
    title = run.folder.resolve().name
    if "verdict" in run.verdict:
        title += f": {run.verdict['verdict']}"
        if run.verdict.get("reason"):
            title += f" ({run.verdict['reason']})"
    return title if len(title) <= 105 else title[:104] + "…"


def _mark_events(axes: Sequence[Axes], events: list[Event], levels: list[int]) -> None:
    top = axes[0]
    for event, level in zip(events, levels):
        line = {"color": look.BLACK, "linewidth": 0.9, "alpha": 0.75}
        for axis in axes:
            axis.axvline(event.time_s, linestyle=(0, (2, 2)), **line)
        height_pt = (level * _LEVEL_IN + 0.06) * 72.0
        top.annotate(
            words(event),
            xy=(event.time_s, 1.0),
            xycoords=top.get_xaxis_transform(),
            xytext=(0, height_pt),
            textcoords="offset points",
            fontsize=LABEL_SIZE_PT,
            annotation_clip=False,
            arrowprops={"arrowstyle": "-", "shrinkA": 0, "shrinkB": 0, "relpos": (0, 0), **line},
        )


def _shade_phases(figure: Figure, axes: Sequence[Axes], spans: list[tuple[float, float, int]]) -> None:
    shown = {}
    for start_s, end_s, phase in spans:
        name, colour = look.PHASES.get(phase, (f"phase {phase}", "#FFFFFF"))
        if colour is None:
            continue
        shown[name] = Patch(facecolor=colour, edgecolor=look.GREY, linewidth=0.5, label=name)
        for axis in axes:
            axis.axvspan(start_s, end_s, facecolor=colour, linewidth=0, zorder=0)
    if shown:
        figure.legend(handles=list(shown.values()), loc="lower center", ncols=len(shown), bbox_to_anchor=(0.45, 0.0))


def time_figure(run: Run, window: Window, row_heights_in: Sequence[float], subject: str) -> tuple[Figure, list[Axes]]:
    """An empty picture with one row for each height; the caller draws the lines.

    Legends stand to the right of their rows: see `legend_beside`.
    """
    events = sorted((e for e in run.events if window[0] <= e.time_s <= window[1]), key=lambda e: e.time_s)
    plot_width_in = look.FIGURE_WIDTH_IN - _LEFT_IN - _RIGHT_IN
    inches_per_s = plot_width_in / (window[1] - window[0])
    levels = stack_labels([e.time_s * inches_per_s for e in events], [label_width_in(words(e)) for e in events])

    rows_in = sum(row_heights_in) + _GAP_IN * (len(row_heights_in) - 1)
    labels_in = _LEVEL_IN * (max(levels, default=-1) + 1) + 0.1
    height_in = _BOTTOM_IN + rows_in + labels_in + _TITLE_IN
    figure = plt.figure(figsize=(look.FIGURE_WIDTH_IN, height_in))
    grid = figure.add_gridspec(
        len(row_heights_in),
        1,
        height_ratios=row_heights_in,
        left=_LEFT_IN / look.FIGURE_WIDTH_IN,
        right=1.0 - _RIGHT_IN / look.FIGURE_WIDTH_IN,
        bottom=_BOTTOM_IN / height_in,
        top=(_BOTTOM_IN + rows_in) / height_in,
        hspace=_GAP_IN * len(row_heights_in) / sum(row_heights_in),
    )
    axes = [figure.add_subplot(grid[0])]
    axes += [figure.add_subplot(grid[i], sharex=axes[0]) for i in range(1, len(row_heights_in))]
    for axis in axes[:-1]:
        axis.tick_params(labelbottom=False)
    axes[0].set_xlim(*window)
    axes[0].xaxis.set_major_locator(MaxNLocator(nbins=12, steps=[1, 2, 5, 10]))
    axes[-1].set_xlabel("time (s)")
    figure.text(_LEFT_IN / look.FIGURE_WIDTH_IN, 1.0 - 0.2 / height_in, subject, weight="bold", va="center")
    figure.text(
        1.0 - 0.15 / look.FIGURE_WIDTH_IN, 1.0 - 0.2 / height_in, _title(run), size=9, ha="right", va="center"
    )

    state = within(run.state, window)
    _shade_phases(figure, axes, phase_spans(state["time_s"], state["phase"]))
    _mark_events(axes, events, levels)
    return figure, axes


def legend_beside(axis: Axes) -> None:
    """The row's legend to its right, where it covers no line."""
    axis.legend(loc="upper left", bbox_to_anchor=(1.005, 1.02), handlelength=2.2)
