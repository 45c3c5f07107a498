"""Names of telemetry columns for people: which leg, which joint, which unit."""

import re

LEGS = ("right", "left")
JOINTS = ("hip yaw", "hip roll", "hip pitch", "knee pitch", "ankle pitch", "ankle roll")
CORNERS = ("front left", "front right", "rear left", "rear right")

# Longest first: `_rad_s` is no `_s`.
_UNITS = (
    ("_n_m", "N m"), ("_nm", "N m"), ("_rad_s", "rad/s"), ("_m_s2", "m/s2"), ("_m_s", "m/s"), ("_n_s", "N s"),
    ("_rad", "rad"), ("_deg", "deg"), ("_percent", "%"), ("_us", "µs"), ("_kg", "kg"), ("_n", "N"), ("_m", "m"),
    ("_s", "s"), ("_ns", "ns"), ("_ticks", "ticks"), ("utime", "µs"),
)  # fmt: skip
_INDEX = re.compile(r"\[(\d+)\]")


def unit(field: str) -> str:
    """Unit of a field by its name's ending; empty where it has none."""
    return next((unit for ending, unit in _UNITS if field.endswith(ending)), "")


def label(field: str, index: tuple[int, ...], shape: tuple[int, ...]) -> str:
    """What a column of an array field is: `right knee pitch`, `left front right`, or its index."""
    if shape == (2,):
        return LEGS[index[0]]
    if shape == (2, 6):
        return f"{LEGS[index[0]]} {JOINTS[index[1]]}"
    if shape == (2, 4):
        return f"{LEGS[index[0]]} {CORNERS[index[1]]}"
    if shape in ((3,), (2, 3)):
        axis = "xyz"[index[-1]]
        return axis if len(shape) == 1 else f"{LEGS[index[0]]} {axis}"
    return " ".join([field, *map(str, index)])
