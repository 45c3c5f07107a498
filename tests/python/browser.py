"""A headless browser: what a page asks for from outside, or complains of, is kept."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from playwright.sync_api import Page, sync_playwright

# Without a graphics card the scene is drawn by the processor.
_ARGUMENTS = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
_DEADLINE_MS = 60_000


@dataclass
class Opened:
    """A page, and what went wrong on it."""

    page: Page
    complaints: list[str] = field(default_factory=list)
    asked_for: list[str] = field(default_factory=list)

    def open_file(self, file: Path) -> None:
        """Opens a report and waits until it is ready."""
        self.page.goto(file.resolve().as_uri())
        self.page.evaluate("() => window.surefoot.ready")

    def set_time(self, time_s: float) -> None:
        self.page.evaluate("time_s => window.surefoot.setTime(time_s)", time_s)

    def pose(self) -> dict:
        """What the scene draws now."""
        return self.page.evaluate("() => window.surefoot.scenePose()")


def _opened(page: Page) -> Opened:
    opened = Opened(page)
    page.set_default_timeout(_DEADLINE_MS)
    page.on("console", lambda said: said.type in ("error", "warning") and opened.complaints.append(said.text))
    page.on("pageerror", lambda error: opened.complaints.append(str(error)))
    page.on(
        "request",
        lambda request: request.url.startswith(("file:", "data:", "blob:")) or opened.asked_for.append(request.url),
    )
    return opened


@contextmanager
def browser() -> Iterator[Callable[[], Opened]]:
    """What opens fresh pages; skips where there is no browser. One at a time in a process."""
    program = shutil.which("chromium")
    if program is None:
        pytest.skip("chromium is not installed; tools/setup --tests installs it")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=program, args=_ARGUMENTS)
        yield lambda **options: _opened(chromium.new_page(viewport={"width": 1500, "height": 950}, **options))
        chromium.close()
