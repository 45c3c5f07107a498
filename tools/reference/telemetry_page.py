"""The LCM channels as lcm_types/*.lcm declare them: a section a type."""

import re

from tools.export.lcm_schema import Field, Schema, schemas
from tools.reference.markdown import cell, code, page, table
from tools.report.labels import unit


def _row(field: Field) -> list[str]:
    shape = "".join(f"[{n}]" for n in field.shape)
    return [code(field.name), code(field.type + shape), unit(field.name), cell(field.comment)]


def _section(schema: Schema) -> str:
    text = f"## {schema.name}\n\n{cell(schema.comment)}\n\n"
    text += table(("field", "type", "unit", "meaning"), map(_row, schema.fields))
    if schema.constants:
        rows = ([code(c.name), str(c.value), cell(c.comment)] for c in schema.constants)
        text += "\n" + table(("constant", "value", "meaning"), rows)
    return text


def telemetry_page() -> str:
    def channel(schema: Schema) -> str:
        match = re.search(r"Channel (\w+)", schema.comment)
        return code(match[1]) if match else ""

    overview = table(
        ("channel", "type", "what"),
        ([channel(s), f"[{s.name}](#{s.name})", cell(s.comment.split(". ")[0])] for s in schemas().values()),
    )
    source = "[lcm_types/](../../lcm_types/)"
    return page("Telemetry", source, overview, *map(_section, schemas().values()))
