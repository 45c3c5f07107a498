"""A line on the terminal for work that takes longer than two seconds."""

import sys
import time
from collections.abc import Iterable, Iterator
from typing import TypeVar

Item = TypeVar("Item")

_QUIET_S, _EVERY_S, _LOOK_EVERY = 2.0, 0.5, 4096


def shown(items: Iterable[Item], count: int, what: str) -> Iterator[Item]:
    """The same items; says on a terminal's standard error how far they are and how long it will take."""
    begun = said = time.monotonic()
    is_shown = False
    for done, item in enumerate(items):
        yield item
        if done % _LOOK_EVERY or not sys.stderr.isatty():
            continue
        now = time.monotonic()
        if now - begun > _QUIET_S and now - said > _EVERY_S:
            left_s = (now - begun) * (count - done) / (done + 1)
            print(f"\r{what}: {100 * done // count} %, {left_s:.0f} s left ", end="", file=sys.stderr, flush=True)
            said, is_shown = now, True
    if is_shown:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
