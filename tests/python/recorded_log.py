"""Strict readers of a run folder: what cantools and PyPI's lcm read, and that there is nothing else in the files."""

from pathlib import Path

import cantools
import lcm
from cantools.logreader import Parser
from command_line import ROOT

_EVENT_HEADER_BYTES = 28  # sync word, event number, timestamp, two lengths


def count_frames(bus_log: Path) -> int:
    """Frames of a log that consists of whole lines, each of which decodes."""
    text = bus_log.read_text()
    assert text == "" or text.endswith("\n"), f"ends in a line: {text[-80:]!r}"
    database = cantools.database.load_file(ROOT / "firmware" / "can" / "surefoot.dbc")
    parser = Parser()
    lines = text.splitlines()
    for line in lines:
        frame = parser.parse(line)
        assert frame is not None, line
        database.decode_message(frame.frame_id, frame.data, decode_choices=False)
    return len(lines)


def count_events(telemetry_log: Path) -> int:
    """Events of a log that consists of whole events."""
    sizes = [
        _EVENT_HEADER_BYTES + len(event.channel) + len(event.data) for event in lcm.EventLog(str(telemetry_log), "r")
    ]
    assert sum(sizes) == telemetry_log.stat().st_size, "more in the file than whole events"
    return len(sizes)
