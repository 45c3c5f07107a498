"""Time from a load to its detection, by load and instant, beside the instants that the thesis prints."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.results.matrix import draw_matrix

_SHORTEST_MS = 10.0


def figure(result: dict) -> Figure:
    times, masses = result["load_times_s"], result["masses_kg"]
    delays = [np.nan if cell["delay_s"] is None else 1e3 * cell["delay_s"] for cell in result["delays"]]
    delays_ms = np.array(delays).reshape(len(times), len(masses)).T
    drawn, (matrix, lines) = plt.subplots(
        2, 1, figsize=(look.FIGURE_WIDTH_IN, 6.5), height_ratios=[1.0, 1.6], layout="constrained"
    )
    scale = LogNorm(_SHORTEST_MS, 1e3 * result["longest_delay_s"])
    image = draw_matrix(matrix, delays_ms, masses, times, plt.get_cmap("viridis_r").with_extremes(bad="#E4E4E4"), scale)
    matrix.set_ylabel("load (kg)")
    title = f"Payload detector, reflex {result['method']}, plant {result['plant']}"
    matrix.set_title(f"{title} (grey: not seen in {result['longest_delay_s']:g} s)", loc="left", size=10)
    drawn.colorbar(image, ax=matrix, label="seen after (ms)", pad=0.01)

    shades = plt.get_cmap("plasma")(np.linspace(0.0, 0.85, len(masses)))
    for mass, delay_ms, shade in zip(masses, delays_ms, shades):
        lines.plot(times, delay_ms, ".-", color=shade, label=f"{mass:g} kg")
    for thesis in result["thesis"]:
        mass = thesis["mass_kg"]
        shade = shades[masses.index(mass)] if mass in masses else look.GREY
        at = (thesis["load_time_s"], 1e3 * thesis["delay_s"])
        lines.plot(*at, "D", color=shade, markeredgecolor=look.BLACK, markersize=7, label=f"thesis, {mass:g} kg")
    lines.set_yscale("log")
    lines.set_ylim(scale.vmin, scale.vmax)
    lines.set_xlabel("instant of the load (s)")
    lines.set_ylabel("seen after (ms)")
    handles, labels = lines.get_legend_handles_labels()
    once = dict(zip(labels, handles))
    lines.legend(once.values(), once.keys(), loc="upper left", bbox_to_anchor=(1.005, 1.0))
    return drawn
