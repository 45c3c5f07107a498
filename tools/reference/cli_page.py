"""Every command of `surefoot`, as its --help prints it."""

import os
import re
import subprocess
import sys
from pathlib import Path

from tools.reference.markdown import page

_COLUMNS = "100"  # of Python's help, whatever the terminal


def run(root: Path, *command: object) -> str:
    """What a command prints, in words that do not depend on the machine."""
    environment = os.environ | {"COLUMNS": _COLUMNS, "PYTHONPATH": str(root), "LC_ALL": "C.UTF-8"}
    finished = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, check=True, cwd=root, env=environment
    )
    return finished.stdout


def _binary_commands(help_text: str) -> list[str]:
    listed = help_text.split("Subcommands:\n", 1)[1].split("\n\n", 1)[0]
    return re.findall(r"^  ([\w-]+) ", listed, re.MULTILINE)


def _python_commands(dispatcher: str) -> list[tuple[str, str]]:
    """Command and module of every case of tools/surefoot that runs Python."""
    return re.findall(r"^  ([\w-]+)\) shift; in_python (tools\.\w+)", dispatcher, re.MULTILINE)


def _section(title: str, text: str) -> str:
    return f"## {title}\n\n```text\n{text.strip()}\n```\n"


def cli_page(root: Path, binary: Path) -> str:
    commands = [_section("surefoot", run(root, root / "tools" / "surefoot", "--help"))]
    named = {name: (binary, name) for name in _binary_commands(run(root, binary, "--help"))}
    dispatcher = (root / "tools" / "surefoot").read_text()
    named |= {name: (sys.executable, "-m", module) for name, module in _python_commands(dispatcher)}
    for name, command in sorted(named.items()):
        commands.append(_section(f"surefoot {name}", run(root, *command, "--help")))
    return page("Command line", "`surefoot COMMAND --help`", *commands)
