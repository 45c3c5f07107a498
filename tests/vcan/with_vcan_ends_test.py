"""However a command in tools/with-vcan ends: its caller learns how, and nothing stays behind."""

import os
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import pytest
import runner


def wait_until(is_so: Callable[[], bool], deadline_s: float = 60.0) -> None:
    end = time.monotonic() + deadline_s
    while not is_so():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.01)


def started(backend: str, script: str, *options: str) -> subprocess.Popen:
    """Runs a shell script that says "ready", and returns once it has."""
    process = runner.start("--backend", backend, *options, "sh", "-c", script, stdout=-1, stderr=-1)
    assert process.stdout.readline() == b"ready\n"
    return process


def assert_clean(scratch: Path) -> None:
    assert not any(scratch.iterdir())
    wait_until(lambda: not runner.processes_that_name(str(scratch)))  # the last one is about to end


_SPINNING = "while :; do sleep 0.1; done"


def test_command_answers_a_signal_in_its_own_way(uml: str, scratch: Path):
    process = started(uml, f'trap "echo answered; exit 3" TERM; echo ready; {_SPINNING}')
    process.terminate()
    assert process.communicate(timeout=60)[0] == b"answered\n"
    assert process.returncode == 3
    assert_clean(scratch)


@pytest.mark.parametrize("name", ["SIGTERM", "SIGINT", "SIGHUP"])
def test_command_dies_of_a_signal(uml: str, scratch: Path, name: str):
    process = started(uml, f"echo ready; exec {'sleep 1000'}")
    process.send_signal(signal.Signals[name])
    assert process.wait(timeout=60) == 128 + signal.Signals[name]
    assert_clean(scratch)


def test_interrupt_reaches_everybody_as_from_a_terminal(uml: str):
    child = "sh -c 'trap \"echo child; exit\" INT; echo ready; " + _SPINNING + "'"
    process = started(uml, f'trap "echo parent" INT; {child}; wait; exit 5')
    process.send_signal(signal.SIGINT)
    assert sorted(process.communicate(timeout=60)[0].split()) == [b"child", b"parent"]
    assert process.returncode == 5


def test_command_that_ignores_the_signal_is_killed_in_the_end(uml: str, scratch: Path):
    process = started(uml, f'trap "" TERM; echo ready; {_SPINNING}')
    process.terminate()
    assert process.wait(timeout=60) == 128 + signal.SIGKILL
    assert_clean(scratch)


def test_timeout_asks_first_and_says_that_it_was_one(uml: str, scratch: Path):
    script = f'trap "echo asked; exit 0" TERM; echo ready; {_SPINNING}'
    finished = runner.run("--backend", uml, "--timeout", "4.5", "sh", "-c", script)
    assert finished.returncode == runner.TIMED_OUT
    assert finished.stdout in (b"ready\nasked\n", b"")  # nothing where a busy machine did not get that far
    assert b"4.5 s" in finished.stderr
    assert_clean(scratch)


def test_what_the_command_leaves_running_does_not_keep_the_guest(uml: str, scratch: Path):
    finished = runner.run("--backend", uml, "sh", "-c", "sleep 1000 & setsid sleep 1000 & echo done")
    assert (finished.returncode, finished.stdout) == (0, b"done\n")
    assert_clean(scratch)


def test_kill_of_the_runner_leaves_nothing(uml: str, scratch: Path):
    process = started(uml, "echo ready; exec sleep 1000")
    assert runner.processes_that_name(str(scratch))
    process.kill()
    process.wait()
    wait_until(lambda: not any(scratch.iterdir()))
    assert_clean(scratch)


def test_death_of_the_guest_is_an_error_of_its_own(uml: str, scratch: Path):
    process = started(uml, "echo ready; exec sleep 1000")
    (folder,) = scratch.iterdir()
    os.kill(int((folder / "uml" / "guest" / "pid").read_text()), signal.SIGKILL)
    _, said = process.communicate(timeout=60)
    assert process.returncode == runner.INTERNAL_ERROR
    assert b"the guest ended before the command did" in said and b"  remedy: " in said
    assert_clean(scratch)
