"""A run folder as arrays: what `tools/surefoot run` recorded."""

import json
import tomllib
from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path

import lcm
import numpy as np

from tools.plots.messages import message_types

Columns = dict[str, np.ndarray]


class RunFolderError(Exception):
    """The folder holds no run that can be read; the message names path and remedy."""


@dataclass(frozen=True)
class Event:
    """Something that happened once, on the scenario's clock."""

    time_s: float
    code: int
    name: str
    value: float


@dataclass(frozen=True)
class Run:
    """One recorded run. Columns carry the message's field names plus `time_s` (scenario clock)."""

    folder: Path
    state: Columns  # controller_state_t, one row a tick
    truth: Columns  # simulator_truth_t, one row a tick
    bus: Columns  # bus_statistics_t
    stabilizer: Columns  # stabilizer_t; empty unless the robot walks on floors
    events: list[Event]
    scenario: dict  # scenario.toml; empty when it is missing
    verdict: dict  # verdict.json; empty when the run was interrupted before it

    @property
    def torque_limit_nm(self) -> float | None:
        return self.scenario.get("drive", {}).get("torque_limit_nm")


def _channel_types() -> dict[str, type]:
    types = message_types()
    return {
        "SUREFOOT_STATE": types.controller_state_t,
        "SUREFOOT_TRUTH": types.simulator_truth_t,
        "SUREFOOT_BUS": types.bus_statistics_t,
        "SUREFOOT_EVENT": types.event_t,
        "SUREFOOT_STABILIZER": types.stabilizer_t,
    }


def read_messages(log_path: Path) -> dict[str, list]:
    """All decoded messages of an LCM event log by channel; other channels are left out.

    Reads a log that ends in the middle of a message up to the last whole one.
    """
    types = _channel_types()
    messages = defaultdict(list)
    for record in lcm.EventLog(str(log_path), "r"):
        if record.channel not in types:
            continue
        try:
            messages[record.channel].append(types[record.channel].decode(record.data))
        except ValueError as error:
            raise RunFolderError(
                f"{log_path}: a message on {record.channel} has another type than lcm_types/ of this tree\n"
                "  remedy: read it with the version of Surefoot that wrote it, or run the scenario again"
            ) from error
    return messages


def _columns(messages: list) -> Columns:
    if not messages:
        return {}
    columns = {field: np.array([getattr(m, field) for m in messages]) for field in messages[0].__slots__}
    columns["time_s"] = columns["utime"] * 1e-6
    return columns


def _event(message) -> Event:
    name = bytes(message.name).split(b"\0")[0].decode("ascii", "replace")
    return Event(message.utime * 1e-6, message.code, name, message.value)


def read_run(folder: Path) -> Run:
    """Reads a run folder; an interrupted run gives what was recorded until then.

    Raises RunFolderError when there is nothing to read.
    """
    log_path = folder / "telemetry.lcmlog"
    if not log_path.is_file():
        raise RunFolderError(
            f"{log_path}: no such file\n  remedy: give a folder that `tools/surefoot run --out FOLDER` wrote"
        )
    messages = read_messages(log_path)
    for channel in ("SUREFOOT_STATE", "SUREFOOT_TRUTH"):
        if not messages[channel]:
            raise RunFolderError(
                f"{log_path}: holds no message on {channel}\n  remedy: run the scenario again; this run recorded nothing"
            )
    scenario_path, verdict_path = folder / "scenario.toml", folder / "verdict.json"
    try:
        scenario = tomllib.loads(scenario_path.read_text()) if scenario_path.is_file() else {}
        verdict = json.loads(verdict_path.read_text()) if verdict_path.is_file() else {}
    except ValueError as error:  # TOMLDecodeError, JSONDecodeError and UnicodeDecodeError are all of this kind
        raise RunFolderError(
            f"{folder}: scenario.toml or verdict.json cannot be read: {error}\n  remedy: run the scenario again"
        ) from error
    return Run(
        folder=folder,
        state=_columns(messages["SUREFOOT_STATE"]),
        truth=_columns(messages["SUREFOOT_TRUTH"]),
        bus=_columns(messages["SUREFOOT_BUS"]),
        stabilizer=_columns(messages["SUREFOOT_STABILIZER"]),
        events=[_event(message) for message in messages["SUREFOOT_EVENT"]],
        scenario=scenario,
        verdict=verdict,
    )
