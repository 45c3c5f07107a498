"""A run as MCAP with protobuf messages: opens in Foxglove and PlotJuggler.

Times are nanoseconds since power-up, those of both logs; the scenario's time zero stands in the metadata record
"surefoot" and in every message's utime.
"""

from pathlib import Path

import cantools
import numpy as np
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory, timestamp_pb2
from mcap.well_known import MessageEncoding, SchemaEncoding
from mcap.writer import CompressionType, Writer

from tools.export.candump_log import Frames
from tools.export.lcm_log import Channel
from tools.export.progress import shown
from tools.export.protobuf_layout import encode, file_descriptor, tag, varint
from tools.export.run_files import DBC, RunFiles, body_poses

CAN_TOPIC, TRANSFORM_TOPIC = "/can", "/tf"
_TRANSFORM_EVERY = 10  # ticks: smooth to the eye
_Type = descriptor_pb2.FieldDescriptorProto
_DELIMITED, _VARINT = 2, 0

Stream = tuple[int, np.ndarray, list[bytes]]  # channel id, times in nanoseconds, messages


def can_descriptor() -> descriptor_pb2.FileDescriptorProto:
    """surefoot.can_frame: a frame as it was on the bus; its signals are in the DBC."""
    file = descriptor_pb2.FileDescriptorProto(name="can_frame.proto", package="surefoot", syntax="proto3")
    message = file.message_type.add(name="can_frame")
    fields = [("id", _Type.TYPE_UINT32), ("is_fd", _Type.TYPE_BOOL), ("flags", _Type.TYPE_UINT32)]
    fields += [("name", _Type.TYPE_STRING), ("bus", _Type.TYPE_STRING), ("data", _Type.TYPE_BYTES)]
    for number, (name, kind) in enumerate(fields, 1):
        message.field.add(name=name, number=number, type=kind, label=_Type.LABEL_OPTIONAL)
    return file


def transform_descriptor() -> descriptor_pb2.FileDescriptorProto:
    """foxglove.FrameTransforms, https://docs.foxglove.dev/docs/sdk/schemas/frame-transforms."""
    file = descriptor_pb2.FileDescriptorProto(name="foxglove/FrameTransforms.proto", package="foxglove")
    file.syntax = "proto3"
    file.dependency.append("google/protobuf/timestamp.proto")
    for name, axes in (("Vector3", "xyz"), ("Quaternion", "xyzw")):
        message = file.message_type.add(name=name)
        for number, axis in enumerate(axes, 1):
            message.field.add(name=axis, number=number, type=_Type.TYPE_DOUBLE, label=_Type.LABEL_OPTIONAL)
    transform = file.message_type.add(name="FrameTransform")
    fields = [("timestamp", ".google.protobuf.Timestamp"), ("parent_frame_id", None), ("child_frame_id", None)]
    fields += [("translation", ".foxglove.Vector3"), ("rotation", ".foxglove.Quaternion")]
    for number, (name, kind) in enumerate(fields, 1):
        added = transform.field.add(name=name, number=number, label=_Type.LABEL_OPTIONAL)
        added.type = _Type.TYPE_MESSAGE if kind else _Type.TYPE_STRING
        if kind:
            added.type_name = kind
    file.message_type.add(name="FrameTransforms").field.add(
        name="transforms", number=1, type=_Type.TYPE_MESSAGE, type_name=".foxglove.FrameTransform",
        label=_Type.LABEL_REPEATED,
    )  # fmt: skip
    return file


def _timestamp_descriptor() -> descriptor_pb2.FileDescriptorProto:
    file = descriptor_pb2.FileDescriptorProto()
    timestamp_pb2.DESCRIPTOR.CopyToProto(file)
    return file


def _register(writer: Writer, topic: str, name: str, *files: descriptor_pb2.FileDescriptorProto) -> int:
    data = descriptor_pb2.FileDescriptorSet(file=files).SerializeToString()
    schema = writer.register_schema(name, SchemaEncoding.Protobuf, data)
    return writer.register_channel(topic, MessageEncoding.Protobuf, schema)


