"""How all pictures look: colours that colour-blind readers tell apart, sizes, sides and phases."""

import matplotlib

# Okabe and Ito, https://jfly.uni-koeln.de/color/
BLUE, VERMILLION, GREEN, PURPLE, GREY, BLACK = "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#999999", "#000000"

# Index of a message's per-side fields. Lines differ in dash as well as in colour.
SIDES = (
    (0, "right", {"color": BLUE, "linestyle": "-"}),
    (1, "left", {"color": VERMILLION, "linestyle": (0, (5, 1.5))}),
)

# Phases of firmware/core/decision/reflex_phase.hpp; walking stays white.
PHASES = {
    0: ("standing", "#E4E4E4"),
    1: ("walking", None),
    2: ("reflex", "#F2B8A2"),
    3: ("settling", "#FBF3C0"),
    4: ("shifting", "#BFE0F5"),
    5: ("restoring", "#BFE8D6"),
    6: ("resting", "#EFD8E6"),
    7: ("stopped", "#D9C7C7"),
}

DOTS_PER_INCH = 110
FIGURE_WIDTH_IN = 12.0


def apply() -> None:
    """Draw without a display, in our sizes."""
    matplotlib.use("Agg")
    matplotlib.rcParams.update(
        {
            "font.size": 10.0,
            "axes.grid": True,
            "axes.axisbelow": True,
            "grid.alpha": 0.35,
            "grid.linewidth": 0.6,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "lines.linewidth": 1.3,
            "legend.frameon": False,
            "legend.fontsize": 9.0,
            "savefig.dpi": DOTS_PER_INCH,
        }
    )
