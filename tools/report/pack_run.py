"""A run folder as what the page reads: an index, and blocks of compressed arrays."""

import json
import re
import subprocess
import tomllib
from pathlib import Path

import cantools
import numpy as np

from tools.export.candump_log import read_frames
from tools.export.lcm_log import Channel, read_channels
from tools.plots.read_run import RunFolderError
from tools.report.blocks import Blocks, add_columns
from tools.report.labels import label, unit

_ROOT = Path(__file__).resolve().parents[2]
_DBC = _ROOT / "firmware" / "can" / "surefoot.dbc"
_FAULTS = _ROOT / "firmware" / "FAULTS.md"
_TABLES = {
    "SUREFOOT_STATE": "state",
    "SUREFOOT_TRUTH": "truth",
    "SUREFOOT_STABILIZER": "stabilizer",
    "SUREFOOT_BUS": "bus",
}
_CHUNK_US = 1_000_000
_FAULT_LATCHED = 32


def _flat_columns(channel: Channel, field: str) -> dict[str, np.ndarray]:
    values = channel.rows[field]
    shape = values.shape[1:]
    return {
        field + "".join(f"[{i}]" for i in index): np.ascontiguousarray(values[(slice(None), *index)])
        for index in np.ndindex(shape)
    }


def _table(blocks: Blocks, prefix: str, name: str, channel: Channel) -> dict:
    columns = []
    for field in channel.schema.fields:
        if field.name in ("utime", "tick"):
            continue
        block = f"{prefix}_{name}_{field.name}"
        for column in add_columns(blocks, block, _flat_columns(channel, field.name)):
            index = tuple(map(int, re.findall(r"\[(\d+)\]", column["name"])))
            columns.append({**column, "unit": unit(field.name), "label": label(field.name, index, field.shape)})
    microseconds = {"time_s": channel.rows["utime"].astype(np.int32)}
    time = add_columns(blocks, f"{prefix}_{name}_utime", microseconds)[0]
    return {"name": name, "rows": len(channel.rows), "time": {**time, "scale": 1e-6, "unit": "s"}, "columns": columns}


def _events(channels: dict[str, Channel]) -> list[dict]:
    if "SUREFOOT_EVENT" not in channels:
        return []
    rows = channels["SUREFOOT_EVENT"].rows
    return [
        {
            "time_s": int(row["utime"]) / 1e6, "code": int(row["code"]),
            "name": bytes(row["name"]).split(b"\0")[0].decode("ascii", "replace"), "value": float(row["value"]),
        }
        for row in rows
    ]  # fmt: skip


def fault_help() -> dict[str, dict]:
    """Number of each fault to its name and paragraph in firmware/FAULTS.md."""
    sections = re.findall(r"^## (\d+) (\w+)\n(.*?)(?=^## |\Z)", _FAULTS.read_text(), re.MULTILINE | re.DOTALL)
    return {number: {"name": name, "text": text.strip()} for number, name, text in sections}


def _signal(signal: cantools.database.can.Signal) -> dict:
    return {
        "name": signal.name, "start": signal.start, "length": signal.length, "byte_order": signal.byte_order,
        "is_signed": signal.is_signed, "scale": float(signal.scale), "offset": float(signal.offset),
        "unit": signal.unit or "",
        "choices": {str(value): str(name) for value, name in signal.choices.items()} if signal.choices else None,
    }  # fmt: skip


def _messages() -> list[dict]:
    database = cantools.database.load_file(_DBC)
    return [
        {
            "id": message.frame_id, "name": message.name, "length": message.length, "sender": (message.senders or [""])[0],
            "comment": message.comment or "", "signals": [_signal(signal) for signal in message.signals],
        }
        for message in sorted(database.messages, key=lambda message: message.frame_id)
    ]  # fmt: skip


