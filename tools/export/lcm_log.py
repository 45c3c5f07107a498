"""A telemetry log as arrays, one structured row a message, without decoding a message at a time."""

import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tools.export.lcm_schema import Schema, schemas
from tools.plots.messages import message_types
from tools.plots.read_run import RunFolderError

_SYNC = 0xEDA1DA01
_HEADER = struct.Struct(">IqqII")  # sync word, number, time in microseconds, lengths of channel and data


@dataclass(frozen=True)
class Channel:
    """All messages of a channel in the log's order."""

    name: str
    schema: Schema
    numbers: np.ndarray  # place in the log
    recorded_us: np.ndarray  # since power-up
    rows: np.ndarray  # Schema.wire_dtype

    @property
    def time_s(self) -> np.ndarray:
        """Scenario clock."""
        return self.rows["utime"] / 1e6


def _wrong_type(path: Path, channel: str) -> RunFolderError:
    return RunFolderError(
        f"{path}: a message on {channel} has another type than lcm_types/ of this tree\n"
        "  remedy: read it with the version of Surefoot that wrote it, or run the scenario again"
    )


def _records(path: Path) -> dict[str, tuple[list[int], list[int], list[bytes]]]:
    """Numbers, times and data by channel; a log that ends within a message gives its whole ones."""
    log = path.read_bytes()
    channels: dict[str, tuple[list[int], list[int], list[bytes]]] = {}
    at, number = 0, 0
    while at + _HEADER.size <= len(log):
        sync, _, time_us, name_bytes, data_bytes = _HEADER.unpack_from(log, at)
        if sync != _SYNC:
            raise RunFolderError(f"{path}: no LCM event begins at byte {at}\n  remedy: run the scenario again")
        data_at = at + _HEADER.size + name_bytes
        end = data_at + data_bytes
        if end > len(log):
            break
        name = log[at + _HEADER.size : data_at].decode("ascii", "replace")
        numbers, times, data = channels.setdefault(name, ([], [], []))
        numbers.append(number)
        times.append(time_us)
        data.append(log[data_at:end])
        at, number = end, number + 1
    return channels


def read_channels(path: Path) -> dict[str, Channel]:
    """Every channel of the log by name. The type of a channel is that of its messages' fingerprint.

    Raises RunFolderError for a file that is no such log, is empty, or holds other types than this tree's.
    """
    if not path.is_file():
        raise RunFolderError(
            f"{path}: no such file\n  remedy: give a folder that `tools/surefoot run --out FOLDER` wrote"
        )
    types = message_types()
    by_fingerprint = {getattr(types, name)._get_packed_fingerprint(): schema for name, schema in schemas().items()}
    channels = {}
    for name, (numbers, times, data) in _records(path).items():
        schema = by_fingerprint.get(data[0][:8])
        if schema is None or any(len(d) != schema.wire_dtype.itemsize or d[:8] != data[0][:8] for d in data):
            raise _wrong_type(path, name)
        rows = np.frombuffer(b"".join(data), schema.wire_dtype)
        channels[name] = Channel(name, schema, np.array(numbers), np.array(times), rows)
    if not channels:
        raise RunFolderError(f"{path}: holds no message\n  remedy: run the scenario again; this run recorded nothing")
    return channels
