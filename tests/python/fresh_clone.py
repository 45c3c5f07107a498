"""A fresh clone of this tree to type commands in, cheap to build: in a mount namespace it lies where this tree lies, so
that the compiler's cache knows its files, and it uses this tree's Python environment, read-only."""

import os
import shutil
import subprocess
from pathlib import Path

from command_line import ROOT

# In the namespace nobody else sees these mounts, and they end with the command.
_IN_PLACE_OF_THE_TREE = """\
set -e
tree="$1" clone="$2"
mount --bind "$tree/.venv" "$clone/.venv"
mount -o remount,bind,ro "$clone/.venv"
mount --bind "$tree/.cache" "$clone/.cache"
mount --rbind "$clone" "$tree"
cd "$tree"
exec bash -o pipefail -c "$3"
"""
_PATIENCE_S = 590  # less than CTest's, so that what was printed is shown


def clone_of_tree(folder: Path) -> Path:
    """`git clone`, and in it what the next commit would bring: files changed here, new ones, none that are gone."""
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(folder)], check=True, capture_output=True, text=True)
    listed = ["git", "-C", str(ROOT), "ls-files", "-z", "--modified", "--others", "--exclude-standard"]
    names = subprocess.run(listed, check=True, capture_output=True, text=True).stdout
    for name in filter(None, names.split("\0")):
        source, target = ROOT / name, folder / name
        if source.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)
        else:
            target.unlink(missing_ok=True)
    return folder


class Terminal:
    """Runs command lines in the clone's top folder, as somebody who has just cloned it."""

    def __init__(self, clone: Path, shares_with_tree: bool) -> None:
        self.clone = clone
        self._shares_with_tree = shares_with_tree
        if shares_with_tree:
            for folder in (ROOT / ".cache", clone / ".cache", clone / ".venv"):
                folder.mkdir(exist_ok=True)

    def type(self, command: str) -> subprocess.CompletedProcess:
        """One command line; what it prints on both channels is in `stdout`, in order."""
        return subprocess.run(
            self._wrapped(command), cwd=self.clone, env=self._environment(), text=True, timeout=_PATIENCE_S,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
        )  # fmt: skip

    def _wrapped(self, command: str) -> list[str]:
        if not self._shares_with_tree:
            return ["bash", "-o", "pipefail", "-c", command]
        unshare = ["unshare", "-m"] if os.geteuid() == 0 else ["unshare", "-rm"]
        return [*unshare, "bash", "-c", _IN_PLACE_OF_THE_TREE, "bash", str(ROOT), str(self.clone), command]

    @staticmethod
    def _environment() -> dict[str, str]:
        return {name: value for name, value in os.environ.items() if not name.startswith(("SUREFOOT_", "PYTHONPATH"))}