def _encode_frames(frames: Frames) -> list[bytes]:
    names = {message.frame_id: message.name for message in cantools.database.load_file(DBC).messages}
    heads: dict[tuple, bytes] = {}
    encoded = []
    for *key, data in zip(
        frames.identifiers.tolist(), frames.is_fd.tolist(), frames.flags.tolist(), frames.buses, frames.data
    ):
        if (head := heads.get(tuple(key))) is None:
            identifier, is_fd, flags, bus = key
            head = b"".join(tag(n, _VARINT) + varint(value) for n, value in enumerate((identifier, is_fd, flags), 1))
            for number, text in ((4, names.get(identifier, "")), (5, bus)):
                head += tag(number, _DELIMITED) + varint(len(text.encode())) + text.encode()
            heads[tuple(key)] = head = head + tag(6, _DELIMITED)
        encoded.append(head + varint(len(data)) + data)
    return encoded


def _encode_transforms(truth: Channel, time_ns: np.ndarray) -> tuple[np.ndarray, list[bytes]]:
    pool = descriptor_pool.DescriptorPool()
    for file in (_timestamp_descriptor(), transform_descriptor()):
        pool.Add(file)
    make = message_factory.GetMessageClass(pool.FindMessageTypeByName("foxglove.FrameTransforms"))
    positions, quaternions = body_poses(truth)
    encoded, kept = [], slice(None, None, _TRANSFORM_EVERY)
    for time, position, quaternion in zip(time_ns[kept], positions[kept].tolist(), quaternions[kept].tolist()):
        message = make()
        transform = message.transforms.add(parent_frame_id="world", child_frame_id="body")
        transform.timestamp.seconds, transform.timestamp.nanos = divmod(int(time), 10**9)
        transform.translation.x, transform.translation.y, transform.translation.z = position
        rotation = transform.rotation
        rotation.x, rotation.y, rotation.z, rotation.w = quaternion
        encoded.append(message.SerializeToString())
    return time_ns[kept], encoded


def _streams(writer: Writer, run: RunFiles, shift_us: int) -> list[Stream]:
    streams: list[Stream] = []
    for channel in run.channels.values():
        schema = channel.schema
        identifier = _register(writer, channel.name, f"{schema.package}.{schema.name}", file_descriptor(schema))
        time_ns = (channel.recorded_us + shift_us) * 1000
        streams.append((identifier, time_ns, encode(schema, channel.rows)))
        if schema.name == "simulator_truth_t":
            files = _timestamp_descriptor(), transform_descriptor()
            identifier = _register(writer, TRANSFORM_TOPIC, "foxglove.FrameTransforms", *files)
            streams.append((identifier, *_encode_transforms(channel, time_ns)))
    if run.frames is not None and len(run.frames):
        identifier = _register(writer, CAN_TOPIC, "surefoot.can_frame", can_descriptor())
        streams.append((identifier, (run.frames.time_us + shift_us) * 1000, _encode_frames(run.frames)))
    return streams


def _write_messages(writer: Writer, streams: list[Stream]) -> None:
    """All streams as one, in order of time."""
    counts = [len(messages) for _, _, messages in streams]
    stream_of = np.repeat(np.arange(len(streams)), counts)
    place_of = np.concatenate([np.arange(count) for count in counts])
    times = np.concatenate([time_ns for _, time_ns, _ in streams])
    order = np.argsort(times, kind="stable")
    items = zip(stream_of[order].tolist(), place_of[order].tolist(), times[order].tolist())
    for stream, place, time in shown(items, len(order), "mcap"):
        identifier, _, messages = streams[stream]
        writer.add_message(identifier, time, messages[place], time, place)


def write_mcap(run: RunFiles, path: Path) -> None:
    """Writes the run as one file; a stored time that would be before power-up moves all of them to zero."""
    earliest = min(int(channel.recorded_us.min()) for channel in run.channels.values())
    shift_us = max(0, -earliest)
    with path.open("wb") as file:
        writer = Writer(file, compression=CompressionType.ZSTD)
        writer.start(profile="", library="surefoot export")
        about = {"run": run.folder.resolve().name, "scenario_zero_ns": str((run.scenario_zero_us + shift_us) * 1000)}
        about["verdict"] = run.verdict.get("verdict", "interrupted")
        about["reason"] = run.verdict.get("reason") or ""
        writer.add_metadata("surefoot", about)
        kinds = {"scenario.toml": "application/toml", "verdict.json": "application/json"}
        for name, text in run.texts.items():
            writer.add_attachment(0, 0, name, kinds[name], text.encode())
        if run.frames is not None and len(run.frames):
            writer.add_attachment(0, 0, DBC.name, "text/plain", DBC.read_bytes())
        _write_messages(writer, _streams(writer, run, shift_us))
        writer.finish()
