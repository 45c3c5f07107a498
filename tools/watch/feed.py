"""What is heard goes to every open page: rows at the rate of pictures, events and verdict as they come."""

import json
import time
from pathlib import Path

from tornado.websocket import WebSocketClosedError, WebSocketHandler

from tools.plots.read_run import RunFolderError
from tools.report.scenario_view import scenario_text
from tools.watch.listener import Heard, Listener
from tools.watch.live_run import Announcement, LiveRun, rows

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


class Feed:
    """Passes on what a listener hears. `say` gets a line a run, for the terminal."""

    def __init__(self, listener: Listener, binary: Path, say) -> None:
        self._listener = listener
        self._binary = binary
        self._say = say
        self._run: LiveRun | None = None
        self._shown: set[Announcement] = set()
        self._verdict_asked_s = 0.0
        self.pages: set[Page] = set()

    def add(self, page: Page) -> None:
        self.pages.add(page)
        if self._run is not None:
            page.tell(self._run.message())

    def step(self) -> None:
        """Once a picture."""
        heard = self._listener.take()
        announced = heard.newest.get("SUREFOOT_RUN")
        if announced is not None and (announcement := Announcement.of(announced)) is not None:
            self._hear_of(announcement)
        if self._run is None:
            return
        self._pass_on(heard)
        self._ask_for_verdict()

    def _pass_on(self, heard: Heard) -> None:
        for encoded in heard.events:
            self._tell(self._run.add_event(encoded))
        if self.pages:
            newest = rows(heard.newest)
            for page in self.pages:
                page.show(newest)

    def _hear_of(self, announced: Announcement) -> None:
        """A run that nobody has heard of takes the page, unless it is the other half of one in two processes."""
        now_s = time.monotonic()
        if self._run is not None and announced == self._run.announced:
            self._run.heard_at_s = now_s
        elif announced not in self._shown and not self._is_other_half(announced, now_s):
            self._begin(LiveRun(announced, self._binary))

    def _is_other_half(self, announced: Announcement, now_s: float) -> bool:
        """Firmware and robot in two processes announce a folder each, with one scenario."""
        if self._run is None or self._run.verdict is not None or now_s - self._run.heard_at_s > _SILENT_S:
            return False
        return scenario_text(announced.folder) == self._run.described["scenario_toml"]

    def _begin(self, run: LiveRun) -> None:
        self._shown.add(run.announced)
        try:
            message = run.message()
        except RunFolderError as error:
            self._say(str(error))
            return
        self._run = run
        self._say(f"watch: {run.announced.folder}")
        self._tell(message)

    def _ask_for_verdict(self) -> None:
        now_s = time.monotonic()
        if now_s - self._verdict_asked_s < _VERDICT_EVERY_S:
            return
        self._verdict_asked_s = now_s
        self._tell(self._run.verdict_message())

    def _tell(self, message: dict | None) -> None:
        for page in set(self.pages) if message else ():
            page.tell(message)
