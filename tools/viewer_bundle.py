"""The page's program and style, bundled by tools/viewer/build when they have changed."""

import subprocess
from pathlib import Path

_VIEWER = Path(__file__).resolve().parent / "viewer"
_BUNDLED = Path(__file__).resolve().parents[1] / ".cache" / "viewer"


class ViewerError(Exception):
    """The page could not be bundled; the message names the remedy."""


def bundle() -> tuple[str, str]:
    """JavaScript and CSS of the page, each as one text.

    Raises ViewerError where node is missing or a source has an error.
    """
    built = subprocess.run([_VIEWER / "build"], capture_output=True, text=True, check=False)
    if built.returncode != 0:
        raise ViewerError(built.stderr.strip() or f"{_VIEWER}/build: exit code {built.returncode}\n  remedy: run it")
    return (_BUNDLED / "viewer.js").read_text(), (_BUNDLED / "viewer.css").read_text()
