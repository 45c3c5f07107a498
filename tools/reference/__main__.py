"""`python -m tools.reference [--check]`: writes the pages of docs/reference/ anew."""

import argparse
import difflib
import os
import subprocess
import sys
from pathlib import Path

from tools.reference.can_page import can_page
from tools.reference.cli_page import cli_page, run
from tools.reference.faults_page import faults_page
from tools.reference.scenario_keys_page import scenario_keys_page
from tools.reference.telemetry_page import telemetry_page

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "reference"

_EXIT_STALE, _EXIT_LACKS = 1, 69


def binary() -> Path:
    """The program that is asked for its keys and its help."""
    return Path(os.environ.get("SUREFOOT_BINARY", ROOT / "build" / "release" / "tools" / "surefoot"))


def pages() -> dict[str, str]:
    """Every page by its file name."""
    return {
        "can.md": can_page(ROOT / "firmware" / "can" / "surefoot.dbc"),
        "telemetry.md": telemetry_page(),
        "scenario_keys.md": scenario_keys_page(run(ROOT, binary(), "keys")),
        "faults.md": faults_page((ROOT / "firmware" / "FAULTS.md").read_text()),
        "cli.md": cli_page(ROOT, binary()),
    }


def _difference(name: str, fresh: str) -> str:
    path = FOLDER / name
    old = path.read_text().splitlines() if path.is_file() else []
    return "\n".join(difflib.unified_diff(old, fresh.splitlines(), f"docs/reference/{name}", "generated", lineterm=""))


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m tools.reference", description="Writes docs/reference/ anew.")
    parser.add_argument("--check", action="store_true", help="write nothing; where stale: difference, exit code 1")
    options = parser.parse_args(arguments)
    try:
        fresh = pages()
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"reference: {error}\n  remedy: run tools/demo, which builds the release", file=sys.stderr)
        return _EXIT_LACKS
    stale = {name: difference for name, text in fresh.items() if (difference := _difference(name, text))}
    if options.check:
        print("\n".join(stale.values()), end="\n" if stale else "")
        if stale:
            print("reference: stale\n  remedy: run .venv/bin/python -m tools.reference", file=sys.stderr)
        return _EXIT_STALE if stale else 0
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name in stale:
        (FOLDER / name).write_text(fresh[name])
        print(f"docs/reference/{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
