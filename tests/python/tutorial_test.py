"""The documents that lead a reader by the hand are followed in a fresh clone: each command, edit and output."""

import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from command_line import ROOT
from documented_session import Step, commands, expected_exit_code, missing_line, steps, write_file
from fresh_clone import Terminal, clone_of_tree

# Set to this, nothing is shared with this tree: packages are installed and all is compiled, which takes long.
_FROM_NOTHING = os.environ.get("SUREFOOT_TUTORIAL") == "from_nothing"
_TUTORIAL = "tutorial.md"
_HOW_TO = ["howto_own_robot.md", "howto_python_controller.md"]


@pytest.fixture(scope="module")
def terminal(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Terminal]:
    if not (ROOT / ".git").exists():
        pytest.skip("this tree is no clone of a repository")
    clone = clone_of_tree(tmp_path_factory.mktemp("fresh") / "surefoot")
    terminal = Terminal(clone, shares_with_tree=not _FROM_NOTHING)
    tried = terminal.type("true")
    if tried.returncode != 0:
        pytest.skip(f"this machine permits no mount namespace ({tried.stdout.strip()}); "
                    "SUREFOOT_TUTORIAL=from_nothing does without, and takes some ten minutes")  # fmt: skip
    yield terminal
    shutil.rmtree(clone)


def _steps_of(terminal: Terminal, name: str) -> list[Step]:
    return steps((terminal.clone / "docs" / name).read_text())


def _type(terminal: Terminal, command: str) -> str:
    finished = terminal.type(command)
    assert finished.returncode == expected_exit_code(command), f"{command}\n{finished.stdout}"
    return finished.stdout


def _follow(terminal: Terminal, document: list[Step]) -> None:
    printed = ""
    for step in document:
        if step.kind == "sh":
            printed = "".join(_type(terminal, command) for command in commands(step.text))
        elif step.kind == "text":
            missed = missing_line(step.text, printed)
            assert missed is None, f"not printed there: {missed}\n{printed}"
        elif step.kind == "diff":
            apply = ["git", "apply", "--recount", "-"]
            subprocess.run(apply, cwd=terminal.clone, input=step.text, text=True, check=True)
        else:
            write_file(terminal.clone, step.text)


def test_the_tutorial_does_what_it_says(terminal: Terminal):
    document = _steps_of(terminal, _TUTORIAL)
    kinds = [step.kind for step in document]
    assert kinds.count("sh") >= 8 and kinds.count("text") >= 6 and kinds.count("diff") == 1
    _follow(terminal, document)


@pytest.mark.parametrize("name", _HOW_TO)
def test_a_how_to_does_what_it_says(terminal: Terminal, name: str):
    build = _steps_of(terminal, _TUTORIAL)[0]  # every how-to begins where the tutorial's first step ends
    _follow(terminal, [build, *_steps_of(terminal, name)])


# The judge of what is printed


@pytest.mark.parametrize("claim", ["fell at 7.77 s", "…\n2 of 6", "fell at 7.7… s\n…\n2 of 6", "fell   at 7.7660 s"])
def test_a_claim_that_is_true_passes(claim: str):
    assert missing_line(claim, "  fell at 7.766 s\n  torso\n2 of 6\n") is None


@pytest.mark.parametrize("claim", ["fell at 8.1 s", "fell", "2 of 6", "…\n3 of 6", "…\n2 of 6\n…\ntorso", "fell at 7 s"])
def test_a_claim_that_is_not_true_is_named(claim: str):
    assert missing_line(claim, "  fell at 7.766 s\n  torso\n2 of 6\n") == claim.splitlines()[-1]


def test_a_command_over_several_lines_is_one():
    assert commands("a 'b\nc'\nd\n") == ["a 'b\nc'", "d"]


def test_new_files_name_their_place(tmp_path: Path):
    write_file(tmp_path, "# file: a.py\nprint()\n")
    assert (tmp_path / "a.py").read_text() == "print()\n"
