"""Survivors over a band of plants: floor friction by toe length."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import Normalize
from matplotlib.figure import Figure

from tools.plots import look
from tools.plots.results.matrix import draw_matrix


def figure(result: dict) -> Figure:
    frictions, toes_m = result["frictions"], result["toes_m"]
    counts = np.array([cell["survive"] for cell in result["counts"]]).reshape(len(frictions), len(toes_m))
    drawn, axis = plt.subplots(figsize=(1.5 + 0.9 * len(toes_m), 1.2 + 0.5 * len(frictions)))
    toes_mm = [f"{1e3 * toe_m:.5g}" for toe_m in toes_m]
    image = draw_matrix(axis, counts, frictions, toes_mm, plt.get_cmap("viridis"), Normalize(0.0, result["of"]))
    for (row, column), count in np.ndenumerate(counts):
        colour = look.BLACK if count > 0.6 * result["of"] else "white"
        axis.text(column, row, count, ha="center", va="center", color=colour)
    axis.set_xlabel("toe length (mm)")
    axis.set_ylabel("floor friction")
    axis.set_title(f"reflex {result['method']} around plant {result['plant']}", loc="left", size=10)
    drawn.colorbar(image, label=f"survivors of {result['of']} cells")
    return drawn
