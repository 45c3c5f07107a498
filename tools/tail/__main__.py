"""surefoot tail: see --help."""

import argparse
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import lcm

from tools.arguments import Parser
from tools.plots.messages import LIVE_URL, MissingGeneratorError, message_types
from tools.tail.event_line import event_line

_CHANNEL = "SUREFOOT_EVENT"
_BAD_INPUT, _MACHINE_LACKS, _INTERRUPTED = 65, 69, 130
_LISTEN_MS = 200  # how soon an interrupt is heard


def _arguments(given: list[str]) -> argparse.Namespace:
    parser = Parser(
        prog="surefoot tail",
        description="Prints a run's events: of a recorded run, or as they come over LCM until Ctrl-C.",
        epilog="Exit codes: 0, 64 usage, 65 no run there, 69 something the machine lacks, 130 interrupted.\n"
        "Examples:\n"
        "  tools/surefoot tail runs/demo\n"
        "  tools/surefoot tail & tools/surefoot run --live --pace 1\n"
        "  tools/surefoot tail runs/demo --json | grep payload",
    )
    parser.add_argument("run", type=Path, metavar="RUN", nargs="?", help="run folder, or an LCM event log; default: live")
    parser.add_argument("--url", default=LIVE_URL, help="where to listen (default: where `surefoot run --live` publishes)")
    parser.add_argument("--count", type=int, metavar="N", help="end after so many events")
    parser.add_argument("--json", action="store_true", help="a JSON object a line: time_s, name, value")
    return parser.parse_args(given)


def _recorded(log: Path) -> Iterator[bytes]:
    return (event.data for event in lcm.EventLog(str(log), "r") if event.channel == _CHANNEL)


def _live(url: str) -> Iterator[bytes]:
    bus, heard = lcm.LCM(url), []
    bus.subscribe(_CHANNEL, lambda _, encoded: heard.append(encoded))
    bus.handle_timeout(1)
    print(f"tail: listening on {url}", file=sys.stderr, flush=True)
    while True:
        bus.handle_timeout(_LISTEN_MS)
        yield from heard
        heard.clear()


def _print(encoded: bytes, is_json: bool) -> None:
    event = message_types().event_t.decode(encoded)
    name = bytes(event.name).split(b"\0")[0].decode("ascii", "replace")
    time_s = event.utime / 1e6
    line = (
        json.dumps({"time_s": time_s, "name": name, "value": event.value})
        if is_json
        else event_line(time_s, name, event.value, sys.stdout.isatty())
    )
    print(line, flush=True)


def main(given: list[str]) -> int:
    """Returns the exit code."""
    arguments = _arguments(given)
    log = arguments.run
    if log is not None and log.is_dir():
        log = log / "telemetry.lcmlog"
    if log is not None and not log.is_file():
        print(f"{log}: no such file\n  remedy: give a folder that `tools/surefoot run --out` wrote", file=sys.stderr)
        return _BAD_INPUT
    try:
        for number, encoded in enumerate(_recorded(log) if log else _live(arguments.url), 1):
            _print(encoded, arguments.json)
            if number == arguments.count:
                break
    except ValueError:
        print(f"{log or arguments.url}: events of another version of Surefoot\n  remedy: use the version that wrote them",
              file=sys.stderr)  # fmt: skip
        return _BAD_INPUT
    except (MissingGeneratorError, RuntimeError, OSError) as error:
        print(f"tail: {error}\n  remedy: see tools/surefoot doctor, section multicast", file=sys.stderr)
        return _MACHINE_LACKS
    except KeyboardInterrupt:
        return _INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
