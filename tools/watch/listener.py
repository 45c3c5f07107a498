"""The newest message of each channel, without keeping up with all of them."""

import time
from dataclasses import dataclass, field

import lcm

_PATTERN = "SUREFOOT_(STATE|TRUTH|STABILIZER|BUS|TIMING)"
_RUN = "SUREFOOT_RUN"
_EVENTS = "SUREFOOT_EVENT"
_MOST_WAITING = 1000  # LCM drops what comes beyond: a flood shows rows that are a few milliseconds old
_MOST_EVENTS = 4096
_MOST_DRAIN_S = 0.008  # half a picture: a flood must not stop the pages


@dataclass
class Heard:
    """Since it was last asked: the newest message by channel, and all events, in their order."""

    newest: dict[str, bytes] = field(default_factory=dict)
    events: list[bytes] = field(default_factory=list)


class Listener:
    """Hears telemetry on an LCM URL. Raises RuntimeError where LCM cannot listen."""

    def __init__(self, url: str) -> None:
        self._bus = lcm.LCM(url)
        self._heard = Heard()
        self._bus.subscribe(_PATTERN, self._keep).set_queue_capacity(_MOST_WAITING)
        # Of their own, for a flood of states must not crowd them out.
        self._bus.subscribe(_RUN, self._keep)
        self._bus.subscribe(_EVENTS, lambda _, encoded: self._heard.events.append(encoded)).set_queue_capacity(_MOST_EVENTS)

    def _keep(self, channel: str, encoded: bytes) -> None:
        self._heard.newest[channel] = encoded

    def take(self) -> Heard:
        """What came since the last call; never waits."""
        until_s = time.monotonic() + _MOST_DRAIN_S
        while self._bus.handle_timeout(0) and time.monotonic() < until_s:
            pass
        heard, self._heard = self._heard, Heard()
        return heard
