"""tools/with-vcan on a machine whose kernel has vcan: what these tests run in is one."""

import signal
import subprocess
from pathlib import Path

import pytest
import runner

_HERE = sorted(path.name for path in Path("/sys/class/net").glob("vcan*"))
_ONE_MORE = str(len(_HERE) + 1)


def test_interfaces_that_are_there_are_used():
    finished = runner.run("-v", "-n", str(len(_HERE)), "readlink", "/proc/self/ns/net")
    assert b"native, in this network" in finished.stderr
    assert finished.stdout.decode().strip() == Path("/proc/self/ns/net").readlink().name
    assert finished.returncode == 0


def test_interfaces_that_are_not_there_come_in_a_network_of_their_own():
    script = "ls /sys/class/net; ip -br link; ip route; cat"
    finished = runner.run("-v", "-n", _ONE_MORE, "sh", "-c", script, input=b"in\n")
    assert b"native, in a network of its own" in finished.stderr, finished.stderr
    said = finished.stdout.decode()
    assert f"vcan{len(_HERE)}\n" in said  # of /sys
    assert said.count("<NOARP,UP,LOWER_UP>") == int(_ONE_MORE)
    assert "224.0.0.0/4 dev lo" in said and said.endswith("\nin\n")
    assert sorted(path.name for path in Path("/sys/class/net").glob("vcan*")) == _HERE


def test_interface_that_is_down_or_carries_no_can_fd_is_not_used():
    own = ["--backend", "native", "-n", _ONE_MORE, "sh", "-c"]
    script = "ip link set vcan0 down; ip link set vcan0 {}; exec $0 -v -n 1 cat /sys/class/net/vcan0/mtu"
    for change in ("mtu 72", "mtu 16 up"):
        finished = runner.run(*own, script.format(change), runner.WITH_VCAN)
        assert b"native, in a network of its own" in finished.stderr, finished.stderr
        assert finished.stdout == b"72\n"


@pytest.mark.parametrize("count", ["1", _ONE_MORE])
def test_exit_code_signal_and_timeout_pass_through(count: str):
    native = ["--backend", "native", "-n", count]
    assert runner.run(*native, "sh", "-c", "exit 5").returncode == 5
    assert runner.run(*native, "nosuch").returncode == runner.NO_SUCH_COMMAND
    assert runner.run(*native, "--timeout", "0.5", "sleep", "1000").returncode == runner.TIMED_OUT
    assert runner.run(*native, "printenv", "SUREFOOT_VCAN").stdout == b"native\n"
    process = runner.start(*native, "sh", "-c", "echo ready; exec sleep 1000", stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"ready\n"
    process.terminate()
    assert process.wait() == -signal.SIGTERM
