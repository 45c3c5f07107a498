"""What a document tells its reader to do, step by step, and what it says will be seen.

```sh blocks are commands, `# exit code N` beside one says how it ends (else 0). A ```text block is what the commands of
the block before it print, line by line: `…` stands for any characters, alone for any lines; spaces count as one; whole
numbers are exact, others may be off by 1 % or 0.02. A ```diff block is an edit; a ```python block that begins with
`# file: NAME` is a new file.
"""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

_BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_PIECE = re.compile(r"…|[+-]?\d+\.\d+(?![\d…])|[^\d.…+-]+|.")
_DECIMAL = re.compile(r"[+-]?\d+\.\d+")


@dataclass(frozen=True)
class Step:
    """A block of the document."""

    kind: str
    text: str


def steps(markdown: str) -> list[Step]:
    return [Step(kind, text) for kind, text in _BLOCK.findall(markdown) if kind in ("sh", "text", "diff", "python")]


def commands(block: str) -> list[str]:
    """A command goes on to the next line as long as the shell finds it incomplete."""
    found, pending = [], ""
    for line in block.splitlines():
        pending += line + "\n"
        if subprocess.run(["bash", "-n", "-c", pending], capture_output=True, check=False).returncode == 0:
            found.append(pending.rstrip("\n"))
            pending = ""
    assert not pending, f"an unfinished command: {pending}"
    return found


def expected_exit_code(command: str) -> int:
    said = re.search(r"# exit code (\d+)", command)
    return int(said[1]) if said else 0


def missing_line(claimed: str, printed: str) -> str | None:
    """The first line of a claim that what was printed does not bear out, in order; nothing where it does."""
    lines = [_squeezed(line) for line in printed.splitlines()]
    may_skip = False
    for claim in map(_squeezed, filter(str.strip, claimed.splitlines())):
        if claim == "…":
            may_skip = True
            continue
        at = next((at for at, line in enumerate(lines) if _agrees(claim, line)), None)
        if at is None or (at > 0 and not may_skip):
            return claim
        lines = lines[at + 1 :]
        may_skip = False
    return None


def write_file(top: Path, block: str) -> None:
    """A ```python block that names its file in its first line."""
    first, _, rest = block.partition("\n")
    name = first.removeprefix("# file: ")
    assert name != first, f"names no file: {first}"
    (top / name).write_text(rest)


def _squeezed(line: str) -> str:
    return " ".join(line.split())


def _agrees(claim: str, line: str) -> bool:
    """The claim as a pattern; decimals are compared as numbers."""
    pattern, values = "", []
    for piece in _PIECE.findall(claim):
        if _DECIMAL.fullmatch(piece):
            values.append(float(piece))
            pattern += rf"({_DECIMAL.pattern})"
        else:
            pattern += ".*" if piece == "…" else re.escape(piece)
    matched = re.fullmatch(pattern, line)
    return bool(matched) and all(
        abs(float(seen) - value) <= max(0.02, 0.01 * abs(value))
        for seen, value in zip(matched.groups(), values, strict=True)
    )
