"""What the documents name is there, and the commands they show do what is said beside them."""

import re
import tomllib
from pathlib import Path

import pytest
from command_line import ROOT, surefoot
from scratch_tree import code_lines, make_scratch_tree, shell

_MADE = {"build", "runs"}
_ROOMS = [entry for entry in ROOT.iterdir() if entry.is_dir() and entry.name[0] != "." and entry.name not in _MADE]
_DOCUMENTS = sorted([*ROOT.glob("*.md"), *(path for room in _ROOMS for path in room.rglob("*.md"))])
_NAMES = [str(path.relative_to(ROOT)) for path in _DOCUMENTS]
# These are run elsewhere (grids of runs by a few of their cells), or need a network.
_LONG = re.compile(r"^tools/(demo|test)\b|^cmake |--live\b|^tools/surefoot (table|map|triggers|calibrate|sweep|floor-table)\b")


def _is_there(path: str, document: Path) -> bool:
    """Paths are meant from the document's folder or from the tree's top; one that ends in / is a folder."""
    found = [base / path for base in (document.parent, ROOT) if (base / path).exists()]
    return bool(found) and (not path.endswith("/") or found[0].is_dir())


def _subcommands() -> set[str]:
    listed = surefoot("--help").stdout.decode().split("Subcommands:\n")[1].split("\n\n")[0]
    in_python = {"plot", "report", "watch", "tail", "export"}
    return {*re.findall(r"^  ([\w-]+)", listed, re.MULTILINE), *in_python}


def _subfolders(folder: Path) -> set[str]:
    return {entry.name for entry in folder.iterdir() if entry.is_dir() and entry.name[0] not in "._"}


def test_the_documents_are_found():
    rooms = ["firmware", "lcm_types", "sim_hw", "tests", "tools"]
    assert {"README.md", "CHANGELOG.md", *(f"{room}/README.md" for room in rooms)} <= set(_NAMES)


@pytest.mark.parametrize("document", _DOCUMENTS, ids=_NAMES)
def test_every_relative_link_leads_to_a_file(document: Path):
    links = re.findall(r"\]\(([^)\s#]+)", document.read_text())
    lost = [link for link in links if "://" not in link and not (document.parent / link).exists()]
    assert not lost


@pytest.mark.parametrize("document", _DOCUMENTS, ids=_NAMES)
def test_every_path_in_the_text_is_there(document: Path):
    paths = re.findall(r"`([\w.-]+/[\w./-]*)`", document.read_text())
    lost = [path for path in paths if path.split("/")[0] not in _MADE and not _is_there(path, document)]
    assert not lost


@pytest.mark.parametrize("room", ["firmware", "sim_hw", "tests", "tools"])
def test_the_table_of_a_room_names_what_is_there_and_every_folder(room: str):
    text = (ROOT / room / "README.md").read_text()
    first_columns = re.findall(r"^\| (`[^|]*`) \|", text, re.MULTILINE)
    named = [name for column in first_columns for name in re.findall(r"`([^`]+)`", column)]
    assert named
    assert not [name for name in named if not (ROOT / room / name).exists()]
    assert _subfolders(ROOT / room) <= {name.split("/")[0] for name in named}


def test_the_table_of_the_tree_names_every_room():
    named = set(re.findall(r"^\| \[`(\w+)/`\]", (ROOT / "README.md").read_text(), re.MULTILINE))
    assert named == {room.name for room in _ROOMS} - {"docs"}


def test_the_table_of_the_tests_names_the_labels_that_tools_test_promises():
    labels = set(re.findall(r"^\| `.*/` \| `(\w+)` \|", (ROOT / "tests" / "README.md").read_text(), re.MULTILINE))
    [promised] = re.findall(r"^readonly promised_labels=\((.*)\)$", (ROOT / "tools" / "test").read_text(), re.MULTILINE)
    assert labels == set(promised.split())


_WITH_COMMANDS = [document for document in _DOCUMENTS if document.name != "cli.md"]  # that is usages: placeholders


@pytest.mark.parametrize("document", _WITH_COMMANDS, ids=lambda document: str(document.relative_to(ROOT)))
def test_every_command_shown_is_there_and_so_are_its_scenarios(document: Path):
    for line in code_lines(document.read_text()):
        command = line.split("#")[0]
        for program in re.findall(r"(?:^|[|&] *)((?:tools|build|\.venv)/\S+)", command):
            assert program.startswith(("build/", ".venv/")) or (ROOT / program).is_file(), line
        for subcommand in re.findall(r"tools/surefoot ([\w.-]+)", command):
            assert subcommand in _subcommands(), line
        for scenario in re.findall(r"\S+\.toml", command):
            assert (ROOT / scenario).is_file(), line


# Commands run as they stand


def _examples(help_text: str) -> list[str]:
    return re.findall(r"^  (.+)$", help_text.split("Examples:\n")[1].split("\n\n")[0], re.MULTILINE)


def _shown_commands(where: str) -> list[str]:
    if where == "README.md":
        return code_lines((ROOT / where).read_text())
    if where == "tools/surefoot --help":
        return _examples(shell(ROOT, where).stdout)
    return _examples(surefoot("run", "--help").stdout.decode())


@pytest.mark.parametrize("where", ["README.md", "tools/surefoot --help", "surefoot run --help"])
def test_commands_that_are_shown_end_as_the_comment_beside_them_says(where: str, tmp_path: Path):
    tree = make_scratch_tree(tmp_path / "tree")
    commands = [line for line in _shown_commands(where) if not _LONG.search(line)]
    assert len(commands) >= 3
    for line in commands:
        said = re.search(r"# .*\bexit code (\d+)", line)
        finished = shell(tree, line)
        assert finished.returncode == int(said[1] if said else 0), f"{line}\n{finished.stdout}{finished.stderr}"
        assert finished.stdout, line


# The comment that each scenario begins with


@pytest.mark.parametrize("path", sorted((ROOT / "tools" / "scenarios").glob("*.toml")), ids=lambda path: path.stem)
def test_a_scenario_ends_as_its_first_lines_say(path: Path):
    text = path.read_text()
    assert tomllib.loads(text)
    comment = " ".join(line.removeprefix("# ") for line in text.split("\n\n")[0].splitlines())
    [said] = re.findall(r"Expect: .*\bexit code (\d+)", comment)
    finished = surefoot("run", path, "--no-record")
    assert finished.returncode == int(said), finished.stdout.decode()
