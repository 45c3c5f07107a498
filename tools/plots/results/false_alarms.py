"""How near noisy unloaded walks came to the payload threshold."""

import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from tools.plots import look


def figure(result: dict) -> Figure:
    drawn, axis = plt.subplots(figsize=(0.75 * look.FIGURE_WIDTH_IN, 3.6))
    axis.hist(result["run_margins_n"], bins=20, color=look.BLUE)
    axis.axvline(0.0, color=look.VERMILLION, linestyle="--", label="threshold")
    axis.set_xlabel("smallest margin of a run below the threshold (N)")
    axis.set_ylabel("runs")
    found = f"{result['false_alarms']} false alarms in {result['cycles']} unloaded cycles"
    axis.set_title(f"{found}, reflex {result['method']}, plant {result['plant']}", loc="left", size=10)
    axis.legend()
    return drawn