def _chunk(times_us: np.ndarray, identifiers: np.ndarray, data: list[bytes]) -> bytes:
    """Number of frames, then of all frames, by identifier and time: time, identifier, length; and all payloads."""
    order = np.lexsort((times_us, identifiers))
    lengths = np.array([len(data[i]) for i in order], np.uint8)
    steps_us = np.diff(times_us[order].astype(np.int64), prepend=0).astype("<i4")
    head = np.array([len(order)], "<u4").tobytes() + steps_us.tobytes()
    return head + identifiers[order].astype("<u2").tobytes() + lengths.tobytes() + b"".join(data[i] for i in order)


def _frames(blocks: Blocks, prefix: str, folder: Path, zero_us: int) -> dict | None:
    frames = read_frames(folder / "bus.log")
    if len(frames) == 0:
        return None
    times_us = frames.time_us - zero_us
    chunks = []
    edges = range(int(times_us[0] // _CHUNK_US) * _CHUNK_US, int(times_us[-1]) + 1, _CHUNK_US)
    for number, from_us in enumerate(edges):
        first, last = np.searchsorted(times_us, (from_us, from_us + _CHUNK_US))
        content = _chunk(times_us[first:last], frames.identifiers[first:last], frames.data[first:last])
        block = blocks.add(f"{prefix}_frames_{number}", content)
        chunks.append(
            {"from_s": from_us / 1e6, "to_s": (from_us + _CHUNK_US) / 1e6, "rows": int(last - first), "block": block}
        )
    return {"messages": _messages(), "chunks": chunks}


def _json_of(binary: Path, *arguments: object) -> dict | None:
    """What the program says of a scenario; nothing when it cannot read it (a run of another version)."""
    finished = subprocess.run([binary, *map(str, arguments)], capture_output=True, text=True, check=False)
    return json.loads(finished.stdout) if finished.returncode == 0 else None


def _extent(truth: np.ndarray) -> str:
    low, high = truth[:, :2].min(axis=0) - 0.8, truth[:, :2].max(axis=0) + 0.8
    return f"--extent={low[0]:.2f},{high[0]:.2f},{low[1]:.2f},{high[1]:.2f}"


def pack_run(blocks: Blocks, prefix: str, folder: Path, name: str, binary: Path, has_frames: bool) -> dict:
    """One run of the page's index; its arrays go into `blocks`, their names begin with `prefix`.

    Raises RunFolderError when there is nothing to read.
    """
    channels = read_channels(folder / "telemetry.lcmlog")
    for channel in ("SUREFOOT_STATE", "SUREFOOT_TRUTH"):
        if channel not in channels:
            raise RunFolderError(f"{folder}: holds no message on {channel}\n  remedy: run the scenario again")
    scenario_file, verdict_file = folder / "scenario.toml", folder / "verdict.json"
    try:
        scenario_toml = scenario_file.read_text() if scenario_file.is_file() else ""
        tomllib.loads(scenario_toml)
        verdict = json.loads(verdict_file.read_text()) if verdict_file.is_file() else None
    except ValueError as error:
        raise RunFolderError(f"{folder}: scenario.toml or verdict.json: {error}\n  remedy: run it again") from error
    state, truth = channels["SUREFOOT_STATE"], channels["SUREFOOT_TRUTH"]
    zero_us = int(state.recorded_us[0] - state.rows["utime"][0])
    latched = {str(int(event["value"])) for event in _events(channels) if event["code"] == _FAULT_LATCHED}
    return {
        "name": name, "verdict": verdict, "scenario_toml": scenario_toml,
        "model": _json_of(binary, "model", scenario_file, "--json", _extent(truth.rows["body_position_world_m"])),
        "events": _events(channels),
        "fault_help": {number: text for number, text in fault_help().items() if number in latched},
        "tables": [_table(blocks, prefix, _TABLES[channel], channels[channel]) for channel in _TABLES
                   if channel in channels],
        "frames": _frames(blocks, prefix, folder, zero_us) if has_frames else None,
        "bus": _json_of(binary, "bus", scenario_file, "--json"),
    }  # fmt: skip
