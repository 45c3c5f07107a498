"""What firmware/ says about itself is what the program says: transition tables, schedule, list of faults."""

import re
from pathlib import Path

import pytest
from command_line import ROOT, surefoot
from scratch_tree import code_lines, make_scratch_tree, shell

_README = Path("firmware") / "README.md"
_COMMANDS = ["states", "stages"]


def _table(command: str) -> re.Pattern:
    return re.compile(rf"(?<=<!-- {command}: begin -->\n).*(?=<!-- {command}: end -->\n)", re.DOTALL)


@pytest.mark.parametrize("command", _COMMANDS)
def test_the_readme_holds_the_table_that_the_binary_prints(command: str):
    table = _table(command).search((ROOT / _README).read_text())
    assert table, f"the comments around the table are missing in {_README}"
    assert table[0] == surefoot(command).stdout.decode(), f"refresh it: the command is in {_README}"


@pytest.mark.parametrize("name", _COMMANDS)
def test_the_documented_command_refreshes_the_table(name: str, tmp_path: Path):
    tree = make_scratch_tree(tmp_path / "tree")
    wanted = (tree / _README).read_text()
    (tree / _README).write_text(_table(name).sub("| walking | for ever |\n| and | ever |\n", wanted))
    [command] = [line for line in code_lines(wanted) if f"surefoot {name}" in line]
    for _ in range(2):
        finished = shell(tree, command)
        assert finished.returncode == 0, finished.stderr
        assert (tree / _README).read_text() == wanted


def test_the_schedule_names_every_controller_once():
    rows = re.findall(r"^\| (\w+) \|(?: [x ] \|){6}$", surefoot("stages").stdout.decode(), re.MULTILINE)
    assert len(rows) == len(set(rows)) == 17


def test_every_fault_has_its_paragraph():
    enumerators = re.findall(r"^  k(\w+) = (\d+),", (ROOT / "firmware/core/safety/fault.hpp").read_text(), re.MULTILINE)
    faults = [
        (int(number), re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower()) for name, number in enumerators if name != "None"
    ]
    assert len(faults) >= 5
    paragraphs = (ROOT / "firmware" / "FAULTS.md").read_text().split("\n## ")[1:]
    headings = [paragraph.splitlines()[0].split(" ", 1) for paragraph in paragraphs]
    assert [(int(number), name) for number, name in headings] == faults
    for paragraph in paragraphs:
        for part in ("**Cause.** ", "**Check.** ", "**Cure.** ", "**Safe state.** "):
            assert paragraph.count(part) == 1, paragraph.splitlines()[0]
