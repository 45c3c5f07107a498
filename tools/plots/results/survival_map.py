"""What the robot survives, a panel for each method, one colour scale."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LinearSegmentedColormap, Normalize
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.results.matrix import draw_matrix

_COLOURS = LinearSegmentedColormap.from_list("survival", (look.VERMILLION, "#F7F3E8", look.BLUE))

_LONGEST_UPRIGHT = 3  # characters of a label of columns that need no turning


def figure(result: dict) -> Figure:
    rows, columns, panels = result["rows"]["labels"], result["columns"]["labels"], result["methods"]
    of = result["of_each_cell"]
    panel_in = max(3.2, 0.42 * len(columns) + 0.6)
    size_in = (panel_in * len(panels) + 1.2, 0.42 * len(rows) + 2.0)
    drawn, axes = plt.subplots(1, len(panels), figsize=size_in, sharey=True, squeeze=False, layout="constrained")
    for axis, panel in zip(axes[0], panels):
        shares = np.array(panel["cells"]) / of
        image = draw_matrix(axis, shares, rows, columns, _COLOURS, Normalize(0.0, 1.0))
        if of > 1:
            for (row, column), share in np.ndenumerate(shares):
                colour = "white" if share > 0.8 else look.BLACK
                axis.text(column, row, round(share * of), ha="center", va="center", size=8, color=colour)
        name = f"{result['method_title']} {panel['method']}"
        axis.set_title(f"{name}: {panel['survive']} of {result['of_each_method']}", size=10)
        axis.set_xlabel(result["columns"]["title"])
        if max(map(len, columns)) > _LONGEST_UPRIGHT:
            axis.tick_params(axis="x", rotation=45)
    axes[0, 0].set_ylabel(result["rows"]["title"])
    drawn.suptitle(f"{result['title']}, plant {result['plant']}", size=11)
    drawn.colorbar(image, ax=axes[0, :], label="share of survivors", pad=0.01)
    return drawn
