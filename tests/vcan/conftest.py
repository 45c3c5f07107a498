"""Fixtures for the tests of tools/with-vcan."""

import os
from pathlib import Path

import pytest
import runner


@pytest.fixture(scope="session")
def uml() -> str:
    """The backend that is tested from outside: the same on every machine."""
    runner.skip_without("uml")
    return "uml"


@pytest.fixture
def scratch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where a guest keeps its files during a test."""
    folder = tmp_path / "scratch"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    return folder


@pytest.fixture
def nobody() -> list[str]:
    """The begin of a command line that runs as a user without any rights."""
    if os.geteuid() != 0:
        return []
    return ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
