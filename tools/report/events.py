"""Events as pages know them."""

import math


def event(utime_us: int, code: int, name: bytes, value: float) -> dict:
    """Of the fields of an event_t. A value that is no number is none: JSON has no word for it."""
    return {
        "time_s": utime_us / 1e6, "code": code, "value": value if math.isfinite(value) else None,
        "name": bytes(name).split(b"\0")[0].decode("ascii", "replace"),
    }  # fmt: skip
