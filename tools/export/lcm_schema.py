"""The telemetry's types as lcm_types/*.lcm declare them: fields, constants and their comments."""

import re
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import numpy as np

SCHEMA_FOLDER = Path(__file__).resolve().parents[2] / "lcm_types"

# On the wire of LCM: https://lcm-proj.github.io/lcm/content/lcm-type-ref.html
_WIRE_TYPES = {
    "int8_t": "i1",
    "int16_t": ">i2",
    "int32_t": ">i4",
    "int64_t": ">i8",
    "float": ">f4",
    "double": ">f8",
    "byte": "u1",
    "boolean": "?",
}
FINGERPRINT_BYTES = 8

_PACKAGE = re.compile(r"package\s+(\w+);")
_STRUCT = re.compile(r"struct\s+(\w+)\s*\{")
_CONSTANTS = re.compile(r"const\s+(\w+)\s+([^;]+);")
_FIELD = re.compile(r"(\w+)\s+(\w+)((?:\[\d+\])*);")


@dataclass(frozen=True)
class Field:
    """A field as declared; `shape` is empty for a scalar."""

    name: str
    type: str
    shape: tuple[int, ...]
    comment: str


@dataclass(frozen=True)
class Constant:
    name: str
    type: str
    value: int
    comment: str  # of its line


@dataclass
class Schema:
    package: str
    name: str
    comment: str  # stands above the struct, a line each
    fields: list[Field] = field(default_factory=list)
    constants: list[Constant] = field(default_factory=list)

    @property
    def wire_dtype(self) -> np.dtype:
        """A whole message, fingerprint included: no type of ours has a field of varying length."""
        return np.dtype([("fingerprint", ">i8"), *((f.name, _WIRE_TYPES[f.type], f.shape) for f in self.fields)])


class SchemaError(Exception):
    """A declaration that this reader does not know."""


def parse(path: Path) -> Schema:
    """Reads the one struct of a file; raises SchemaError with file and line."""
    package, comments, schema = "", [], None
    for number, line in enumerate(path.read_text().splitlines(), 1):
        code, _, comment = (part.strip() for part in line.partition("//"))
        if not code:
            comments = [*comments, comment] if comment and schema is None else comments
        elif match := _PACKAGE.fullmatch(code):
            package = match[1]
        elif match := _STRUCT.fullmatch(code):
            schema = Schema(package, match[1], "\n".join(comments))
        elif schema and (match := _CONSTANTS.fullmatch(code)):
            for assignment in match[2].split(","):
                name, _, value = assignment.partition("=")
                schema.constants.append(Constant(name.strip(), match[1], int(value, 0), comment))
        elif schema and (match := _FIELD.fullmatch(code)) and match[1] in _WIRE_TYPES:
            shape = tuple(map(int, re.findall(r"\d+", match[3])))
            schema.fields.append(Field(match[2], match[1], shape, comment))
        elif code != "}":
            raise SchemaError(f"{path}:{number}: cannot be exported: {code}\n  remedy: declare fields of fixed size")
    if schema is None:
        raise SchemaError(f"{path}: declares no struct\n  remedy: one struct a file, as in {SCHEMA_FOLDER}")
    return schema


@cache
def schemas() -> dict[str, Schema]:
    """All types of the telemetry by name."""
    return {schema.name: schema for schema in map(parse, sorted(SCHEMA_FOLDER.glob("*.lcm")))}
