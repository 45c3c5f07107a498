"""The reference pages are those that their sources give, and leave nothing out."""

import re
from pathlib import Path

import cantools
import pytest
from command_line import ROOT, surefoot

from tools.export.lcm_schema import schemas
from tools.reference.__main__ import FOLDER, main, pages
from tools.reference.scenario_keys_page import scenario_keys_page
from tools.reference.telemetry_page import unit


@pytest.fixture(scope="module")
def fresh() -> dict[str, str]:
    return pages()


def test_the_committed_pages_are_those_generated_now(fresh: dict[str, str]):
    for name, text in fresh.items():
        assert (FOLDER / name).read_text() == text, f"docs/reference/{name} is stale: run python -m tools.reference"
    assert {path.name for path in FOLDER.iterdir()} >= set(fresh)


def test_no_page_tells_of_the_machine_that_wrote_it(fresh: dict[str, str]):
    for name, text in fresh.items():
        assert str(ROOT) not in text and str(Path.home()) + "/" not in text, name


def test_every_message_and_signal_of_the_dbc_has_its_line(fresh: dict[str, str]):
    sections = dict(re.findall(r"^## (\w+)\n(.*?)(?=^## |\Z)", fresh["can.md"], re.MULTILINE | re.DOTALL))
    for message in cantools.database.load_file(ROOT / "firmware/can/surefoot.dbc").messages:
        assert f"identifier 0x{message.frame_id:03X}; {message.length} bytes;" in sections[message.name]
        for signal in message.signals:
            assert f"| `{signal.name}` | {signal.start}" in sections[message.name]


def test_every_field_and_constant_of_the_telemetry_has_its_line(fresh: dict[str, str]):
    for schema in schemas().values():
        section = fresh["telemetry.md"].split(f"\n## {schema.name}\n")[1].split("\n## ")[0]
        for declared in [*schema.fields, *schema.constants]:
            assert f"| `{declared.name}` |" in section


def test_units_are_read_from_the_names():
    names = ["joint_rate_rad_s", "push_impulse_world_n_s", "body_position_world_m", "load_percent", "utime", "tick"]
    assert [unit(name) for name in names] == ["rad/s", "N s", "m", "%", "µs", ""]


def test_every_key_has_a_line_with_its_values(fresh: dict[str, str]):
    printed = surefoot("keys").stdout.decode()
    keys = re.findall(r"^  (\S+) ", printed, re.MULTILINE)
    rows = re.findall(r"^\| `([^`]+)` \| \w+ \| .+ \| (.+) \|$", fresh["scenario_keys.md"], re.MULTILINE)
    assert [key for key, _ in rows] == keys and len(keys) > 100


def test_keys_of_an_unknown_form_are_refused():
    with pytest.raises(ValueError, match="unknown form"):
        scenario_keys_page("[gait]\n  gait.pace  complex  a number of another kind\n")


def test_every_fault_and_every_command_has_its_place(fresh: dict[str, str]):
    for number, name in re.findall(r"^## (\d+) (\w+)", (ROOT / "firmware/FAULTS.md").read_text(), re.MULTILINE):
        assert f"| {number} | [`{name}`]" in fresh["faults.md"]
    commands = set(re.findall(r"^## surefoot ([\w-]+)$", fresh["cli.md"], re.MULTILINE))
    assert {"run", "replay", "keys", "plot", "export"} <= commands


def test_check_tells_a_stale_page_and_writes_nothing(fresh, monkeypatch, tmp_path: Path, capsys):
    monkeypatch.setattr("tools.reference.__main__.FOLDER", tmp_path)
    monkeypatch.setattr("tools.reference.__main__.pages", lambda: fresh)
    assert main(["--check"]) == 1
    said = capsys.readouterr()
    assert "+# CAN messages" in said.out and "remedy: " in said.err and not list(tmp_path.iterdir())
    assert main([]) == 0 and main(["--check"]) == 0
