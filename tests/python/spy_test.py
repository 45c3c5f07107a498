"""lcm-spy's own classes decode every message of a run with the types that tools/spy builds."""

import os
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import lcm
import pytest
from command_line import MACHINE_LACKS, ROOT, USAGE, binary

_SPY = ROOT / "tools" / "spy"
_MULTICAST_OVER_LO = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
exec "$@"
"""
# A robot with controllers of its own, and a load: something on every channel.
_WALK = [
    "run", ROOT / "tools" / "scenarios" / "khr2_payload.toml", "--live", "--pace", "8",
    "--set", "payload.0.at_s=0.1", "--set", "duration_s=0.5", "--set", "telemetry.every_ticks=50",
]  # fmt: skip


def _spy(*arguments: str, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run(
        [_SPY, *arguments], capture_output=True, text=True, check=False, env={**os.environ, **environment}
    )


def _documented_channels() -> dict[str, str]:
    table = (ROOT / "lcm_types" / "README.md").read_text()
    return dict(re.findall(r"^\| `(SUREFOOT_\w+)` \| `(\w+)` \|", table, re.MULTILINE))


@pytest.fixture(scope="module")
def heard(in_own_network: list[str], tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("spied")
    listen = [sys.executable, ROOT / "tests" / "python" / "live_listener.py", folder / "heard.lcmlog"]
    command = [*listen, binary(), *_WALK, "--out", folder / "run"]
    finished = subprocess.run(
        [*in_own_network, "sh", "-c", _MULTICAST_OVER_LO, "sh", *map(str, command)],
        capture_output=True, text=True, timeout=30, check=False,
    )  # fmt: skip
    assert (folder / "heard.lcmlog").is_file(), finished.stderr
    return folder / "heard.lcmlog"


def test_every_message_of_every_documented_channel_decodes(heard: Path) -> None:
    types = _spy("--types")
    assert types.returncode == 0, types.stderr
    decoder = ROOT / "tests" / "python" / "SpyDecodes.java"
    decoded = subprocess.run(
        ["java", "-cp", types.stdout.strip(), decoder, heard], capture_output=True, text=True, check=False
    )
    assert decoded.returncode == 0, decoded.stderr
    lines = [line.split() for line in decoded.stdout.splitlines() if line.startswith("SUREFOOT_")]
    assert {channel: message for channel, message, _ in lines} == _documented_channels()
    sent = Counter(event.channel for event in lcm.EventLog(str(heard), "r"))
    assert {channel: int(count) for channel, _, count in lines} == dict(sent)


def test_help_shows_an_example() -> None:
    finished = _spy("--help")
    assert finished.returncode == 0 and "Examples:" in finished.stdout


def test_without_a_screen_it_says_so() -> None:
    finished = _spy(DISPLAY="")
    assert finished.returncode == MACHINE_LACKS
    assert "no screen" in finished.stderr and "  remedy: " in finished.stderr


def test_without_java_it_names_what_installs_it(tmp_path: Path) -> None:
    for program in ("bash", "dirname", "cat"):
        (tmp_path / program).symlink_to(f"/usr/bin/{program}")
    finished = _spy("--types", PATH=str(tmp_path))
    assert finished.returncode == MACHINE_LACKS
    assert "is missing" in finished.stderr and "tools/setup --tests" in finished.stderr


def test_an_unknown_argument_is_refused() -> None:
    assert _spy("--frobnicate").returncode == USAGE
