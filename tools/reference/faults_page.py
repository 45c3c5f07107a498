"""The controller's faults at a glance; the text is firmware/FAULTS.md."""

import re

from tools.reference.markdown import cell, code, page, table

_FAULT = re.compile(r"^## (\d+) (\w+)\n(.*)$", re.MULTILINE)
_SOURCE = "../../firmware/FAULTS.md"


def _part(text: str, name: str) -> str:
    match = re.search(rf"\*\*{name}\.\*\* (.*?)(?= \*\*[A-Z][\w ]*\.\*\*|$)", text)
    if match is None:
        raise ValueError(f"firmware/FAULTS.md: a fault without **{name}.**: {text[:60]!r}")
    return match[1]


def faults_page(text: str) -> str:
    rows = []
    for number, name, body in _FAULT.findall(text):
        link = f"[{code(name)}]({_SOURCE}#{number}-{name})"
        cause = re.split(r"(?<=\.) (?=[A-Z])", _part(body, "Cause"))[0].replace("`core/", "`firmware/core/")
        rows.append([number, link, cell(cause), cell(_part(body, "Safe state"))])
    more = "The first fault latches. What to check, how to cure each, and what the safe states do: follow the links.\n"
    return page("Faults of the controller", f"[firmware/FAULTS.md]({_SOURCE})", more,
                table(("number", "fault", "cause", "safe state"), rows))  # fmt: skip
