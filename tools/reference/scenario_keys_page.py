"""All keys of a scenario, as `surefoot keys` prints them."""

import re

from tools.reference.markdown import cell, code, page, table

_KEY = re.compile(r"  (\S+) +(choice|number|integer|boolean|array|text) +(\S.*)")
_VALUES = re.compile(r" {20,}(\S.*)")
_HEADER = ("key", "type", "meaning", "values")


def scenario_keys_page(printed: str) -> str:
    """A section a table of the scenario. Raises ValueError for a line that has another form."""
    parts: list[str] = []
    rows: list[list[str]] = []

    def end_table() -> None:
        if rows:
            parts.append(table(_HEADER, rows))
            rows.clear()

    for line in printed.splitlines():
        if match := _KEY.fullmatch(line):
            rows.append([code(match[1]), match[2], cell(match[3]), ""])
        elif rows and (match := _VALUES.fullmatch(line)):
            rows[-1][3] = " ".join(filter(None, [rows[-1][3], cell(match[1])]))
        elif line.startswith(" "):
            raise ValueError(f"surefoot keys printed a line of unknown form: {line!r}")
        elif line:
            end_table()
            match = re.fullmatch(r"(\[+[\w.]+\]+)(?:, (.*))?", line)
            parts.append(f"## {code(match[1])}\n" if match else cell(line) + "\n")
            if match and match[2]:
                parts.append(match[2][0].upper() + cell(match[2][1:]) + ".\n")
    end_table()
    return page("Scenario keys", "`surefoot keys`", *parts)
