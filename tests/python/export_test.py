"""Exports read back by other people's programs: nothing is lost, nothing is changed."""

import os
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import cantools
import lcm
import numpy as np
import pyarrow.csv
import pyarrow.parquet
import pytest
from command_line import BAD_INPUT, MACHINE_LACKS, ROOT, USAGE, assert_refused
from google.protobuf import descriptor_pb2, descriptor_pool, message_factory
from mcap.reader import make_reader

from tools.export.__main__ import main
from tools.export.lcm_schema import Schema, SchemaError, parse, schemas
from tools.export.protobuf_layout import encode, file_descriptor
from tools.plots.messages import message_types

_LINE = re.compile(r"\((\d+)\.(\d{6})\) (\w+) ([0-9A-F]+)#(?:#([0-9A-F]))?([0-9A-F]*)")


def _types() -> dict[bytes, type]:
    types = message_types()
    return {getattr(types, name)._get_packed_fingerprint(): getattr(types, name) for name in schemas()}


def _logged(folder: Path) -> dict[str, list]:
    """(time in microseconds, decoded message) by channel, by LCM's own reader and lcm-gen's classes."""
    types, channels = _types(), defaultdict(list)
    for record in lcm.EventLog(str(folder / "telemetry.lcmlog"), "r"):
        channels[record.channel].append((record.timestamp, types[record.data[:8]].decode(record.data)))
    return channels


def _frames(folder: Path) -> list[tuple]:
    """(time in microseconds, bus, identifier, FD flags or None, data) of bus.log."""
    lines = [_LINE.fullmatch(line) for line in (folder / "bus.log").read_text().splitlines()]
    return [
        (int(m[1] + m[2]), m[3], int(m[4], 16), None if m[5] is None else int(m[5], 16), bytes.fromhex(m[6]))
        for m in lines
    ]


def _message_class(name: str, descriptors: bytes) -> type:
    pool = descriptor_pool.DescriptorPool()
    for file in descriptor_pb2.FileDescriptorSet.FromString(descriptors).file:
        pool.Add(file)
    return message_factory.GetMessageClass(pool.FindMessageTypeByName(name))


def _read_mcap(path: Path) -> tuple[dict[str, list], dict]:
    """(log time, decoded message) by topic, ascending in the file; attachments and metadata."""
    topics, classes, latest = defaultdict(list), {}, 0
    with path.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        for schema, channel, message in reader.iter_messages(log_time_order=False):
            assert message.log_time >= latest
            latest = message.log_time
            if schema.id not in classes:
                classes[schema.id] = _message_class(schema.name, schema.data)
            topics[channel.topic].append((message.log_time, classes[schema.id].FromString(message.data)))
        extras = {attachment.name: attachment.data for attachment in reader.iter_attachments()}
        extras |= {record.name: record.metadata for record in reader.iter_metadata()}
    return topics, extras


def _plain(value):
    """A protobuf field as lcm-gen would give it: rows become lists, text a string."""
    if isinstance(value, (int, float, str, bool)):
        return value
    return [list(element.at) if hasattr(element, "at") else element for element in value]


def _as_logged(value):
    """A field of lcm-gen's class: bytes are text, filled up with zeros."""
    if isinstance(value, (bytes, bytearray)):
        return bytes(value).rstrip(b"\0").decode("ascii")
    if isinstance(value, (list, tuple)):
        return [list(element) if isinstance(element, (list, tuple)) else element for element in value]
    return value


def _assert_every_field_is_equal(protobuf, logged) -> None:
    for field in logged.__slots__:
        assert _plain(getattr(protobuf, field)) == _as_logged(getattr(logged, field)), field


@pytest.fixture(scope="module")
def mcap(short_run: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, list], dict]:
    path = tmp_path_factory.mktemp("mcap") / "run.mcap"
    assert main([str(short_run), "--to", "mcap", "--out", str(path)]) == 0
    return _read_mcap(path)


