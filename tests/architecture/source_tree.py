"""The tree's own source files."""

from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_ROOMS = ("firmware", "sim_hw", "lcm_types", "tools", "tests", "examples")
_NOT_OURS = {"generated", "__pycache__", "build"}
CPP_SUFFIXES = {".hpp", ".cpp", ".h", ".c"}


def files_below(folder: str) -> Iterator[Path]:
    """Files written by hand, as paths from the tree's root."""
    for path in sorted((ROOT / folder).rglob("*")):
        relative = path.relative_to(ROOT)
        if path.is_file() and not _NOT_OURS & set(relative.parts):
            yield relative


def all_files() -> Iterator[Path]:
    for room in _ROOMS:
        yield from files_below(room)
