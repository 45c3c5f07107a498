"""A headless browser: what a page asks for beyond what it may, or complains of, is refused and kept."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Page, Route, sync_playwright

# Without a graphics card all is drawn by the processor; plots are faster without its pretending to be one.
_ARGUMENTS = [
    "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
    "--disable-accelerated-2d-canvas",
]  # fmt: skip
_DEADLINE_MS = 60_000


@dataclass
class Opened:
    """A page, and what went wrong on it."""

    page: Page
    complaints: list[str] = field(default_factory=list)
    asked_for: list[str] = field(default_factory=list)

    def open_file(self, file: Path) -> None:
        """Opens a page of a file and waits until it is ready."""
        self.open(file.resolve().as_uri())

    def open(self, address: str) -> None:
        self.page.goto(address)
        self.page.evaluate("() => window.surefoot.ready")

    def set_time(self, time_s: float) -> None:
        self.page.evaluate("time_s => window.surefoot.setTime(time_s)", time_s)

    def pose(self) -> dict:
        """What the scene draws now."""
        return self.page.evaluate("() => window.surefoot.scenePose()")


def _opened(page: Page, may_ask: tuple[str, ...]) -> Opened:
    opened = Opened(page)

    def refuse(route: Route) -> None:
        if route.request.url.startswith(("file:", "data:", "blob:", *may_ask)):
            route.continue_()
            return
        opened.asked_for.append(route.request.url)
        route.abort()

    page.set_default_timeout(_DEADLINE_MS)
    page.route("**/*", refuse)
    page.on("console", lambda said: said.type in ("error", "warning") and opened.complaints.append(said.text))
    page.on("pageerror", lambda error: opened.complaints.append(str(error)))
    return opened


@contextmanager
def browser(may_ask: tuple[str, ...] = ()) -> Iterator[Callable[..., Opened]]:
    """What opens fresh pages; skips where there is no browser. One at a time in a process.

    At its end no page may have complained, nor asked for anything but files and addresses that begin with `may_ask`.
    """
    program = shutil.which("chromium")
    if program is None:
        pytest.skip("chromium is not installed; tools/setup --tests installs it")
    pages: list[Opened] = []

    def new_page(**options: object) -> Opened:
        pages.append(_opened(chromium.new_page(viewport={"width": 1500, "height": 950}, **options), may_ask))
        return pages[-1]

    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=program, args=_ARGUMENTS)
        yield new_page
        chromium.close()
    assert [page.complaints for page in pages if page.complaints] == []
    assert [page.asked_for for page in pages if page.asked_for] == []