def test_the_mcap_holds_every_message_of_every_channel_with_equal_fields(mcap, short_run: Path):
    topics, _ = mcap
    logged = _logged(short_run)
    assert {"SUREFOOT_STATE", "SUREFOOT_TRUTH", "SUREFOOT_BUS", "SUREFOOT_EVENT"} <= set(logged)
    assert set(topics) == {*logged, "/can", "/tf"}
    for channel, messages in logged.items():
        assert [time_ns for time_ns, _ in topics[channel]] == [1000 * time_us for time_us, _ in messages]
        for (_, protobuf), (_, message) in zip(topics[channel], messages):
            _assert_every_field_is_equal(protobuf, message)


def test_the_mcap_holds_every_frame_of_the_bus_log_in_its_order(mcap, short_run: Path):
    names = {m.frame_id: m.name for m in cantools.database.load_file(ROOT / "firmware/can/surefoot.dbc").messages}
    frames = _frames(short_run)
    assert len(mcap[0]["/can"]) == len(frames) > 0
    for (time_ns, message), (time_us, bus, identifier, flags, data) in zip(mcap[0]["/can"], frames):
        assert time_ns == 1000 * time_us
        assert (message.id, message.bus, message.data, message.name) == (identifier, bus, data, names[identifier])
        assert (message.is_fd, message.flags) == (flags is not None, flags or 0)


def test_the_mcap_carries_scenario_verdict_dbc_and_time_zero(mcap, short_run: Path):
    topics, extras = mcap
    assert extras["scenario.toml"] == (short_run / "scenario.toml").read_bytes()
    assert extras["verdict.json"] == (short_run / "verdict.json").read_bytes()
    assert extras["surefoot.dbc"] == (ROOT / "firmware/can/surefoot.dbc").read_bytes()
    zero_ns = int(extras["surefoot"]["scenario_zero_ns"])
    assert zero_ns > 0
    for messages in (topics["SUREFOOT_STATE"], topics["SUREFOOT_TRUTH"], topics["SUREFOOT_EVENT"]):
        assert all(time_ns - zero_ns == 1000 * message.utime for time_ns, message in messages)


def test_the_transform_turns_the_body_as_the_angles_say(mcap):
    truth = {time_ns: message for time_ns, message in mcap[0]["SUREFOOT_TRUTH"]}
    for time_ns, message in mcap[0]["/tf"]:
        (transform,) = message.transforms
        at, q, row = transform.translation, transform.rotation, truth[time_ns]
        assert [at.x, at.y, at.z] == list(row.body_position_world_m)
        # Columns of the rotation matrix give back yaw, pitch, roll of z-y-x.
        assert np.arctan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y**2 + q.z**2)) == pytest.approx(row.yaw_rad)
        assert np.arcsin(2 * (q.w * q.y - q.z * q.x)) == pytest.approx(row.pitch_rad)
        assert np.arctan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x**2 + q.y**2)) == pytest.approx(row.roll_rad)


@pytest.mark.parametrize("name", sorted(schemas()))
def test_every_type_survives_protobuf_with_its_extreme_values(name: str):
    schema = schemas()[name]
    rows = np.zeros(3, schema.wire_dtype)
    for row, byte in enumerate((b"\x00", b"\x7f", b"\x80")):  # zeros, large and negative numbers
        for field in schema.fields:
            item = schema.wire_dtype[field.name]
            if field.type == "byte":
                rows[field.name][row] = np.frombuffer(b"abc".ljust(item.itemsize, b"\0"), np.uint8)
            elif field.type == "boolean":
                rows[field.name][row] = byte != b"\x00"
            else:
                rows[field.name][row] = np.frombuffer(byte * item.itemsize, item.base).reshape(item.shape)
    files = descriptor_pb2.FileDescriptorSet(file=[file_descriptor(schema)]).SerializeToString()
    kind = _message_class(f"{schema.package}.{schema.name}", files)
    generated = _types()[getattr(message_types(), name)._get_packed_fingerprint()]
    for row, data in zip(rows, encode(schema, rows)):
        wire = generated._get_packed_fingerprint() + row.tobytes()[8:]
        _assert_every_field_is_equal(kind.FromString(data), generated.decode(wire))


