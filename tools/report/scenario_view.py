"""What a page shows of a run beside its numbers: scenario, robot and floor, bus, verdict, faults in words."""

import json
import math
import re
import subprocess
import tomllib
from functools import cache
from pathlib import Path

import numpy as np

from tools.plots.read_run import RunFolderError

_FAULTS = Path(__file__).resolve().parents[2] / "firmware" / "FAULTS.md"
_AROUND_M = 0.8


@cache
def fault_help() -> dict[str, dict]:
    """Number of each fault to its name and paragraph in firmware/FAULTS.md."""
    sections = re.findall(r"^## (\d+) (\w+)\n(.*?)(?=^## |\Z)", _FAULTS.read_text(), re.MULTILINE | re.DOTALL)
    return {number: {"name": name, "text": text.strip()} for number, name, text in sections}


def _number(token: str) -> float:
    if not math.isfinite(number := float(token)):
        raise ValueError(f"{token} is no number of JSON")
    return number


def read_verdict(folder: Path) -> dict | None:
    """verdict.json of a run that has ended; raises RunFolderError where it is damaged."""
    file = folder / "verdict.json"
    try:
        verdict = json.loads(file.read_text(), parse_constant=_number, parse_float=_number)
        if not isinstance(verdict, dict) or not isinstance(verdict.get("verdict"), str):
            raise ValueError("holds no verdict")
    except FileNotFoundError:
        return None
    except OSError as error:
        raise RunFolderError(f"{file}: {error.strerror}\n  remedy: run as the user whom it belongs to") from error
    except (ValueError, RecursionError) as error:
        raise RunFolderError(f"{file}: {error}\n  remedy: run the scenario again") from error
    return verdict


def scenario_text(folder: Path) -> str:
    """The effective scenario of a run; empty where there is none, or no text."""
    try:
        return (folder / "scenario.toml").read_text()
    except (OSError, UnicodeDecodeError):
        return ""


def _json_of(binary: Path, *arguments: object) -> dict | None:
    """What the program says of a scenario; nothing when it cannot read it (a run of another version)."""
    finished = subprocess.run([binary, *map(str, arguments)], capture_output=True, text=True, check=False)
    return json.loads(finished.stdout) if finished.returncode == 0 else None


def _faults(scenario: dict) -> list[dict]:
    """Those of the scenario, for JSON: it has no word for inf, nor for TOML's dates."""
    faults = scenario.get("fault", [])
    if not isinstance(faults, list) or not all(isinstance(fault, dict) for fault in faults):
        raise ValueError("fault: is no list of tables")
    return [{key: _value(value) for key, value in fault.items()} for fault in faults]


def _value(value: object) -> float | int | str | None:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value if isinstance(value, int) else str(value)


def _extent(way_m: np.ndarray | None) -> list[str]:
    if way_m is None:
        return []
    low, high = way_m[:, :2].min(axis=0) - _AROUND_M, way_m[:, :2].max(axis=0) + _AROUND_M
    return [f"--extent={low[0]:.2f},{high[0]:.2f},{low[1]:.2f},{high[1]:.2f}"]


def scenario_view(folder: Path, binary: Path, way_m: np.ndarray | None) -> dict:
    """Scenario, its faults, model and bus of the run in a folder.

    `way_m`, places of the body in the world, n x 3, says how much of the floor is needed; without it that around the
    start. Raises RunFolderError where scenario.toml is damaged; without that file there is nothing to tell.
    """
    text = scenario_text(folder)
    if not text:
        return {"scenario_toml": "", "faults": [], "model": None, "bus": None}
    file = folder / "scenario.toml"
    try:
        faults = _faults(tomllib.loads(text))
    except (ValueError, RecursionError) as error:
        raise RunFolderError(f"{file}: {error}\n  remedy: run the scenario again") from error
    return {
        "scenario_toml": text, "faults": faults,
        "model": _json_of(binary, "model", file, "--json", *_extent(way_m)),
        "bus": _json_of(binary, "bus", file, "--json"),
    }  # fmt: skip
