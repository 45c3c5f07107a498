"""What is heard goes to every open page: rows at the rate of pictures, events and verdict as they come."""

import json
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from tornado.websocket import WebSocketClosedError, WebSocketHandler

from tools.plots.read_run import RunFolderError
from tools.report.scenario_view import scenario_text
from tools.watch.listener import Heard, Listener
from tools.watch.live_run import MOST_EVENTS, Announcement, LiveRun, rows

_SILENT_S = 2.5  # announcements come every second
_VERDICT_EVERY_S = 0.3


class Page(WebSocketHandler):
    """One open page. A slow one gets fewer rows, never fewer events."""

    def initialize(self, feed: "Feed") -> None:
        self._feed = feed
        self._pending = None
        self._waiting: dict[int, bytes] = {}

    def open(self) -> None:
        self.set_nodelay(True)
        self._feed.add(self)

    def on_close(self) -> None:
        self._feed.pages.discard(self)

    def on_message(self, message: str | bytes) -> None:
        """Pages have nothing to say."""

    def tell(self, message: dict) -> None:
        self._send(json.dumps(message, allow_nan=False), is_binary=False)

    def begin(self, message: dict) -> None:
        """A run; rows of the one before that still wait are forgotten."""
        self._waiting.clear()
        self.tell(message)

    def show(self, newest: dict[int, bytes]) -> None:
        """Rows by their table; while the page has not taken the last ones, newer ones replace those that wait."""
        self._waiting.update(newest)
        if self._pending is not None and not self._pending.done():
            return
        for row in self._waiting.values():
            self._pending = self._send(row, is_binary=True)
        self._waiting.clear()

    def _send(self, message: str | bytes, is_binary: bool):
        try:
            return self.write_message(message, binary=is_binary)
        except WebSocketClosedError:
            return None


@dataclass
class _Other:
    """A run that goes on beside the one shown."""

    is_half: bool  # firmware and robot in two processes announce a folder each, with one scenario
    events: list[bytes] = field(default_factory=list)  # since the run shown was last heard of: no longer its own


class Feed:
    """Passes on what a listener hears. `say` gets a line a run, for the terminal.

    Messages do not say which run they are of, so the page stays with one until it has ended or fallen silent.
    """

    def __init__(self, listener: Listener, binary: Path, say: Callable[[str], None]) -> None:
        self._listener = listener
        self._binary = binary
        self._say = say
        self._run: LiveRun | None = None
        self._shown: set[Announcement] = set()
        self._others: dict[Announcement, _Other] = {}
        self._verdict_asked_s = 0.0
        self.pages: set[Page] = set()

    def add(self, page: Page) -> None:
        self.pages.add(page)
        if self._run is not None:
            page.begin(self._run.message())

    def step(self) -> None:
        """Once a picture."""
        heard = self._listener.take()
        before = self._run
        if (encoded := heard.newest.get("SUREFOOT_RUN")) is not None and (announced := Announcement.of(encoded)):
            self._hear_of(announced)
        for other in self._others.values():
            other.events.extend(heard.events[: MOST_EVENTS - len(other.events)])
        if self._run is None:
            return
        # Rows that came together with the first word of a run may be of the one before.
        self._pass_on(heard if self._run is before else Heard(events=heard.events))
        self._ask_for_verdict()

    def _pass_on(self, heard: Heard) -> None:
        for encoded in heard.events:
            self._tell(self._run.add_event(encoded))
        if self.pages:
            newest = rows(heard.newest)
            for page in self.pages:
                page.show(newest)

    def _hear_of(self, announced: Announcement) -> None:
        if self._run is not None and announced == self._run.announced:
            self._run.heard_at_s = time.monotonic()
            for other in self._others.values():
                other.events.clear()
        elif announced not in self._shown:
            if self._may_begin(announced):
                self._begin(announced)
            elif announced not in self._others:
                self._others[announced] = self._judged(announced)

    def _may_begin(self, announced: Announcement) -> bool:
        if self._run is None or announced.folder == self._run.announced.folder:
            return True
        self._tell(self._run.verdict_message())
        if self._run.verdict is not None:
            return announced not in self._others or not self._others[announced].is_half
        return time.monotonic() - self._run.heard_at_s > _SILENT_S

    def _judged(self, announced: Announcement) -> _Other:
        is_half = scenario_text(announced.folder) == self._run.described["scenario_toml"]
        if not is_half:
            self._say(
                f"watch: {announced.folder} is going on beside {self._run.announced.folder}: their values cannot be told\n"
                "  apart, and the page shows both as one; end one of them"
            )
        return _Other(is_half)

    def _begin(self, announced: Announcement) -> None:
        self._shown.add(announced)
        run = LiveRun(announced, self._binary)
        other = self._others.pop(announced, _Other(is_half=False))
        try:
            described = run.described
        except RunFolderError as error:
            self._say(str(error))
            return
        for encoded in other.events:
            run.add_event(encoded)
        self._run = run
        self._say(f"watch: {described['name']}")
        for page in set(self.pages):
            page.begin(run.message())

    def _ask_for_verdict(self) -> None:
        now_s = time.monotonic()
        if now_s - self._verdict_asked_s < _VERDICT_EVERY_S:
            return
        self._verdict_asked_s = now_s
        self._tell(self._run.verdict_message())

    def _tell(self, message: dict | None) -> None:
        for page in set(self.pages) if message else ():
            page.tell(message)
