"""A run as tables of plain columns: a table a channel, one of all frames, one a message of the DBC."""

from collections.abc import Iterator

import cantools
import numpy as np

from tools.export.lcm_log import Channel
from tools.export.protobuf_layout import is_text
from tools.export.run_files import DBC, RunFiles

Columns = dict[str, np.ndarray]
_TABLE_NAMES = {"event": "events"}


def table_name(channel: str) -> str:
    """`state` of SUREFOOT_STATE."""
    name = channel.removeprefix("SUREFOOT_").lower()
    return _TABLE_NAMES.get(name, name)


def element_names(name: str, shape: tuple[int, ...]) -> Iterator[tuple[str, tuple[int, ...]]]:
    """`joint_angle_rad[0][3]` and its index, for every element."""
    for index in np.ndindex(shape):
        yield name + "".join(f"[{i}]" for i in index), index


def channel_columns(channel: Channel) -> Columns:
    """`time_s` on the scenario's clock, then every field of the message, element by element."""
    columns: Columns = {"time_s": channel.time_s}
    for field in channel.schema.fields:
        values = channel.rows[field.name]
        if is_text(field):
            columns[field.name] = np.array([v.tobytes().rstrip(b"\0").decode("ascii", "replace") for v in values])
            continue
        native = values.astype(values.dtype.newbyteorder("="))
        for name, index in element_names(field.name, field.shape):
            columns[name] = native[(slice(None), *index)]
    return columns


def _signal(bits: np.ndarray, signal: cantools.database.Signal) -> np.ndarray:
    """Physical values of one signal, a little-endian integer, from the bits of many frames."""
    word = np.zeros((len(bits), 64), np.uint8)
    word[:, : signal.length] = bits[:, signal.start : signal.start + signal.length]
    if signal.is_signed:
        word[:, signal.length :] = word[:, signal.length - 1 : signal.length]
    raw = np.packbits(word, axis=1, bitorder="little").view("<i8" if signal.is_signed else "<u8")[:, 0]
    if signal.scale == 1 and signal.offset == 0:
        return raw
    return raw * signal.scale + signal.offset


def can_tables(run: RunFiles) -> Iterator[tuple[str, Columns]]:
    """`can_frames` with all frames, then the decoded signals of each message whose length is that of the DBC."""
    frames, time_s = run.frames, run.frame_time_s
    messages = cantools.database.load_file(DBC).messages
    names = {message.frame_id: message.name for message in messages}
    yield "can_frames", {
        "time_s": time_s,
        "bus": np.array(frames.buses),
        "id": frames.identifiers,
        "name": np.array([names.get(identifier, "") for identifier in frames.identifiers.tolist()]),
        "is_fd": frames.is_fd,
        "flags": frames.flags,
        "data_hex": np.array([data.hex() for data in frames.data]),
    }
    lengths = np.array([len(data) for data in frames.data])
    for message in messages:
        rows = np.flatnonzero((frames.identifiers == message.frame_id) & (lengths == message.length))
        if not len(rows):
            continue
        data = np.frombuffer(b"".join(frames.data[row] for row in rows), np.uint8).reshape(-1, message.length)
        bits = np.unpackbits(data, axis=1, bitorder="little")
        columns = {"time_s": time_s[rows], "bus": np.array(frames.buses)[rows]}
        columns |= {signal.name: _signal(bits, signal) for signal in message.signals}
        yield f"can_{message.name.lower()}", columns


def tables(run: RunFiles) -> Iterator[tuple[str, Columns]]:
    """Every table of the run as name and columns of one length."""
    for channel in run.channels.values():
        yield table_name(channel.name), channel_columns(channel)
    if run.frames is not None and len(run.frames):
        yield from can_tables(run)
