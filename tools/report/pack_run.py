"""A run folder as what the page reads: an index, and blocks of compressed arrays."""

from pathlib import Path

import cantools
import numpy as np

from tools.export.candump_log import read_frames
from tools.export.lcm_log import Channel, read_channels
from tools.plots.read_run import RunFolderError
from tools.report.blocks import Blocks, add_columns
from tools.report.columns import TABLES, columns_of, value_fields
from tools.report.events import event
from tools.report.scenario_view import fault_help, read_verdict, scenario_view

_ROOT = Path(__file__).resolve().parents[2]
_DBC = _ROOT / "firmware" / "can" / "surefoot.dbc"
_CHUNK_US = 1_000_000
_LARGEST_INT32 = 2**31


def _table(blocks: Blocks, prefix: str, name: str, channel: Channel) -> dict:
    described = columns_of(channel.schema)
    packed = [
        column
        for field in value_fields(channel.schema)
        for column in add_columns(blocks, f"{prefix}_{name}_{field.name}", _flat_columns(channel, field.name))
    ]
    columns = [{**packing, **column} for packing, column in zip(packed, described, strict=True)]
    return {"name": name, "rows": len(channel.rows), "time": _time(blocks, prefix, name, channel), "columns": columns}


def _flat_columns(channel: Channel, field: str) -> dict[str, np.ndarray]:
    values = channel.rows[field]
    return {str(index): np.ascontiguousarray(values[(slice(None), *index)]) for index in np.ndindex(values.shape[1:])}


def _time(blocks: Blocks, prefix: str, name: str, channel: Channel) -> dict:
    """In the scenario's microseconds where they fit into 32 bits, of half an hour; else in the ticks' greatest unit."""
    utime = channel.rows["utime"].astype(np.int64)
    unit_us = 1 if np.abs(utime).max(initial=0) < _LARGEST_INT32 else 1000
    packed = add_columns(blocks, f"{prefix}_{name}_utime", {"time_s": (utime // unit_us).astype(np.int32)})[0]
    return {**packed, "scale": 1e-6 * unit_us, "unit": "s"}


def _events(channels: dict[str, Channel]) -> list[dict]:
    if "SUREFOOT_EVENT" not in channels:
        return []
    rows = channels["SUREFOOT_EVENT"].rows
    return [event(int(row["utime"]), int(row["code"]), row["name"], float(row["value"])) for row in rows]


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
    """Number of frames, then of all frames, by identifier and time: time in the chunk, identifier, length; payloads."""
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
        content = _chunk(times_us[first:last] - from_us, frames.identifiers[first:last], frames.data[first:last])
        block = blocks.add(f"{prefix}_frames_{number}", content)
        chunks.append(
            {"from_s": from_us / 1e6, "to_s": (from_us + _CHUNK_US) / 1e6, "rows": int(last - first), "block": block}
        )
    return {"messages": _messages(), "chunks": chunks}


def pack_run(blocks: Blocks, prefix: str, folder: Path, name: str, binary: Path, has_frames: bool) -> dict:
    """One run of the page's index; its arrays go into `blocks`, their names begin with `prefix`.

    Raises RunFolderError when there is nothing to read.
    """
    channels = read_channels(folder / "telemetry.lcmlog")
    for channel in ("SUREFOOT_STATE", "SUREFOOT_TRUTH"):
        if channel not in channels:
            raise RunFolderError(f"{folder}: holds no message on {channel}\n  remedy: run the scenario again")
    truth = channels["SUREFOOT_TRUTH"].rows
    state = channels["SUREFOOT_STATE"]
    zero_us = int(state.recorded_us[0] - state.rows["utime"][0])
    return {
        "name": name, "verdict": read_verdict(folder), "events": _events(channels), "fault_help": fault_help(),
        **scenario_view(folder, binary, truth["body_position_world_m"]),
        "tables": [_table(blocks, prefix, table, channels[channel]) for channel, table in TABLES.items()
                   if channel in channels],
        "frames": _frames(blocks, prefix, folder, zero_us) if has_frames else None,
    }  # fmt: skip
