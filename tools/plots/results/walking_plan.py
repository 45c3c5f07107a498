"""A planned step: centre of mass, ZMP in its support, stick figures, feet, patterns (Al-Shuka et al. 2014)."""

import math

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from tools.plots import look

_STICKS = 13
_PATTERNS = {
    "flat_feet": "1, level feet",
    "rolled_together": "2, rolled together",
    "rolled_in_turn": "3, rolled in turn",
}
_STANCE = {"color": look.BLUE}
_SWING = {"color": look.VERMILLION}


def _array(values: list) -> np.ndarray:
    return np.array([math.nan if value is None else value for value in values], dtype=float)


def _shade_double_support(axis: Axes, walk: dict) -> None:
    axis.axvspan(0.0, walk["gait"]["double_support_s"], facecolor="#E4E4E4", linewidth=0, zorder=0)
    axis.set_xlim(0.0, walk["time_s"][-1])
    axis.set_xlabel("time since the landing (s)")


def _draw_com(axes: list[Axes], result: dict) -> None:
    rows = (("com_x_m", "COG (m)"), ("com_x_m_s", "COG velocity (m/s)"), ("com_x_m_s2", "COG acceleration (m/s²)"))
    before, after = result["before"], result["after"]
    for axis, (member, label) in zip(axes, rows):
        if result["turns"]:
            axis.plot(before["time_s"], before[member], color=look.GREY, linestyle=(0, (5, 1.5)), label="before")
        axis.plot(after["time_s"], after[member], color=look.BLUE, label="after" if result["turns"] else "as asked")
        _shade_double_support(axis, after)
        axis.set_title(label, loc="left", size=10)
    axes[0].legend(loc="upper left")


def _draw_zmp(axis: Axes, walk: dict, title: str) -> None:
    axis.fill_between(
        walk["time_s"], walk["support_rear_m"], walk["support_front_m"], color=look.GREEN, alpha=0.15, linewidth=0,
        label="support",
    )  # fmt: skip
    axis.plot(walk["time_s"], walk["ideal_zmp_m"], color=look.GREY, linestyle=(0, (5, 1.5)), label="ZMP, point mass")
    real = _array(walk["real_zmp_m"])
    axis.plot(walk["time_s"], real, color=look.VERMILLION, label="ZMP, bodies in motion")
    # A nearly stretched knee gives any ZMP; what stands far outside is cut off.
    lowest, highest = min(walk["support_rear_m"]), max(walk["support_front_m"])
    space = 0.35 * (highest - lowest)
    axis.set_ylim(lowest - space, highest + space)
    _shade_double_support(axis, walk)
    margin = walk["margins"]["least_zmp_margin_m"]
    said = "a knee is stretched" if margin is None else f"least margin {1e3 * margin:.0f} mm"
    axis.set_title(f"{title}: {said}", loc="left", size=10)


def _knee(hip: tuple, ankle: tuple, link_m: float) -> tuple:
    """In front of the line from hip to ankle; on it where the leg is too short."""
    dx, dz = ankle[0] - hip[0], ankle[1] - hip[1]
    length = math.hypot(dx, dz)
    height = math.sqrt(max(0.0, link_m**2 - 0.25 * length**2))
    return 0.5 * (hip[0] + ankle[0]) - height * dz / length, 0.5 * (hip[1] + ankle[1]) + height * dx / length


def _leg(axis: Axes, result: dict, walk: dict, side: str, row: int, style: dict) -> None:
    foot = walk[side]
    hip = (walk["com_x_m"][row], walk["hip_height_m"])
    ankle = (foot["ankle_x_m"][row], foot["ankle_z_m"][row])
    knee = _knee(hip, ankle, result["link_m"])
    pitch = math.radians(foot["pitch_deg"][row])
    tip, heel = (
        (foot["x_m"][row] + along * math.cos(pitch), foot["z_m"][row] - along * math.sin(pitch))
        for along in (result["toe_m"], -result["heel_m"])
    )
    axis.plot(*zip(hip, knee, ankle), linewidth=1.0, **style)
    axis.plot(*zip(heel, tip, ankle, heel), linewidth=1.0, **style)


