"""Where the built program is, for Python commands that ask it."""

import os
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[1]


class MissingBinaryError(Exception):
    """There is no release build; the message names the remedy."""


def surefoot_binary() -> Path:
    """The release build, or what SUREFOOT_BINARY names. Raises MissingBinaryError where there is none."""
    binary = Path(os.environ.get("SUREFOOT_BINARY", _ROOT / "build" / "release" / "tools" / "surefoot"))
    if not os.access(binary, os.X_OK):
        raise MissingBinaryError(
            f"{binary}: is missing\n  remedy: cmake --preset release && cmake --build --preset release --target surefoot"
        )
    return binary
