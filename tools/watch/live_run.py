"""A run that is going on, as the page gets it: what it is, its rows, its events, and at its end the verdict."""

import time
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import numpy as np

from tools.export.lcm_schema import Schema, schemas
from tools.plots.messages import message_types
from tools.plots.read_run import RunFolderError
from tools.report.columns import TABLES, columns_of, value_fields
from tools.report.events import event
from tools.report.scenario_view import fault_help, read_verdict, scenario_view

_TYPES = {
    "SUREFOOT_STATE": "controller_state_t",
    "SUREFOOT_TRUTH": "simulator_truth_t",
    "SUREFOOT_STABILIZER": "stabilizer_t",
    "SUREFOOT_BUS": "bus_statistics_t",
    "SUREFOOT_TIMING": "timing_statistics_t",
}
_CHANNELS = list(TABLES)
MOST_EVENTS = 1000


def _decoded(name: str, encoded: bytes) -> object | None:
    """A message; nothing where it is of another type, of another version, or cut short."""
    kind = getattr(message_types(), name)
    is_whole = len(encoded) == schemas()[name].wire_dtype.itemsize and encoded[:8] == kind._get_packed_fingerprint()
    return kind.decode(encoded) if is_whole else None


def _text(characters: bytes) -> str:
    return bytes(characters).split(b"\0")[0].decode("utf-8", "replace")


@dataclass(frozen=True)
class Announcement:
    """Who publishes, of a message on SUREFOOT_RUN."""

    folder: Path
    started_ns: int

    @staticmethod
    def of(encoded: bytes) -> "Announcement | None":
        """Nothing of another version, or where the path was too long to be told."""
        message = _decoded("run_t", encoded)
        folder = Path(_text(message.folder)) if message else Path()
        return Announcement(folder, message.started_ns) if folder.is_absolute() else None


@dataclass
class LiveRun:
    """One run, from its first announcement on."""

    announced: Announcement
    binary: Path
    events: list[dict] = field(default_factory=list)
    verdict: dict | None = None
    heard_at_s: float = field(default_factory=time.monotonic)

    @cached_property
    def described(self) -> dict:
        """What it is. Raises RunFolderError where its scenario.toml is damaged."""
        folder = self.announced.folder
        types = schemas()
        return {
            "name": str(folder), "fault_help": fault_help(), "frames": None, "verdict": None,
            **scenario_view(folder, self.binary, None),
            "tables": [{"name": TABLES[channel], "columns": columns_of(types[_TYPES[channel]])} for channel in _CHANNELS],
        }  # fmt: skip

    def message(self) -> dict:
        """All that a page needs which joins now."""
        return {"what": "run", "run": {**self.described, "events": self.events, "verdict": self.verdict}}

    def add_event(self, encoded: bytes) -> dict | None:
        """The message for the page; nothing beyond the first thousand, and of what is no event."""
        message = _decoded("event_t", encoded)
        if message is None or len(self.events) >= MOST_EVENTS:
            return None
        told = event(message.utime, message.code, message.name, message.value)
        self.events.append(told)
        return {"what": "event", "event": told}

    def verdict_message(self) -> dict | None:
        """Once, when the run has ended and said how; a damaged one counts as none."""
        if self.verdict is not None:
            return None
        try:
            self.verdict = read_verdict(self.announced.folder)
        except RunFolderError:
            return None
        return self.verdict and {"what": "verdict", "verdict": self.verdict}


def rows(newest: dict[str, bytes]) -> dict[int, bytes]:
    """By its table's place, of each channel a row: that place, time in s, then its columns, as float64.

    Messages of another version are left out.
    """
    types = schemas()
    found = {
        place: _row(place, types[_TYPES[channel]], newest[channel])
        for place, channel in enumerate(_CHANNELS)
        if channel in newest
    }
    return {place: row for place, row in found.items() if row is not None}


def _row(place: int, schema: Schema, encoded: bytes) -> bytes | None:
    if len(encoded) != schema.wire_dtype.itemsize:
        return None
    if encoded[:8] != getattr(message_types(), schema.name)._get_packed_fingerprint():
        return None
    message = np.frombuffer(encoded, schema.wire_dtype)[0]
    values = [np.ravel(message[described.name]).astype("<f8") for described in value_fields(schema)]
    head = np.array([place, message["utime"] / 1e6], "<f8")
    return np.concatenate([head, *values]).tobytes()
