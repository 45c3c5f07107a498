"""`surefoot floor-table --criteria`: one controller's row, what it refuses, and when a number is missed."""

import json

import pytest
from command_line import surefoot

_VIBRATION = ("floor-table", "--criteria", "--controller", "vibration_reduction")


def test_one_controller_is_measured_and_judged():
    finished = surefoot(*_VIBRATION, "--json")
    assert finished.returncode == 0 and finished.stderr == b""
    [row] = json.loads(finished.stdout)["rows"]
    assert row["controller"] == "vibration_reduction" and row["verdict"] == "holds"


def test_a_missed_number_is_told_by_the_exit_code():
    finished = surefoot(*_VIBRATION, "--set", "stabilizer.vibration_reduction_gain_s=0", "--csv")
    assert finished.returncode == 2
    assert b",not met," in finished.stdout and b"1 criteria miss their number" in finished.stderr


@pytest.mark.parametrize(("arguments", "exit_code", "words"), [
    (["--criteria", "--ablation"], 64, b"give one of --ablation, --criteria"),
    (["--criteria", "--png", "a.png"], 64, b"--png goes with --trace or --map"),
    (["--criteria", "--slope", "2"], 64, b"--criteria has its own floors"),
    (["--criteria", "--controller", "balance"], 64, b"the paper has no balance"),
    (["--criteria", "--seeds", "5-1"], 64, b"names no seeds"),
    (["--controller", "damping"], 64, b"--controller goes with --criteria"),
    (["--criteria", "--set", "stabilizer.damping_gain=1"], 65, b"stabilizer.damping_gain"),
])  # fmt: skip
def test_bad_input_is_refused_before_the_first_walk(arguments, exit_code, words):
    finished = surefoot("floor-table", *arguments)
    assert finished.returncode == exit_code
    assert finished.stdout == b"" and words in finished.stderr and b"remedy" in finished.stderr
