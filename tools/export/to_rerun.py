"""A run as a Rerun recording: scalars, events as text, and the body's pose."""

from pathlib import Path

import numpy as np

from tools.export.lcm_log import Channel
from tools.export.protobuf_layout import is_text
from tools.export.run_files import RunFiles, body_poses
from tools.export.tables import channel_columns, table_name

_REQUIREMENTS = Path(__file__).resolve().parents[1] / "requirements_tests.txt"
_BODY_HALF_SIZE_M = (0.1, 0.15, 0.2)  # a box to look at, not the robot's


class MissingRerunError(Exception):
    """rerun-sdk is not installed."""


def _rerun():
    try:
        import rerun
    except ImportError as error:
        pinned = next(line for line in _REQUIREMENTS.read_text().splitlines() if line.startswith("rerun-sdk=="))
        raise MissingRerunError(
            f"the Python package rerun-sdk is not installed\n  remedy: run .venv/bin/pip install {pinned}"
        ) from error
    return rerun


def _send_channel(rr, recording, channel: Channel) -> None:
    times = [rr.TimeColumn("scenario_time", duration=channel.time_s), _ticks(rr, channel)]
    table, columns = table_name(channel.name), channel_columns(channel)
    for field in channel.schema.fields:
        if is_text(field):
            texts = rr.TextLog.columns(text=columns[field.name].tolist())
            rr.send_columns(table, times, texts, recording=recording)
        elif field.name not in ("utime", "tick"):
            width = int(np.prod(field.shape, dtype=int))
            values = channel.rows[field.name].reshape(len(channel.rows), width).astype(np.float64)
            scalars = rr.Scalars.columns(scalars=values.ravel())
            path = f"{table}/{field.name}"
            rr.send_columns(path, times, scalars.partition([width] * len(values)), recording=recording)


def _ticks(rr, channel: Channel):
    return rr.TimeColumn("tick", sequence=channel.rows["tick"].astype(np.int64))


def write_rerun(run: RunFiles, path: Path) -> None:
    """Writes a .rrd file; the frames of the bus stay in bus.log. Raises MissingRerunError without rerun-sdk."""
    rr = _rerun()
    recording = rr.RecordingStream("surefoot", recording_id=run.folder.resolve().name)
    recording.save(path)
    for name, text in run.texts.items():
        recording.log(name.replace(".", "_"), rr.TextDocument(text), static=True)
    for channel in run.channels.values():
        _send_channel(rr, recording, channel)
        if channel.schema.name == "simulator_truth_t":
            positions, quaternions = body_poses(channel)
            poses = rr.Transform3D.columns(translation=positions, quaternion=quaternions)
            times = [rr.TimeColumn("scenario_time", duration=channel.time_s), _ticks(rr, channel)]
            rr.send_columns("world/body", times, poses, recording=recording)
            recording.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
            recording.log("world/body", rr.Boxes3D(half_sizes=[_BODY_HALF_SIZE_M]), static=True)
    recording.flush()
    recording.disconnect()
