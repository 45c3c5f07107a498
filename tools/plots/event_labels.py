"""Words for events, and where their labels go so that none covers another."""

from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from tools.plots.read_run import Event

LABEL_SIZE_PT = 8.5
_LABEL_GAP_PT = 8.0
_POINTS_PER_INCH = 72.0

# Codes of lcm_types/event_t.lcm.
_WORDS = {
    0: "first step",
    1: "payload detected",
    2: "reflex done",
    3: "settled",
    4: "shifted",
    5: "step restored",
    6: "walks on",
    7: "payload seen",
    8: "stop",
    16: "+{value:.3g} kg",
    17: "fell",
    18: "fault[{value:.0f}] begins",
    19: "fault[{value:.0f}] ends",
    32: "fault {value:.0f}",
    33: "reach lost",
}


def words(event: Event) -> str:
    """The event as a label; an unknown code by the name that the log gives it."""
    return _WORDS.get(event.code, event.name.replace("_", " ")).format(value=event.value)


def label_width_in(text: str) -> float:
    """Printed width, gap to the next label included."""
    path = TextPath((0, 0), text, size=LABEL_SIZE_PT, prop=FontProperties())
    return (path.get_extents().width + _LABEL_GAP_PT) / _POINTS_PER_INCH


def stack_labels(positions: list[float], widths: list[float]) -> list[int]:
    """Levels, 0 lowest, for labels that start at their mark and run to the right.

    `positions` ascend. A label stands above all later ones whose marks lie under it, so that the
    line from a mark up to its label crosses no label.
    """
    levels = [0] * len(positions)
    for i in reversed(range(len(positions))):
        end = positions[i] + widths[i]
        covered = [levels[j] for j in range(i + 1, len(positions)) if positions[j] < end]
        levels[i] = 1 + max(covered) if covered else 0
    return levels
