"""The telemetry's tables as pages know them: a column for each number of a message."""

import numpy as np

from tools.export.lcm_schema import Field, Schema
from tools.report.labels import label, unit

TABLES = {
    "SUREFOOT_STATE": "state",
    "SUREFOOT_TRUTH": "truth",
    "SUREFOOT_STABILIZER": "stabilizer",
    "SUREFOOT_BUS": "bus",
    "SUREFOOT_TIMING": "timing",
}


def value_fields(schema: Schema) -> list[Field]:
    """All fields but the clock, which tables have as their time."""
    return [field for field in schema.fields if field.name not in ("utime", "tick")]


def columns_of(schema: Schema) -> list[dict]:
    """Name, unit and label of each column, e.g. `joint_angle_rad[1][3]`, rad, left knee pitch."""
    return [
        {
            "name": field.name + "".join(f"[{i}]" for i in index), "unit": unit(field.name),
            "label": label(field.name, index, field.shape),
        }
        for field in value_fields(schema)
        for index in np.ndindex(field.shape)
    ]  # fmt: skip
