"""LCM types as protobuf: descriptors made at run time, and whole columns of messages encoded at once.

Integers become sfixed32 and sfixed64 and every field is written, also a zero one. So all messages of a type have
one layout, and encoding is an assignment between numpy structures. Fields "one of PREFIX_*" become enums.
"""

import re
from dataclasses import dataclass

import numpy as np
from google.protobuf import descriptor_pb2

from tools.export.lcm_schema import Field, Schema

_Type = descriptor_pb2.FieldDescriptorProto
_VARINT, _FIXED64, _DELIMITED, _FIXED32 = 0, 1, 2, 5

# LCM type: protobuf type, wire type, numpy type.
_TYPES = {
    "int8_t": (_Type.TYPE_SFIXED32, _FIXED32, "<i4"),
    "int16_t": (_Type.TYPE_SFIXED32, _FIXED32, "<i4"),
    "int32_t": (_Type.TYPE_SFIXED32, _FIXED32, "<i4"),
    "int64_t": (_Type.TYPE_SFIXED64, _FIXED64, "<i8"),
    "float": (_Type.TYPE_FLOAT, _FIXED32, "<f4"),
    "double": (_Type.TYPE_DOUBLE, _FIXED64, "<f8"),
    "boolean": (_Type.TYPE_BOOL, _VARINT, "u1"),
}
_LONGEST_VARINT = 10  # of 64 bits, seven a byte; an enum is always written so long


def varint(value: int) -> bytes:
    """A non-negative number as protobuf's variable length integer."""
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*out, value])


def tag(number: int, wire_type: int) -> bytes:
    return varint(number << 3 | wire_type)


def is_text(field: Field) -> bool:
    """Bytes are text, filled up with zeros."""
    return field.type == "byte"


def _enum_name(field: Field) -> str | None:
    if "one of the constants below" in field.comment:
        return "Constant"
    match = re.search(r"one of (\w+)_\*", field.comment)
    return match[1].capitalize() if match else None


def _add_enums(message: descriptor_pb2.DescriptorProto, schema: Schema) -> None:
    """An enum for every prefix that a field names, and one for the other constants."""
    prefixes = [name for field in schema.fields if (name := _enum_name(field)) and name != "Constant"]
    groups: dict[str, dict[str, int]] = {}
    for constant in schema.constants:
        prefix = next((p for p in prefixes if constant.name.startswith(p.upper() + "_")), "Constant")
        groups.setdefault(prefix, {})[constant.name] = constant.value
    for name, values in groups.items():
        enum = message.enum_type.add(name=name)
        if 0 not in values.values():
            values = {f"{name.upper()}_UNSPECIFIED": 0, **values}
        if len(set(values.values())) < len(values):
            enum.options.allow_alias = True
        for value_name, value in sorted(values.items(), key=lambda item: item[1] != 0):  # proto3: zero comes first
            enum.value.add(name=value_name, number=value)


def file_descriptor(schema: Schema) -> descriptor_pb2.FileDescriptorProto:
    """The type as a proto3 file. A two-dimensional field is a repeated row: `joint_angle_rad[0].at[3]`."""
    file = descriptor_pb2.FileDescriptorProto(name=f"{schema.name}.proto", package=schema.package, syntax="proto3")
    message = file.message_type.add(name=schema.name)
    _add_enums(message, schema)
    scope = f".{schema.package}.{schema.name}"
    for number, field in enumerate(schema.fields, 1):
        added = message.field.add(name=field.name, number=number)
        repeated = bool(field.shape) and not is_text(field)
        added.label = _Type.LABEL_REPEATED if repeated else _Type.LABEL_OPTIONAL
        if is_text(field):
            added.type = _Type.TYPE_STRING
        elif len(field.shape) == 2:
            added.type, row = _Type.TYPE_MESSAGE, f"{field.type.removesuffix('_t').capitalize()}Row"
            added.type_name = f"{scope}.{row}"
            if all(nested.name != row for nested in message.nested_type):
                message.nested_type.add(name=row).field.add(
                    name="at", number=1, type=_TYPES[field.type][0], label=_Type.LABEL_REPEATED
                )
        elif not field.shape and (enum := _enum_name(field)):
            added.type, added.type_name = _Type.TYPE_ENUM, f"{scope}.{enum}"
        else:
            added.type = _TYPES[field.type][0]
    return file


@dataclass
class _Layout:
    """Bytes that are the same in all messages, with places for the values."""

    fixed: bytes
    names: list[str]
    formats: list
    offsets: list[int]

    def place(self, name: str, dtype: np.dtype) -> None:
        self.names.append(name)
        self.formats.append(dtype)
        self.offsets.append(len(self.fixed))
        self.fixed += bytes(dtype.itemsize)


def _place(layout: _Layout, number: int, field: Field) -> None:
    _, wire_type, code = _TYPES[field.type]
    packed = np.dtype((code, field.shape[-1:]))
    if not field.shape and _enum_name(field):
        layout.fixed += tag(number, _VARINT)
        layout.place(field.name, np.dtype(("u1", _LONGEST_VARINT)))
    elif not field.shape:
        layout.fixed += tag(number, wire_type)
        layout.place(field.name, np.dtype(code))
    elif len(field.shape) == 1:
        layout.fixed += tag(number, _DELIMITED) + varint(packed.itemsize)
        layout.place(field.name, packed)
    else:
        inner = tag(1, _DELIMITED) + varint(packed.itemsize)
        for row in range(field.shape[0]):
            layout.fixed += tag(number, _DELIMITED) + varint(len(inner) + packed.itemsize) + inner
            layout.place(f"{field.name}[{row}]", packed)


def _long_varints(values: np.ndarray) -> np.ndarray:
    signed = values.astype(np.int64)
    digits = np.stack([(signed >> (7 * k)) & 0x7F for k in range(_LONGEST_VARINT)], axis=-1).astype(np.uint8)
    digits[:, -1] &= 1
    digits[:, :-1] |= 0x80
    return digits


def encode(schema: Schema, rows: np.ndarray) -> list[bytes]:
    """One protobuf message a row of the LCM log."""
    layout = _Layout(b"", [], [], [])
    numbered = list(enumerate(schema.fields, 1))
    for number, field in numbered:
        if not is_text(field):
            _place(layout, number, field)
    size = len(layout.fixed)
    wire = np.tile(np.frombuffer(layout.fixed, np.uint8), len(rows)).view(
        np.dtype({"names": layout.names, "formats": layout.formats, "offsets": layout.offsets, "itemsize": size})
    )
    for _, field in numbered:
        if is_text(field):
            continue
        if not field.shape and _enum_name(field):
            wire[field.name] = _long_varints(rows[field.name])
        elif len(field.shape) == 2:
            for row in range(field.shape[0]):
                wire[f"{field.name}[{row}]"] = rows[field.name][:, row]
        else:
            wire[field.name] = rows[field.name]
    data = wire.tobytes()
    messages = [data[at : at + size] for at in range(0, len(data), size)]
    for number, field in numbered:
        if is_text(field):
            for k, value in enumerate(rows[field.name]):
                text = value.tobytes().rstrip(b"\0").decode("ascii", "replace").encode()
                messages[k] += tag(number, _DELIMITED) + varint(len(text)) + text
    return messages
