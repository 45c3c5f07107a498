"""The CAN bus as firmware/can/surefoot.dbc declares it: a section a message."""

import re
from pathlib import Path

import cantools

from tools.reference.markdown import cell, code, page, table

_SIGNAL_HEADER = ("signal", "bits", "type", "scale", "range", "unit", "values", "meaning")


def _number(value: float) -> str:
    return f"{value:g}" if abs(value) < 1e15 and value != int(value) else str(int(value))


def _range(signal: cantools.database.Signal) -> str:
    if signal.minimum is None or signal.maximum is None:
        return ""
    return f"{_number(signal.minimum)} to {_number(signal.maximum)}"


def _type(signal: cantools.database.Signal) -> str:
    order = "" if signal.byte_order == "little_endian" else ", big-endian"
    return ("int" if signal.is_signed else "uint") + str(signal.length) + order


def _signal_row(signal: cantools.database.Signal) -> list[str]:
    scale = "" if signal.scale == 1 and signal.offset == 0 else _number(signal.scale)
    if signal.offset:
        scale += f" {signal.offset:+g}"
    choices = ", ".join(f"{value} {name}" for value, name in sorted((signal.choices or {}).items()))
    bits = f"{signal.start}–{signal.start + signal.length - 1}" if signal.length > 1 else str(signal.start)
    return [code(signal.name), bits, _type(signal), scale, _range(signal), cell(signal.unit or ""), cell(choices),
            cell(signal.comment or "")]  # fmt: skip


def _section(message: cantools.database.Message) -> str:
    facts = [f"identifier 0x{message.frame_id:03X}", f"{message.length} bytes", f"from {', '.join(message.senders)}"]
    receivers = sorted(message.receivers)
    if receivers:
        facts.append(f"to {', '.join(receivers)}")
    if message.cycle_time:
        facts.append(f"every {message.cycle_time} ms")
    rows = [_signal_row(signal) for signal in sorted(message.signals, key=lambda signal: signal.start)]
    used = [k for k in range(len(_SIGNAL_HEADER)) if any(row[k] for row in rows)]  # no empty columns
    signals = table([_SIGNAL_HEADER[k] for k in used], [[row[k] for k in used] for row in rows])
    return f"## {message.name}\n\n{'; '.join(facts)}.\n\n{cell(message.comment or '')}\n\n{signals}"


def can_page(dbc: Path) -> str:
    database = cantools.database.load_file(dbc)
    messages = sorted(database.messages, key=lambda message: message.frame_id)
    nodes = table(("node", "what it is"), ((code(n.name), cell(n.comment or "")) for n in database.nodes))
    overview = table(
        ("identifier", "message", "bytes", "sender", "period"),
        (
            (f"0x{m.frame_id:03X}", f"[{m.name}](#{m.name.lower()})", str(m.length), ", ".join(m.senders),
             f"{m.cycle_time} ms" if m.cycle_time else "on occasion")
            for m in messages
        ),
    )  # fmt: skip
    about = re.search(r'^CM_ "([^"]*)";', dbc.read_text(), re.MULTILINE)  # cantools keeps it to itself
    conventions = (
        "Bits count from bit 0 of byte 0, little-endian. A physical value is the raw integer times the scale, "
        "plus an offset where one is given. Periods are those of the default control period.\n"
    )
    sections = [_section(message) for message in messages]
    source = "[firmware/can/surefoot.dbc](../../firmware/can/surefoot.dbc)"
    return page("CAN messages", source, *([cell(about[1]) + "\n"] if about else []), conventions, "## Nodes\n", nodes,
                "## All messages\n", overview, *sections)  # fmt: skip