def _draw_sticks(axis: Axes, result: dict) -> None:
    walk = result["after"]
    for row in np.linspace(0, len(walk["time_s"]) - 1, _STICKS).astype(int):
        for side, style in (("stance", _STANCE), ("swing", _SWING)):
            _leg(axis, result, walk, side, row, {**style, "alpha": 0.35 + 0.65 * row / len(walk["time_s"])})
        axis.plot(walk["com_x_m"][row], walk["hip_height_m"], marker="o", markersize=3, color=look.BLACK)
    axis.axhline(0.0, color=look.BLACK, linewidth=0.8)
    axis.set_aspect("equal")
    axis.set_xlabel("x (m)")
    axis.set_title("Legs over a step, hips marked: the foot ahead blue, the one behind red", loc="left", size=10)


def _draw_feet(path: Axes, pitch: Axes, result: dict) -> None:
    walk = result["after"]
    for side, label, style in (("swing", "behind, then in the air", _SWING), ("stance", "ahead", _STANCE)):
        foot = walk[side]
        x, z, angle = (np.array(foot[member]) for member in ("x_m", "z_m", "pitch_deg"))
        path.plot(foot["ankle_x_m"], foot["ankle_z_m"], **style)
        for along, dash in ((result["toe_m"], (0, (1, 1))), (-result["heel_m"], (0, (5, 1.5)))):
            radians = np.radians(angle)
            path.plot(x + along * np.cos(radians), z - along * np.sin(radians), linestyle=dash, linewidth=0.9, **style)
        pitch.plot(walk["time_s"], angle, label=label, **style)
    path.axhline(0.0, color=look.BLACK, linewidth=0.8)
    path.set_xlabel("x (m)")
    path.set_title("Paths of ankle (line), toe (dots), heel (dashes), height (m)", loc="left", size=10)
    _shade_double_support(pitch, walk)
    pitch.set_title("Pitch of the feet, heel up (deg)", loc="left", size=10)
    pitch.legend(loc="upper right")


def _title(result: dict) -> str:
    gait = result["after"]["gait"]
    words = "feasible" if result["is_feasible"] else f"infeasible ({result['broken']})"
    feet = f"{result['toe_angle_deg']:g}° and {result['heel_angle_deg']:g}°"
    return (
        f"{result['robot']}, pattern {_PATTERNS[result['pattern']]}, feet {feet}: {words}; "
        f"H {gait['com_height_m']:.3f} m, S {gait['step_length_m']:.3f} m, p {gait['single_support_share']:.4f}, T_s {gait['single_support_s']:.3f} s, "
        f"T_d {gait['double_support_s']:.3f} s"
    )


def figure(result: dict) -> Figure:
    """Five rows; double support is grey in everything over time."""
    drawn = plt.figure(figsize=(look.FIGURE_WIDTH_IN, 17.5), layout="constrained")
    rows = drawn.subfigures(5, 1, height_ratios=(3.0, 3.2, 4.2, 3.0, 3.2))
    _draw_com(list(rows[0].subplots(1, 3)), result)
    names = [(result["after"], "ZMP as asked")]
    if result["turns"]:
        names = [(result["before"], "ZMP before compensation"), (result["after"], "ZMP after compensation")]
    axes = rows[1].subplots(1, len(names), squeeze=False)[0]
    for axis, (walk, title) in zip(axes, names):
        _draw_zmp(axis, walk, title)
        axis.set_ylabel("x (m)")
    axes[0].legend(loc="lower right", ncols=3)
    _draw_sticks(rows[2].subplots(), result)
    _draw_feet(*rows[3].subplots(1, 2), result)
    patterns = rows[4].subplots(1, 3, sharey=True)
    for axis, walk in zip(patterns, result["patterns"]):
        _draw_zmp(axis, walk, f"Pattern {_PATTERNS[walk['pattern']]}")
    patterns[0].set_ylabel(f"x (m), H {result['patterns'][0]['gait']['com_height_m']:.3f} m")
    drawn.suptitle(_title(result), size=10)
    return drawn
