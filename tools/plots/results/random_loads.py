"""Loads and instants drawn at random, off every grid."""

import matplotlib.pyplot as plt
from matplotlib.figure import Figure

from tools.plots import look


def figure(result: dict) -> Figure:
    drawn, axis = plt.subplots(figsize=(look.FIGURE_WIDTH_IN, 5.0))
    for survives, marker, colour in ((True, "o", look.GREEN), (False, "x", look.VERMILLION)):
        cells = [cell for cell in result["cells"] if cell["survives"] is survives]
        label = f"{'survives' if survives else 'falls'} ({len(cells)})"
        times, masses = [cell["load_time_s"] for cell in cells], [cell["mass_kg"] for cell in cells]
        axis.scatter(times, masses, marker=marker, color=colour, s=28, label=label)
    axis.set_xlabel("instant of the load (s)")
    axis.set_ylabel("load (kg)")
    title = f"reflex {result['method']}, plant {result['plant']}, seed {result['seed']}"
    axis.set_title(f"{title}: {result['survive']} of {result['of']} survive", loc="left", size=10)
    axis.legend(loc="upper left", bbox_to_anchor=(1.005, 1.0))
    return drawn
