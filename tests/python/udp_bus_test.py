"""The UDP bus meets python-can's `udp_multicast` inside a network namespace of its own, both ways."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

_MULTICAST_OVER_LO = """\
ip link set lo up && ip link set lo multicast on && ip route add 224.0.0.0/4 dev lo || exit 99
exec "$@"
"""
_CLIENT = Path(__file__).with_name("udp_bus_client.py")


def _echo() -> str:
    path = os.environ.get("SUREFOOT_BUS_ECHO")
    assert path, "SUREFOOT_BUS_ECHO is not set; run these tests through ctest"
    return path


def _talk(in_own_network: list[str], address: str, group: str, port: int) -> str:
    client = [sys.executable, str(_CLIENT), _echo(), address, group, str(port)]
    finished = subprocess.run(
        [*in_own_network, "sh", "-c", _MULTICAST_OVER_LO, "sh", *client],
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert finished.returncode == 0, finished.stdout + finished.stderr
    return finished.stdout


@pytest.mark.parametrize(
    ("address", "group", "port"),
    [("udp", "239.74.163.2", 43113), ("udp:239.1.2.3:5000", "239.1.2.3", 5000)],
)
def test_python_can_and_the_bus_understand_each_other(in_own_network: list[str], address: str, group: str, port: int):
    totals = _talk(in_own_network, address, group, port)
    # Twice 16 lengths there and back; classic, extended, remote, two datagrams of garbage; an error frame.
    assert totals == "sent 32 received 32 foreign_shape 5 error_frames 1\n"