def test_every_constant_is_in_the_descriptor():
    for schema in schemas().values():
        (message,) = file_descriptor(schema).message_type
        values = {value.name: value.number for enum in message.enum_type for value in enum.value}
        assert {c.name: c.value for c in schema.constants}.items() <= values.items()
        generated = getattr(message_types(), schema.name)
        assert all(getattr(generated, c.name) == c.value for c in schema.constants)


def _column(messages: list, column: str) -> np.ndarray:
    name, *indices = re.findall(r"\w+", column)
    values = [getattr(message, name) for message in messages]
    if isinstance(values[0], (bytes, bytearray)):
        return np.array([_as_logged(value) for value in values])
    return np.array(values)[(slice(None), *map(int, indices))]


@pytest.fixture(scope="module")
def parquet(short_run: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, pyarrow.Table]:
    folder = tmp_path_factory.mktemp("parquet")
    assert main([str(short_run), "--to", "parquet", "--out", str(folder)]) == 0
    return {path.stem: pyarrow.parquet.read_table(path) for path in folder.iterdir()}


def test_parquet_tables_hold_every_field_of_every_message(parquet, short_run: Path):
    tables = {channel.removeprefix("SUREFOOT_").lower(): messages for channel, messages in _logged(short_run).items()}
    tables["events"] = tables.pop("event")
    for name, timed in tables.items():
        messages = [message for _, message in timed]
        for column in parquet[name].column_names:
            values = parquet[name][column].to_numpy()
            expected = _column(messages, "utime") / 1e6 if column == "time_s" else _column(messages, column)
            assert np.array_equal(values, expected), (name, column)


def test_csv_tables_are_those_of_parquet(parquet, short_run: Path, tmp_path: Path):
    assert main([str(short_run), "--to", "csv", "--out", str(tmp_path)]) == 0
    assert {path.stem for path in tmp_path.iterdir()} == set(parquet)
    for name, table in parquet.items():
        types = pyarrow.csv.ConvertOptions(column_types=table.schema)
        read = pyarrow.csv.read_csv(tmp_path / f"{name}.csv", convert_options=types)
        assert read.equals(table.replace_schema_metadata(None)), name


def test_decoded_frames_are_those_of_cantools(parquet, short_run: Path):
    database = cantools.database.load_file(ROOT / "firmware/can/surefoot.dbc")
    by_message = defaultdict(list)
    for _, _, identifier, _, data in _frames(short_run):
        by_message[identifier].append(data)
    for identifier, frames in by_message.items():
        message = database.get_message_by_frame_id(identifier)
        columns = parquet[f"can_{message.name.lower()}"].to_pydict()
        assert {len(values) for values in columns.values()} == {len(frames)}
        for row in range(0, len(frames), 211):
            for signal, value in message.decode(frames[row], decode_choices=False).items():
                assert columns[signal][row] == pytest.approx(value, abs=1e-12), (message.name, signal)


def test_rerun_opens_the_recording(short_run: Path, tmp_path: Path):
    pytest.importorskip("rerun", reason="rerun-sdk is for tests only: tools/setup --tests")
    path = tmp_path / "run.rrd"
    assert main([str(short_run), "--to", "rerun", "--out", str(path)]) == 0
    environment = os.environ | {"HOME": str(tmp_path), "XDG_CONFIG_HOME": str(tmp_path)}

    def rerun(*arguments: object) -> str:
        command = [Path(sys.executable).parent / "rerun", *map(str, arguments)]
        done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60, env=environment)
        return done.stdout

    rerun("analytics", "disable")  # else the program reports on its use
    rerun("rrd", "verify", path)
    printed = rerun("rrd", "print", path)
    for entity in ("/state/joint_angle_rad", "/truth/roll_rad", "/events", "/world/body"):
        assert entity in printed


