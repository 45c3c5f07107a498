"""What all matrices have in common: square cells, labels at every row that fits, no grid lines."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Colormap, Normalize
from matplotlib.image import AxesImage

_MOST_LABELS = 26


def _every(count: int) -> int:
    return -(-count // _MOST_LABELS)


def draw_matrix(
    axis: Axes, values: np.ndarray, rows: Sequence, columns: Sequence, colours: Colormap, scale: Normalize
) -> AxesImage:
    """Draws values by row and column, the first row at the bottom."""
    image = axis.imshow(values, cmap=colours, norm=scale, origin="lower", aspect="auto")
    step = _every(len(rows))
    axis.set_yticks(range(0, len(rows), step), [str(row) for row in rows[::step]])
    step = _every(len(columns))
    axis.set_xticks(range(0, len(columns), step), [str(column) for column in columns[::step]])
    axis.grid(visible=False)
    axis.set_xticks(np.arange(len(columns) + 1) - 0.5, minor=True)
    axis.set_yticks(np.arange(len(rows) + 1) - 0.5, minor=True)
    axis.grid(visible=True, which="minor", color="white", linewidth=0.8, alpha=1.0)
    axis.tick_params(which="both", length=0)
    return image
