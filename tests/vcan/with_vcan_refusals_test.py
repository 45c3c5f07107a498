"""What tools/with-vcan and tools/build-uml refuse, and that they say why and what to do."""

import re
import subprocess
from pathlib import Path

import pytest
import runner

_BUILD_UML = str(runner.ROOT / "tools" / "build-uml")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--nosuch", "true"], "unknown option: --nosuch"),
        ([], "the command is missing"),
        (["-n"], "-n needs a value"),
        (["-n", "0", "true"], "expected 1 to 16"),
        (["-n", "two", "true"], "expected 1 to 16"),
        (["-n", "17", "true"], "expected 1 to 16"),
        (["--timeout", "soon", "true"], "expected seconds"),
        (["--memory", "1", "true"], "expected for example 512M"),
        (["--backend", "qemu", "true"], "unknown backend: qemu"),
        (["--backend", "uml", "--cpus", "999", "true"], "--cpus 999"),
    ],
)
def test_wrong_usage_is_refused(arguments: list[str], said: str):
    finished = runner.run(*arguments)
    assert (finished.returncode, finished.stdout) == (runner.USAGE, b"")
    assert said in finished.stderr.decode() and "  remedy: " in finished.stderr.decode()


@pytest.mark.parametrize(
    ("backend", "variable", "value", "said"),
    [
        ("uml", "SUREFOOT_UML", "/nonexistent", "apt-get install -y user-mode-linux"),
        ("uml", "SUREFOOT_UML", "/bin/false", "does not start here"),
        ("uml-time-travel", "SUREFOOT_UML_CACHE", "/nonexistent", "tools/build-uml"),
    ],
)
def test_machine_without_can_is_no_failure_but_has_a_reason(
    scratch: Path, monkeypatch: pytest.MonkeyPatch, backend: str, variable: str, value: str, said: str
):
    monkeypatch.setenv(variable, value)
    finished = runner.run("--backend", backend, "true")
    assert (finished.returncode, finished.stdout) == (runner.NO_CAN, b"")
    assert said in finished.stderr.decode() and "  remedy: " in finished.stderr.decode()
    assert not any(scratch.iterdir())


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["--nosuch"], runner.USAGE, "unknown argument: --nosuch"),
        (["--jobs", "many"], runner.USAGE, "--jobs needs a number of cores, got 'many'"),
        (["--jobs"], runner.USAGE, "--jobs needs a number of cores"),
        (["--print-path"], runner.MACHINE_LACKS, "is not built"),
    ],
)
def test_build_of_the_guest_is_refused_with_a_reason(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], code: int, said: str
):
    monkeypatch.setenv("SUREFOOT_UML_CACHE", str(tmp_path))
    finished = subprocess.run([_BUILD_UML, *arguments], capture_output=True, text=True, check=False)
    assert (finished.returncode, finished.stdout) == (code, "")
    assert said in finished.stderr
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("tool", [runner.WITH_VCAN, _BUILD_UML])
def test_help_names_every_exit_code_that_the_tool_uses(tool: str):
    helped = subprocess.run([tool, "--help"], capture_output=True, text=True, check=True)
    assert helped.stderr == ""
    sources = [Path(tool), *([runner.ROOT / "tools" / "vcan" / "host.sh"] if tool == runner.WITH_VCAN else [])]
    text = "".join(path.read_text() for path in sources)
    used = set(re.findall(r"\b(?:fail|exit|fail_with_console) ([1-9]\d+)\b", text))
    assert len(used) >= 3
    for code in used - {"137"}:  # 128 + 9
        assert re.search(rf"\b{code} \w", helped.stdout.split("Exit codes:")[1]), code
