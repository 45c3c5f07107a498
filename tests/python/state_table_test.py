"""What firmware/ says about itself is what the program says: transition table and list of faults."""

import re
from pathlib import Path

from command_line import ROOT, surefoot
from scratch_tree import code_lines, make_scratch_tree, shell

_README = Path("firmware") / "README.md"
_TABLE = re.compile(r"(?<=<!-- states: begin -->\n).*(?=<!-- states: end -->\n)", re.DOTALL)


def test_the_readme_holds_the_transition_table_that_the_binary_prints():
    table = _TABLE.search((ROOT / _README).read_text())
    assert table, f"the comments around the table are missing in {_README}"
    assert table[0] == surefoot("states").stdout.decode(), f"refresh it: the command is in {_README}"


def test_the_documented_command_refreshes_the_table(tmp_path: Path):
    tree = make_scratch_tree(tmp_path / "tree")
    wanted = (tree / _README).read_text()
    (tree / _README).write_text(_TABLE.sub("| walking | for ever |\n| and | ever |\n", wanted))
    [command] = [line for line in code_lines(wanted) if "surefoot states" in line]
    for _ in range(2):
        finished = shell(tree, command)
        assert finished.returncode == 0, finished.stderr
        assert (tree / _README).read_text() == wanted


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
