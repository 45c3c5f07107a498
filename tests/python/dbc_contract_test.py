"""What surefoot.dbc promises beside its bytes, and that cantools reads our frames with it."""

import binascii
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import cantools
import pytest

TREE = Path(__file__).resolve().parents[2]
DBC = TREE / "firmware" / "can" / "surefoot.dbc"
GOLDEN = TREE / "tests" / "unit" / "firmware_can" / "golden_frames.hpp"
FAULT_HPP = TREE / "firmware" / "core" / "safety" / "fault.hpp"
MESSAGES_HPP = TREE / "firmware" / "can" / "messages.hpp"

DATABASE = cantools.database.load_file(DBC)
MESSAGES = pytest.mark.parametrize("message", DATABASE.messages, ids=lambda message: message.name)


def golden_lines():
    """Every frame of the C++ golden tests, as candump -L prints it."""
    return re.findall(r'"([0-9A-F]{3}##1[0-9A-F]+)"', GOLDEN.read_text())


@MESSAGES
def test_every_message_is_can_fd_with_bit_rate_switch(message):
    assert message.is_fd
    assert message.dbc.attributes["VFrameFormat"].value == 14
    assert message.dbc.attributes["CANFD_BRS"].value in (1, "1")
    assert not message.is_extended_frame
    assert message.length in (*range(9), 12, 16, 20, 24, 32, 48, 64)


@MESSAGES
def test_every_message_has_crc_counter_and_tick_on_byte_boundaries(message):
    for name, bits in (("crc", 16), ("counter", 8)):
        signal = message.get_signal_by_name(name)
        assert signal.length == bits and signal.start % 8 == 0
    tick = message.get_signal_by_name("tick")
    assert tick.length == (32 if message.name in ("SYNC", "LOCKSTEP_SERVED") else 16)
    assert message.get_signal_by_name("crc").start in (0, 48)


@MESSAGES
def test_everything_is_described_little_endian_and_bounded_by_whole_steps(message):
    assert message.comment and len(message.senders) == 1
    for signal in message.signals:
        assert signal.comment and signal.byte_order == "little_endian"
        for bound in (signal.minimum, signal.maximum):
            steps = bound / signal.scale
            assert abs(steps - round(steps)) < 1e-6, f"{signal.name}: {bound} is no multiple of {signal.scale}"


def test_frames_of_one_kind_have_one_layout():
    """The firmware uses the generated code of one member for its whole family."""
    families = defaultdict(list)
    for message in DATABASE.messages:
        kind = re.sub(r"_(RIGHT|LEFT)$", "", message.name)
        kind = re.match(r"HEARTBEAT|EMERGENCY|.*", kind).group()
        layout = [
            (s.name, s.start, s.length, s.is_signed, s.scale, s.offset, s.minimum, s.maximum)
            for s in message.signals
            if s.name != "has_inertial_sensors"  # which only legs and feet may have; reserved and 0 elsewhere
        ]
        families[kind].append((message.length, layout))
    assert {kind: len(members) for kind, members in families.items()} == {
        "SYNC": 1, "EMERGENCY": 6, "LEG_STATE": 2, "FOOT_FORCE": 2, "IMU": 1, "LEG_COMMAND": 2, "HEARTBEAT": 6,
        "LOCKSTEP_SERVED": 1, "LEG_POSITION": 2, "LEG_INERTIAL": 2, "FOOT_INERTIAL": 2,
    }
    for kind, members in families.items():
        assert all(member == members[0] for member in members), kind


def test_version_is_the_protocol_version_of_the_firmware():
    in_firmware = re.search(r"kProtocolVersion = (\d+);", MESSAGES_HPP.read_text()).group(1)
    assert DATABASE.version == in_firmware


def test_the_controllers_emergency_names_every_fault_of_the_firmware():
    faults = re.findall(r"^  k(\w+) = (\d+),", FAULT_HPP.read_text(), re.MULTILINE)
    words = {int(number): re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower() for name, number in faults if name != "None"}
    code = DATABASE.get_message_by_name("EMERGENCY_CONTROLLER").get_signal_by_name("code")
    assert {int(key) - 0xFF00: str(word) for key, word in code.choices.items() if int(key) >= 0xFF00} == words


def test_golden_frames_cover_every_message_and_carry_the_crc_that_python_computes():
    seen = set()
    for line in golden_lines():
        identifier, payload = int(line[:3], 16), bytes.fromhex(line[6:])
        message = DATABASE.get_message_by_frame_id(identifier)
        values = message.decode(payload, decode_choices=False)
        at = message.get_signal_by_name("crc").start // 8
        covered = identifier.to_bytes(2, "little") + payload[:at] + payload[at + 2 :]
        assert values["crc"] == binascii.crc_hqx(covered, 0xFFFF), message.name
        seen.add(message.name)
    assert seen == {message.name for message in DATABASE.messages}


def test_cantools_decode_reads_every_message_of_a_candump_log():
    log = "".join(f"(0.{i:06}) vcan0 {line}\n" for i, line in enumerate(golden_lines()))
    command = [Path(sys.executable).parent / "cantools", "decode", "--single-line", DBC]
    decoded = subprocess.run(command, input=log, capture_output=True, text=True, check=True).stdout.splitlines()
    assert len(decoded) == len(DATABASE.messages)
    for line, message in zip(sorted(decoded), sorted(golden_lines())):
        assert re.search(r":: \w+\(", line), line
    names = {re.search(r":: (\w+)\(", line).group(1) for line in decoded}
    assert names == {message.name for message in DATABASE.messages}
