"""How far something is that takes long, for whoever waits at a terminal."""

import sys
import time


class Progress:
    """One line that overwrites itself; silent where standard error is no terminal."""

    def __init__(self, what: str) -> None:
        self._what = what
        self._started_s = time.monotonic()

    def show(self, done: int, of: int) -> None:
        if not sys.stderr.isatty() or of == 0:
            return
        elapsed_s = time.monotonic() - self._started_s
        left = f", {elapsed_s / done * (of - done):.0f} s left" if done else ""
        print(f"\r{self._what} {done} of {of}{left}\033[K", end="", file=sys.stderr, flush=True)

    def end(self) -> None:
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)
