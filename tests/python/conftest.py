"""Fixtures: one recorded run for all tests of a session, and a made-up one for the pictures."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from command_line import SHORT, surefoot
from synthetic_run import write_synthetic_run

# Long enough for every event of the main job: trigger at about 1.26 s, on the way again 4.5 s later.
_SCENARIO = """\
plant = "thesis"
duration_s = 6.5

[reflex]
method = "original"

[limits]
min_cycles_after_recovery = 0.0

[[payload]]
mass_kg = 5.0
at_s = 1.2
"""


@pytest.fixture(scope="session")
def run_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `surefoot run` leaves behind after a short payload walk."""
    binary = os.environ.get("SUREFOOT_BINARY")
    assert binary, "SUREFOOT_BINARY is not set; run these tests through ctest"
    folder = tmp_path_factory.mktemp("run")
    scenario = folder / "short.toml"
    scenario.write_text(_SCENARIO)
    run = folder / "recorded"
    finished = subprocess.run([binary, "run", scenario, "--out", run], capture_output=True, text=True, check=False)
    assert finished.returncode == 0, finished.stdout + finished.stderr
    return run


@pytest.fixture(scope="session")
def short_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A short recorded walk without a payload, to be copied before harm is done to it."""
    folder = tmp_path_factory.mktemp("short") / "run"
    finished = surefoot("run", *SHORT, "--out", folder)
    assert finished.returncode == 0, finished.stderr
    return folder


@pytest.fixture(scope="session")
def synthetic_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run folder made up from the formulas of the walk."""
    return write_synthetic_run(tmp_path_factory.mktemp("synthetic") / "made_up")


@pytest.fixture(scope="session")
def in_own_network() -> list[str]:
    """The begin of a command line that runs with a network of its own: a loopback that is down, and no route."""
    for program in ("unshare", "ip"):
        assert shutil.which(program), f"{program} is missing; run tools/setup"
    prefix = ["unshare", "-n"] if os.geteuid() == 0 else ["unshare", "-rn"]
    tried = subprocess.run([*prefix, "ip", "link", "set", "lo", "up"], capture_output=True, text=True, check=False)
    if tried.returncode != 0:
        pytest.skip(f"this machine permits no network namespace: {tried.stderr.strip()}")
    return prefix


@pytest.fixture(scope="session")
def without_privilege() -> list[str]:
    """The begin of a command line that is refused what its user may not do, also where that user is root."""
    if os.geteuid() != 0:
        return []
    return ["setpriv", "--bounding-set=-dac_override,-dac_read_search"]
