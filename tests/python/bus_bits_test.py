"""The bus model's bit counts against a second opinion: every frame of a walk, written down bit by bit."""

import json
import subprocess
from pathlib import Path

import fd_bits
import pytest
from command_line import BAD_INPUT, SHORT, USAGE, assert_refused, surefoot
from fd_bits import Bits, Frame

LEFT_NODES = {2, 4}
EVERYBODYS = {0x080, 0x0FF, 0x77F}

# Identifier, payload, nominal and data bits: counted by hand in the C++ tests.
BY_HAND = [
    (0x080, "", 30, 33),
    (0x555, "55" * 8, 29, 33 + 64),
    (0x000, "00" * 8, 31, 33 + 64 + 13),
    (0x078, "", 32, 33),
    (0x555, "FF" * 64, 29, 38 + 512 + 103),
]


@pytest.mark.parametrize(
    ("kind", "check"),  # of "123456789"; the CAN FD ones start at 0 there
    [((15, 0x4599, 0), 0x059E), ((17, 0x1685B, 0), 0x04F03), ((21, 0x102899, 0), 0x0ED841)],
)
def test_the_checksums_are_those_of_the_catalogue(kind: tuple[int, int, int], check: int) -> None:
    """Greg Cook's catalogue of parametrised CRC algorithms: CRC-15/CAN, CRC-17/CAN-FD, CRC-21/CAN-FD."""
    bits = "".join(fd_bits.binary(byte, 8) for byte in b"123456789")
    assert int(fd_bits.crc(bits, kind), 2) == check


@pytest.mark.parametrize(("identifier", "payload", "nominal", "data"), BY_HAND)
def test_the_second_opinion_counts_as_one_does_by_hand(identifier: int, payload: str, nominal: int, data: int) -> None:
    assert fd_bits.fd_bits(Frame(identifier, bytes.fromhex(payload), True)) == Bits(nominal, data)


def counted(log: Path, travels: object = lambda identifier: True) -> tuple[int, Bits]:
    frames, total = 0, Bits(0, 0)
    for frame in fd_bits.read_candump(log):
        if travels(frame.identifier):
            frames += 1
            total += fd_bits.bits_of(frame)
    return frames, total


def assert_equal_to(traffic: dict, frames: int, bits: Bits) -> None:
    assert traffic["frames"] == frames
    assert (traffic["nominal_bits"], traffic["data_bits"]) == (bits.nominal, bits.data)
    assert traffic["busy_ns"] == bits.nominal * 1000 + bits.data * 200
    assert traffic["load_percent"] == 100.0 * traffic["busy_ns"] / traffic["elapsed_ns"]


def test_load_of_the_walking_bus_is_that_of_its_bits(short_run: Path) -> None:
    verdict = json.loads((short_run / "verdict.json").read_text())
    frames, bits = counted(short_run / "bus.log")
    assert frames > 50_000
    assert_equal_to(verdict["bus"][0], frames, bits)
    assert len(verdict["bus"]) == 1
    assert verdict["bus_load_percent"] == verdict["bus"][0]["load_percent"]


def test_load_of_two_buses_is_that_of_their_bits(tmp_path: Path) -> None:
    finished = surefoot("run", *SHORT, "--set", "bus.count=2", "--out", tmp_path / "run", "--json")
    assert finished.returncode == 0, finished.stderr
    verdict = json.loads(finished.stdout)

    def is_left(identifier: int) -> bool:
        return identifier & 0x7F in LEFT_NODES

    sides = [
        counted(tmp_path / "run" / "bus.log", lambda i: i in EVERYBODYS or not is_left(i)),
        counted(tmp_path / "run" / "bus.log", lambda i: i in EVERYBODYS or is_left(i)),
    ]
    for traffic, (frames, bits) in zip(verdict["bus"], sides, strict=True):
        assert_equal_to(traffic, frames, bits)
    assert verdict["bus_load_percent"] == max(traffic["load_percent"] for traffic in verdict["bus"])


def weigh(log: Path, *options: str) -> subprocess.CompletedProcess:
    return surefoot("bus", "--log", log, *options)


def test_a_log_is_weighed_as_the_run_was(short_run: Path) -> None:
    finished = weigh(short_run / "bus.log", "--json")
    assert finished.returncode == 0, finished.stderr
    load = json.loads(finished.stdout)["can0"]
    traffic = json.loads((short_run / "verdict.json").read_text())["bus"][0]
    assert load["fd_frames"] == traffic["frames"]
    for figure in ("nominal_bits", "data_bits", "busy_ns"):
        assert load[figure] == traffic[figure]


def test_classic_frames_of_several_interfaces_are_weighed(tmp_path: Path) -> None:
    frames = {"can0": [Frame(0x000, b"", False), Frame(0x7FF, b"\xff" * 8, False)], "can1": [Frame(9, b"\x12", False)]}
    lines = [
        f"({100 + number}.000000) {name} {frame.identifier:03X}#{frame.payload.hex().upper()}\n"
        for name, sent in frames.items()
        for number, frame in enumerate(sent)
    ]
    log = tmp_path / "classic.log"
    log.write_text("".join(lines))
    loads = json.loads(weigh(log, "--json", "--bitrate", "500000").stdout)
    for name, sent in frames.items():
        bits = sum((fd_bits.bits_of(frame) for frame in sent), Bits(0, 0))
        assert loads[name]["nominal_bits"] == bits.nominal
        assert loads[name]["busy_ns"] == bits.nominal * 2000
        assert loads[name]["classic_frames"] == len(sent)
    assert loads["can0"]["load_percent"] == 100.0 * loads["can0"]["busy_ns"] / 1e9
    assert loads["can1"]["load_percent"] == 0  # one frame: no time passed


def test_without_the_switch_an_fd_frame_is_slow_throughout(tmp_path: Path) -> None:
    log = tmp_path / "slow.log"
    log.write_text("(1.000000) can0 080##1\n(1.000000) can1 080##0\n(1.000000) can2 080##4\n")
    loads = json.loads(weigh(log, "--json").stdout)
    assert (loads["can0"]["nominal_bits"], loads["can0"]["data_bits"]) == (30, 33)
    assert (loads["can1"]["nominal_bits"], loads["can1"]["data_bits"]) == (63, 0)
    assert (loads["can2"]["nominal_bits"], loads["can2"]["data_bits"]) == (63, 0)


@pytest.mark.parametrize(
    "line",
    [
        "nonsense",
        "(1.000000) can0 00000123#11",
        "(1.000000) can0 800#11",
        "(1.000000) can0 123#112233445566778899",
        "(1.000000) can0 123#R9",
        "(1.000000) can0 123##",
        "(1.000000) can0 123##G",
        "(1.000000) can0 123#1",
        "#",
        "(1.0) ) #",
        "",
    ],
)
def test_a_line_that_is_no_such_frame_is_named(tmp_path: Path, line: str) -> None:
    log = tmp_path / "bad.log"
    log.write_text(f"(1.000000) can0 123#R8\n{line}\n")
    assert_refused(weigh(log), BAD_INPUT, f"{log}:2: ")


def test_a_log_that_cannot_be_read_is_named(tmp_path: Path) -> None:
    assert_refused(weigh(tmp_path / "none.log"), BAD_INPUT, tmp_path / "none.log")
    assert_refused(weigh(tmp_path), BAD_INPUT, tmp_path)


def test_a_bit_rate_that_no_bit_time_gives_is_usage(short_run: Path) -> None:
    for rate in ("3e6", "0", "-1", "fast", "nan"):
        assert_refused(weigh(short_run / "bus.log", "--bitrate", rate), USAGE, "surefoot bus")
