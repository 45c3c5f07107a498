"""What goes into and comes out of tools/with-vcan is what the command would have had without it."""

import hashlib
import os
import random
import subprocess
import sys
from pathlib import Path

import pytest
import runner

# What a command sees of its surroundings, and both its outputs with every byte there is.
_REPORT = """\
import hashlib, os, sys
print([sys.argv[1:], os.getcwd(), oct(os.umask(0)), sorted(os.environb.items())])
sys.stdout.flush()
sys.stdout.buffer.write(bytes(range(256)) * 4096)
sys.stderr.buffer.write(bytes(reversed(range(256))) * 4096)
sys.exit(77)
"""
_ODD_ARGUMENTS = ["", "a b", "*", "$HOME", "line\nbreak", "-n", "'\"\\", "\u00fc"]
_ODD_ENVIRONMENT = {
    b"PATH": os.environb[b"PATH"],
    b"EMPTY": b"",
    b"LINES_": b"one\ntwo\n",
    b"QUOTES": b"'\"`$(id)\\",
    b"no-identifier.x": b"1",
    b"LATIN_1": b"f\xfcr",
}


def test_command_sees_its_arguments_folder_umask_and_environment(uml: str, tmp_path: Path):
    folder = tmp_path / "a 'folder' of $HOME"
    folder.mkdir()
    command = [sys.executable, "-c", _REPORT, *_ODD_ARGUMENTS]
    finished = runner.run("--backend", uml, "--", *command, cwd=folder, env=_ODD_ENVIRONMENT, umask=0o027)
    assert finished.returncode == 77
    assert finished.stderr == bytes(reversed(range(256))) * 4096
    report, _, every_byte = finished.stdout.partition(b"\n")
    assert every_byte == bytes(range(256)) * 4096
    arguments, directory, umask, environment = eval(report)
    assert arguments == _ODD_ARGUMENTS
    assert directory == str(folder)
    assert umask == "0o27"
    added_by_shells = {b"_", b"PWD", b"SHLVL", b"LC_CTYPE", b"__CF_USER_TEXT_ENCODING"}
    assert {k: v for k, v in environment if k not in added_by_shells} == {**_ODD_ENVIRONMENT, b"SUREFOOT_VCAN": b"uml"}


def test_output_appears_and_input_arrives_while_the_command_runs(uml: str):
    script = 'echo first; read -r line; echo "second $line" >&2; read -r line; echo "third $line"; cat'
    process = runner.start("--backend", uml, "sh", "-c", script, stdin=-1, stdout=-1, stderr=-1, bufsize=0)
    assert process.stdout.readline() == b"first\n"
    process.stdin.write(b"a\n")
    assert process.stderr.readline() == b"second a\n"
    process.stdin.write(b"b\n")
    assert process.stdout.readline() == b"third b\n"
    process.stdin.close()
    assert process.stdout.read() == b""
    assert process.wait() == 0


def test_piped_input_arrives_whole(uml: str):
    content = random.Random(1).randbytes(2_000_001)
    finished = runner.run("--backend", uml, "sha256sum", input=content)
    assert finished.stdout.split()[0].decode() == hashlib.sha256(content).hexdigest()


def test_input_file_is_read_from_where_it_stands_and_stays_there(uml: str, tmp_path: Path):
    path = tmp_path / "input"
    path.write_bytes(b"read before\nfor the command\n")
    with path.open("rb", buffering=0) as file:
        file.read(12)
        assert runner.run("--backend", uml, "cat", stdin=file).stdout == b"for the command\n"
        assert file.tell() == 12


def test_endless_input_does_not_hold_up_a_command_that_ends(uml: str, scratch: Path):
    with subprocess.Popen(["yes"], stdout=subprocess.PIPE) as endless:
        finished = runner.run("--backend", uml, "head", "-n", "1", stdin=endless.stdout)
        endless.stdout.close()
    assert (finished.returncode, finished.stdout) == (0, b"y\n")
    assert not any(scratch.iterdir())


def test_command_ends_when_nobody_reads_its_output_any_more(uml: str):
    process = runner.start("--backend", uml, "yes", stdout=subprocess.PIPE)
    assert process.stdout.readline() == b"y\n"
    process.stdout.close()
    assert process.wait(timeout=60) == 128 + 13


@pytest.mark.parametrize(("command", "code"), [("exit 255", 255), ("kill -SEGV $$", 128 + 11), ("exec nosuch", 127)])
def test_exit_code_is_that_of_the_command(uml: str, command: str, code: int):
    assert runner.run("--backend", uml, "sh", "-c", command).returncode == code


def test_three_interfaces_are_up_and_carry_can_fd(uml: str):
    finished = runner.run("--backend", uml, "-n", "3", "sh", "-c", "cd /sys/class/net; head vcan*/mtu vcan*/flags")
    said = finished.stdout.decode()
    assert said.count("\n72\n") == 3
    assert said.count("\n0x81\n") == 3  # IFF_UP | IFF_NOARP
    assert "vcan3" not in said


def test_guests_at_the_same_time_have_networks_of_their_own(uml: str, scratch: Path):
    # Until five have come, whenever candump begins to listen.
    script = "candump -L -n 5 vcan0 & while kill -0 $!; do cansend vcan0 {}##0AA; sleep 0.1; done 2>/dev/null"
    guests = [runner.start("--backend", uml, "sh", "-c", script.format(name), stdout=-1) for name in ("111", "222")]
    for process, other in zip(guests, (b"222##", b"111##"), strict=True):
        out, _ = process.communicate(timeout=120)
        assert process.returncode == 0
        assert out.count(b"\n") == 5 and other not in out
    assert not any(scratch.iterdir())


def test_nothing_of_the_guest_stays_on_this_machine(uml: str, scratch: Path, tmp_path: Path):
    marks = [f"/run/{tmp_path.name}", f"/dev/shm/{tmp_path.name}", f"/dev/{tmp_path.name}"]
    finished = runner.run("--backend", uml, "touch", *marks, str(tmp_path / "wanted"))
    assert finished.returncode == 0, finished.stderr
    assert not [mark for mark in marks if os.path.lexists(mark)]
    assert (tmp_path / "wanted").exists()
    assert not any(scratch.iterdir())


def test_folder_below_what_the_guest_covers_is_still_seen(uml: str, monkeypatch: pytest.MonkeyPatch):
    folder = Path("/dev/shm") / f"with vcan {os.getpid()}"
    folder.mkdir()
    try:
        (folder / "file").write_text("seen")
        assert runner.run("--backend", uml, "cat", "file", cwd=folder).stdout == b"seen"
    finally:
        (folder / "file").unlink()
        folder.rmdir()


def test_user_without_rights_has_the_same_network_and_no_rights_on_files(uml: str, nobody: list[str], tmp_path: Path):
    script = "candump -L -n 1 vcan0 & while kill -0 $!; do cansend vcan0 123##0AA; sleep 0.1; done"
    script += f"; touch {tmp_path}/forbidden"
    tmp_path.chmod(0o755)
    command = [*nobody, runner.WITH_VCAN, "--backend", uml, "sh", "-c", script]
    environment = {**os.environ, "TMPDIR": "/tmp", "HOME": "/"}
    finished = subprocess.run(command, capture_output=True, cwd="/", env=environment, stdin=subprocess.DEVNULL)
    if finished.returncode == 126:
        pytest.skip("nobody may not read this tree")
    assert b" vcan0 123##" in finished.stdout
    assert not nobody or not (tmp_path / "forbidden").exists()
