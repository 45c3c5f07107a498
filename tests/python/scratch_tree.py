"""A tree that looks like this one and may be written to: documented commands run in it as they stand."""

import os
import re
import shutil
import subprocess
from pathlib import Path

from command_line import ROOT, binary

_COPIED = ("firmware",)
_LEFT_OUT = ("build", "runs")


def make_scratch_tree(folder: Path) -> Path:
    """Links to this tree, the binary under test in build/release, no runs; firmware/ is a copy."""
    folder.mkdir()
    for entry in ROOT.iterdir():
        if entry.name in _COPIED:
            shutil.copytree(entry, folder / entry.name)
        elif entry.name not in _LEFT_OUT and (not entry.name.startswith(".") or entry.name == ".venv"):
            (folder / entry.name).symlink_to(entry)
    tools = folder / "build" / "release" / "tools"
    tools.mkdir(parents=True)
    (tools / "surefoot").symlink_to(binary())
    return folder


def shell(tree: Path, command: str) -> subprocess.CompletedProcess:
    """Runs a command line as somebody would who types it in the tree's top folder."""
    path = f"{tree / 'tools'}:{os.environ['PATH']}"  # the help of the binary says just `surefoot`
    return subprocess.run(
        ["bash", "-o", "pipefail", "-c", command], cwd=tree, env={**os.environ, "PATH": path}, capture_output=True,
        text=True, timeout=120, check=False,
    )  # fmt: skip


def code_lines(markdown: str) -> list[str]:
    """The lines of all fenced code blocks."""
    blocks = re.findall(r"^```\w*\n(.*?)^```$", markdown, re.MULTILINE | re.DOTALL)
    return [line for block in blocks for line in block.splitlines() if line.strip()]
