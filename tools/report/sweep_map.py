"""The results of a sweep as what the map page reads."""

import csv
import math
from pathlib import Path

from tools.plots.read_run import RunFolderError

RESULTS = "results.csv"
_FIRST_LINE = 2  # of the file; rows count from 0
_TEXTS = ("outcome", "reason", "command")


def is_sweep(folder: Path) -> bool:
    """Whether `surefoot sweep --out` wrote the folder."""
    return (folder / RESULTS).is_file()


def _value(text: str) -> float | int | str | None:
    """A number where it is one, nothing for nan, else the text: lists, names, switches."""
    for read in (int, float):
        try:
            number = read(text)
            return number if math.isfinite(number) else None
        except (ValueError, OverflowError):
            continue
    return text


def read_results(folder: Path) -> tuple[list[str], list[dict]]:
    """Names of the varied keys, and the rows by column.

    Raises RunFolderError where results.csv is none of a sweep.
    """
    file = folder / RESULTS
    try:
        with file.open(newline="", encoding="utf-8") as lines:
            reader = csv.DictReader(lines, strict=True)
            columns = list(reader.fieldnames or [])
            if columns[:1] != ["row"] or not set(_TEXTS) <= set(columns):
                raise ValueError("has other columns than those of a sweep")
            rows = [_row(line, number) for number, line in enumerate(reader, _FIRST_LINE)]
        if not rows:
            raise ValueError("holds no row")
    except (ValueError, csv.Error) as error:
        raise RunFolderError(f"{file}: {error}\n  remedy: run the sweep again with --out {folder}") from error
    return columns[1 : columns.index("outcome")], rows


def _row(line: dict, number: int) -> dict:
    if None in line or None in line.values():
        raise ValueError(f"line {number} has not as many fields as the head")
    # It names a folder below this one, so nothing but the row's own number may stand there.
    if line["row"] != str(number - _FIRST_LINE):
        raise ValueError(f"line {number} is row {line['row'][:20]!r} instead of {number - _FIRST_LINE}")
    return {name: text if name in _TEXTS else _value(text) for name, text in line.items()}


def map_index(title: str, keys: list[str], rows: list[dict], reports: dict[int, str]) -> dict:
    """The page's index. `reports`: where the run of a row opens, as seen from the page."""
    figures = [
        name
        for name in rows[0]
        if name not in (*keys, *_TEXTS, "row") and any(isinstance(row[name], int | float) for row in rows)
    ]
    return {
        "format": 1, "mode": "map", "title": title, "keys": keys, "figures": figures,
        "rows": [{**row, "report": reports.get(row["row"])} for row in rows],
    }  # fmt: skip
