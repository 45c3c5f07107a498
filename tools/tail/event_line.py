"""An event as a line for people: when, what, and what its value means (lcm_types/event_t.lcm)."""

import math
import re

from tools.report.scenario_view import fault_help

_RED, _YELLOW, _BLUE, _PLAIN = "\033[31m", "\033[33m", "\033[34m", "\033[0m"


def _meaning(name: str, value: float) -> str:
    if name == "fault_latched":
        number = str(round(value))
        return f"{number} {fault_help().get(number, {}).get('name', '')}".strip()
    if name in ("payload_attached", "payload_removed"):
        return f"{value:g} kg"
    if name == "payload_seen":
        return f"{value:.1f} N"
    if name == "fell":
        return f"pitch {math.degrees(value):+.1f} deg"
    if name == "reach_lost":
        return f"midpoint of the feet {1000.0 * value:+.1f} mm"
    if re.match(r"fault_|push_", name):
        return f"number {round(value)} of the scenario"
    return ""


def _colour(name: str) -> str:
    if re.search(r"fault|fell|lost", name):
        return _RED
    return _YELLOW if re.match(r"payload|push", name) else _BLUE


def event_line(time_s: float, name: str, value: float, has_colour: bool) -> str:
    """`    1.2000 s  payload_attached  5 kg`; coloured for a terminal only."""
    shown = f"{_colour(name)}{name:<17}{_PLAIN}" if has_colour else f"{name:<17}"
    return f"{time_s:10.4f} s  {shown} {_meaning(name, value)}".rstrip()
