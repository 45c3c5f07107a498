"""Bits of CAN frames, built field by field from ISO 11898-1:2015 and counted: our own second opinion.

Nothing here is shared with the C++ model: every bit of a frame is written down, CRC and stuff bits included.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_LENGTHS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 20, 24, 32, 48, 64]
_CRC_15 = (15, 0x4599, 0)
_CRC_17 = (17, 0x1685B, 1 << 16)  # width, polynomial, start value (a leading one)
_CRC_21 = (21, 0x102899, 1 << 20)
_AFTER_CRC_DELIMITER = 1 + 1 + 7 + 3  # ACK slot and delimiter, end of frame, intermission


@dataclass(frozen=True)
class Frame:
    identifier: int
    payload: bytes
    is_fd: bool


@dataclass(frozen=True)
class Bits:
    nominal: int
    data: int

    def __add__(self, other: "Bits") -> "Bits":
        return Bits(self.nominal + other.nominal, self.data + other.data)


def binary(value: int, width: int) -> str:
    return format(value, f"0{width}b")


def crc(bits: str, kind: tuple[int, int, int]) -> str:
    width, polynomial, register = kind
    for bit in bits:
        top = register >> (width - 1)
        register = (register << 1) & ((1 << width) - 1)
        if top ^ int(bit):
            register ^= polynomial
    return binary(register, width)


def stuffed(bits: str, stuffs_last: bool) -> Iterator[tuple[str, bool]]:
    """Each bit on the wire, and whether it is a stuff bit: the complement after each five equal ones."""
    wire = ""
    for place, bit in enumerate(bits):
        wire += bit
        yield bit, False
        is_last = place + 1 == len(bits)
        if wire[-5:] in ("00000", "11111") and (stuffs_last or not is_last):
            wire += "1" if bit == "0" else "0"
            yield wire[-1], True


def classic_bits(frame: Frame) -> Bits:
    length = len(frame.payload)
    covered = "0" + binary(frame.identifier, 11) + "000" + binary(length, 4)  # SOF, identifier, RTR IDE r0, DLC
    covered += "".join(binary(byte, 8) for byte in frame.payload)
    wire = list(stuffed(covered + crc(covered, _CRC_15), stuffs_last=True))
    return Bits(len(wire) + 1 + _AFTER_CRC_DELIMITER, 0)


def fd_bits(frame: Frame) -> Bits:
    length = len(frame.payload)
    to_brs = "0" + binary(frame.identifier, 11) + "0" + "0" + "1" + "0" + "1"  # SOF, identifier, RRS IDE FDF res BRS
    rest = "0" + binary(_LENGTHS.index(length), 4)  # ESI, DLC
    rest += "".join(binary(byte, 8) for byte in frame.payload)
    wire = list(stuffed(to_brs + rest, stuffs_last=False))

    nominal, sent = "", 0
    for bit, is_stuff_bit in wire:  # BRS is 1 after a 0: no stuff bit follows it
        if sent == len(to_brs):
            break
        nominal += bit
        sent += not is_stuff_bit
    data = "".join(bit for bit, _ in wire)[len(nominal) :]

    count = sum(is_stuff_bit for _, is_stuff_bit in wire) % 8
    gray = binary(count ^ (count >> 1), 3)
    stuff_count = gray + str(gray.count("1") % 2)
    kind = _CRC_17 if length <= 16 else _CRC_21
    # The CRC covers the stuff bits and the stuff count, but none of the fixed stuff bits.
    field = stuff_count + crc(nominal + data + stuff_count, kind)
    last = (nominal + data)[-1]
    for place in range(0, len(field), 4):  # a fixed stuff bit ahead of each four bits: the complement of the bit before
        last = "1" if last == "0" else "0"
        group = field[place : place + 4]
        data += last + group
        last = group[-1]
    data += "1"  # CRC delimiter
    return Bits(len(nominal) + _AFTER_CRC_DELIMITER, len(data))


def bits_of(frame: Frame) -> Bits:
    return fd_bits(frame) if frame.is_fd else classic_bits(frame)


def read_candump(log: Path) -> Iterator[Frame]:
    """Frames of a `candump -L` log: data frames with 11-bit identifiers, FD ones with bit rate switch."""
    for line in log.read_text().splitlines():
        _, _, text = line.split()
        identifier, payload = text.split("#", 1)
        is_fd = payload.startswith("#")
        assert len(identifier) == 3, line
        assert not is_fd or int(payload[1], 16) & 1, line
        yield Frame(int(identifier, 16), bytes.fromhex(payload[2:] if is_fd else payload), is_fd)