def test_an_interrupted_run_exports_what_there_is(short_run: Path, tmp_path: Path):
    broken = tmp_path / "broken"
    broken.mkdir()
    log = (short_run / "telemetry.lcmlog").read_bytes()
    (broken / "telemetry.lcmlog").write_bytes(log[: len(log) // 8 + 13])
    frames = (short_run / "bus.log").read_bytes()
    (broken / "bus.log").write_bytes(frames[: frames.index(b"\n", len(frames) // 8) + 20])
    assert main([str(broken), "--to", "mcap"]) == 0
    topics, extras = _read_mcap(broken / "run.mcap")
    assert extras["surefoot"]["verdict"] == "interrupted"
    assert len(topics["/can"]) == (broken / "bus.log").read_bytes().count(b"\n")
    assert sum(map(len, topics.values())) == len(topics["/can"]) + len(topics["/tf"]) + sum(
        map(len, _logged(broken).values())
    )


def test_a_run_without_a_bus_log_and_no_can_export_the_telemetry(synthetic_run: Path, short_run: Path, tmp_path: Path):
    for folder, arguments in ((synthetic_run, []), (short_run, ["--no-can"])):
        path = tmp_path / "run.mcap"
        assert main([str(folder), "--to", "mcap", "--out", str(path), *arguments]) == 0
        topics, _ = _read_mcap(path)
        assert "/can" not in topics and len(topics["SUREFOOT_STATE"]) == len(_logged(folder)["SUREFOOT_STATE"])
        assert min(time_ns for time_ns, _ in topics["SUREFOOT_STATE"]) >= 0


def _export(*arguments: object, **options) -> subprocess.CompletedProcess:
    command = [sys.executable, "-m", "tools.export", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, check=False, timeout=60, cwd=ROOT, **options)


def test_bad_input_is_refused_with_a_remedy_and_leaves_no_file(short_run: Path, tmp_path: Path):
    assert_refused(_export(tmp_path, "--to", "mcap"), BAD_INPUT, "export: ", tmp_path / "telemetry.lcmlog")
    (tmp_path / "telemetry.lcmlog").write_bytes(b"")
    assert_refused(_export(tmp_path, "--to", "csv"), BAD_INPUT, "export: ", "holds no message")
    (tmp_path / "telemetry.lcmlog").write_bytes(b"no log " * 10)
    assert_refused(_export(tmp_path, "--to", "rerun"), BAD_INPUT, "export: ", "at byte 0")
    log = bytearray((short_run / "telemetry.lcmlog").read_bytes())
    log[28 + len("SUREFOOT_STATE")] ^= 1
    (tmp_path / "telemetry.lcmlog").write_bytes(log)
    assert_refused(_export(tmp_path, "--to", "mcap"), BAD_INPUT, "export: ", "lcm_types/ of this tree")
    shutil.copy(short_run / "telemetry.lcmlog", tmp_path)
    (tmp_path / "bus.log").write_text("(0000000000.000000) can0 080##1BF\nnonsense\n")
    assert_refused(_export(tmp_path, "--to", "mcap"), BAD_INPUT, "export: ", "bus.log:2:", "--no-can")
    (tmp_path / "bus.log").unlink()
    assert_refused(_export(tmp_path, "--to", "mcap", "--out", tmp_path / "none" / "x"), MACHINE_LACKS, "export: ")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["telemetry.lcmlog"]
    assert _export(short_run, "--to", "matlab").returncode == USAGE


def test_without_rerun_sdk_the_remedy_names_the_pinned_version(short_run: Path, tmp_path: Path):
    (tmp_path / "rerun.py").write_text("raise ImportError\n")
    environment = os.environ | {"PYTHONPATH": f"{tmp_path}:{ROOT}"}
    finished = _export(short_run, "--to", "rerun", "--out", tmp_path / "run.rrd", env=environment)
    assert_refused(finished, MACHINE_LACKS, "export: ", "pip install rerun-sdk==")


def test_a_type_that_cannot_be_exported_is_refused_with_its_line(tmp_path: Path):
    path = tmp_path / "bad_t.lcm"
    path.write_text("package surefoot;\nstruct bad_t {\n  string name;\n}\n")
    with pytest.raises(SchemaError, match="bad_t.lcm:3: "):
        parse(path)


def test_the_parser_reads_names_shapes_comments_and_constants():
    state: Schema = schemas()["controller_state_t"]
    fields = {field.name: field for field in state.fields}
    assert fields["joint_angle_rad"].shape == (2, 6) and fields["joint_angle_rad"].comment == "measured"
    assert {c.name: c.value for c in state.constants}["PHASE_STOPPED"] == 7
    assert state.comment.startswith("One tick of the controller")
