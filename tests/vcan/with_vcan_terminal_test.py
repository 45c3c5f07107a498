"""A person at a terminal works in the guest as on this machine."""

import fcntl
import os
import pty
import re
import select
import signal
import struct
import termios
import time
from pathlib import Path

import runner

_DEADLINE_S = 120.0
_CTRL_C = b"\x03"


class _Person:
    """Types into a terminal in which tools/with-vcan runs, and reads what it shows."""

    def __init__(self, *arguments: str) -> None:
        self.pid, self.terminal = pty.fork()
        if self.pid == 0:
            os.execv(runner.WITH_VCAN, [runner.WITH_VCAN, *arguments])
        self.shown = b""

    def resize(self, rows: int, columns: int) -> None:
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))

    def types(self, text: bytes) -> None:
        os.write(self.terminal, text)

    def reads(self, pattern: bytes) -> re.Match:
        """Reads up to the pattern."""
        end = time.monotonic() + _DEADLINE_S
        while not (found := re.search(pattern, self.shown)):
            readable, _, _ = select.select([self.terminal], [], [], end - time.monotonic())
            assert readable, self.shown
            self.shown += os.read(self.terminal, 4096)
        self.shown = self.shown[found.end() :]
        return found

    def exit_code(self) -> int:
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def test_shell_in_the_guest_has_a_terminal_with_job_control(uml: str, scratch: Path):
    shell = ["env", "PS1=[$?]> ", "bash", "--norc", "--noediting"]
    person = _Person("--backend", uml, *shell)
    person.resize(31, 97)
    before = termios.tcgetattr(person.terminal)
    person.reads(rb"\[0\]> ")
    person.types(b"candump -n 1 vcan0 & while kill -0 %1; do cansend vcan0 123##1AA; sleep 0.1; done 2>/dev/null\r")
    person.reads(rb"vcan0  123  \[01\]  AA")
    person.reads(rb"> ")
    person.types(b"sh -c \"echo re''ady; exec sleep 1000\"\r")
    person.reads(rb"ready\r\n")
    person.types(_CTRL_C)
    person.reads(rb"\[130\]> ")
    person.resize(40, 120)
    person.types(b"until [ \"$(stty size)\" = '40 120' ]; do sleep 0.1; done; echo re''sized\r")
    person.reads(rb"resized\r\n")
    person.types(b"exit 5\r")
    person.reads(rb"exit\r\n")
    assert person.exit_code() == 5
    assert termios.tcgetattr(person.terminal) == before
    assert not any(scratch.iterdir())


def test_signal_to_the_runner_ends_the_command_on_its_terminal(uml: str, scratch: Path):
    person = _Person("--backend", uml, "sh", "-c", "echo re''ady; exec sleep 1000")
    person.reads(rb"ready\r\n")
    os.kill(person.pid, signal.SIGTERM)
    assert person.exit_code() == 128 + signal.SIGTERM
    assert not any(scratch.iterdir())
