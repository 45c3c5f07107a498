"""Walks of planned gaits: planned against true pressure centre in the true support, over four steps."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure

from tools.plots import look


def _millimetres(value: float | None) -> str:
    return "-" if value is None else f"{1e3 * value:.0f}"


def figure(result: dict) -> Figure:
    walks = result["walks"]
    drawn, axes = plt.subplots(
        len(walks), 1, figsize=(8.0, 0.6 + 2.1 * len(walks)), squeeze=False, layout="constrained"
    )
    for axis, walk in zip(axes[:, 0], walks):
        column = {name: np.array(values) for name, values in walk["samples"].items()}
        time_s = column["time_s"]
        axis.fill_between(
            time_s, column["rear_m"], column["front_m"], color=look.GREEN, alpha=0.15, linewidth=0,
            label="corners that carry",
        )  # fmt: skip
        axis.plot(time_s, column["planned_m"], color=look.GREY, linestyle=(0, (5, 1.5)), label="ZMP, planned")
        axis.plot(time_s, column["measured_m"], color=look.VERMILLION, label="ZMP, measured")
        said = f"RMS {_millimetres(walk['rms_difference_m'])} mm apart" if len(time_s) else "no steps to show"
        axis.set_title(f"{walk['robot']}, {walk['pattern']}: {walk['verdict']}, {said}", loc="left", size=10)
        axis.set_ylabel("x from the foothold (m)")
    axes[0, 0].legend(loc="lower right", ncols=3)
    axes[-1, 0].set_xlabel("time (s)")
    return drawn
