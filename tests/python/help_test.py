"""What `--help` says is there, is there; and the command for people hides nothing of the binary."""

import re
import subprocess

import pytest
from command_line import ROOT, surefoot


def _subcommands() -> list[str]:
    listed = surefoot("--help").stdout.decode().split("Subcommands:\n")[1].split("\n\n")[0]
    return re.findall(r"^  (\w+)", listed, re.MULTILINE)


def test_the_command_for_people_lists_every_subcommand_and_exit_code():
    finished = subprocess.run([ROOT / "tools" / "surefoot", "--help"], capture_output=True, text=True, check=True)
    for name in [*_subcommands(), "plot"]:
        assert re.search(rf"^  {name}\b", finished.stdout, re.MULTILINE), name
    for code in (0, 2, 3, 64, 65, 69, 70, 130):
        assert re.search(rf"\b{code} \w", finished.stdout.split("Exit codes:")[1]), code


@pytest.mark.parametrize("subcommand", [
    "run", "sweep", "sweep-rows", "table", "triggers", "map", "replay", "bus", "keys", "states", "stages",
    "doctor", "bench", "calibrate", "floor-table", "plan"
])  # fmt: skip
def test_every_subcommand_explains_itself(subcommand: str):
    finished = surefoot(subcommand, "--help")
    assert finished.returncode == 0 and finished.stderr == b""
    assert f"Usage: surefoot {subcommand}".encode() in finished.stdout


def test_keys_gives_unit_range_default_and_meaning_of_every_key_of_a_recorded_scenario(run_folder):
    listed = surefoot("keys").stdout.decode()
    scenario = (run_folder / "scenario.toml").read_text()
    table = ""
    for line in scenario.splitlines():
        if header := re.match(r"\[+(\w+)\]+", line):
            table = {"payload": "payload.N.", "fault": "fault.N."}.get(header[1], header[1] + ".")
        elif key := re.match(r"(\w+) = (?!\[\]$)", line):
            assert re.search(rf"^  {re.escape(table + key[1])} +\w+ +\w.*\n +.*default ", listed, re.MULTILINE), key[1]
