"""`surefoot plan`: the paper's gait retuned, gait files, pictures, and refusals that name what is next to feasible."""

import csv
import json
import tomllib
from pathlib import Path

import pytest
from command_line import BAD_INPUT, MACHINE_LACKS, ROOT, USAGE, assert_refused, surefoot

INFEASIBLE = 2
KHR2 = ROOT / "tools" / "plans" / "khr2.toml"


def _json(*arguments: object) -> dict:
    return json.loads(surefoot("plan", *arguments, "--json").stdout)


def test_the_papers_gait_is_retuned_and_each_turn_is_said():
    result = _json()
    assert result["is_feasible"] and result["before"]["broken"] == "knee"
    turns = result["turns"]
    assert len(turns) >= 10 and turns[-1]["change"] == ""
    assert all(turn["change"] and turn["broken"] != "none" for turn in turns[:-1])
    gait = result["after"]["gait"]
    assert abs(gait["com_height_m"] - 0.86) <= 0.011 and abs(gait["double_support_s"] - 0.3) <= 0.01
    text = surefoot("plan").stdout.decode()
    assert all(turn["change"] in text for turn in turns) and "Feasible" in text


def test_the_request_that_ships_is_the_same_as_no_request():
    assert surefoot("plan", ROOT / "tools" / "plans" / "paper.toml").stdout == surefoot("plan").stdout


def test_without_compensation_an_infeasible_gait_ends_with_its_own_exit_code():
    finished = surefoot("plan", "--no-compensation", "--json")
    assert finished.returncode == INFEASIBLE
    assert finished.stderr.startswith(b"surefoot plan: infeasible (knee): a leg is too short")
    nearest = json.loads(finished.stdout)["nearest_feasible"]
    changes = [word for remedy in nearest for word in ("--set", f"{remedy['key']}={remedy['value']}")]
    assert surefoot("plan", "--no-compensation", *changes).returncode == 0


@pytest.mark.parametrize(
    ("overrides", "constraint", "key"),
    [
        (["limits.friction=0"], "friction", "limits.friction"),
        (["limits.zmp_margin_m=0.3"], "zmp", "limits.zmp_margin_m"),
        (["body.link_m=0.1"], "knee", "body.link_m"),
        (["foot.toe_angle_deg=30"], "clearance", "foot.top_z_m"),
        (["pattern=rolled_together", "compensation.longest_single_support_s=0.6"], "zmp", "limits.zmp_margin_m"),
    ],
)
def test_an_impossible_request_names_the_constraint_and_the_nearest_feasible_value(
    overrides: list[str], constraint: str, key: str
):
    arguments = [word for override in overrides for word in ("--set", override)]
    finished = surefoot("plan", *arguments, "--json")
    message = finished.stderr.decode()
    assert finished.returncode == INFEASIBLE, message
    assert message.startswith(f"surefoot plan: infeasible ({constraint}): ") and f" {key} at " in message
    (remedy,) = [remedy for remedy in json.loads(finished.stdout)["nearest_feasible"] if remedy["key"] == key]
    assert surefoot("plan", *arguments, "--set", f"{key}={remedy['value']}").returncode == 0


@pytest.mark.parametrize(
    ("text", "place", "said"),
    [
        ("[gait]\nsingle_support_s = -1\n", ":2:20: ", "gait.single_support_s is -1; expected 0.05 to 10 s"),
        ("[gait]\ncom_height_m = nan\n", ":2:16: ", "gait.com_height_m is nan"),
        ("[gait]\nstep_length_m = inf\n", ":2:17: ", "gait.step_length_m is inf"),
        ("[gait]\nstep_lenght_m = 0.5\n", ":2:1: ", "did you mean gait.step_length_m?"),
        ("pattern = 3\n", ":1:11: ", "the integer 3"),
        ('com_method = "luck"\n', ":1:14: ", '"luck"'),
        ("[body]\nthigh_kg = -5.0\n", ":2:12: ", "expected 0 to 100 kg"),
        ("[gait\n", ":1:", "is not TOML"),
    ],
)
def test_a_request_that_cannot_be_used_is_refused_with_its_line(tmp_path: Path, text: str, place: str, said: str):
    file = tmp_path / "gait.toml"
    file.write_text(text)
    assert_refused(surefoot("plan", file), BAD_INPUT, f"{file}{place}", said)


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["/nowhere.toml"], BAD_INPUT, "/nowhere.toml"),
        (["--set", "gait=5"], BAD_INPUT, "--set gait=5"),
        (["--speed", "-1"], USAGE, "surefoot plan: "),
        (["--speed", "nan"], USAGE, "surefoot plan: "),
        (["--speeds", "fast"], USAGE, "surefoot plan: "),
        (["--speeds", "0.1:0.2:0"], USAGE, "surefoot plan: "),
        (["--speed", "0.2", "--no-compensation"], USAGE, "surefoot plan: "),
        (["--out", "gait.toml"], USAGE, "surefoot plan: --out"),
        ([KHR2, "--speeds", "0.1:0.2:0.01", "--out", "gait.toml"], USAGE, "surefoot plan: --speeds"),
        ([KHR2, "--out", "/nowhere/gait.toml"], MACHINE_LACKS, "/nowhere/gait.toml"),
        (["--walk", "/nowhere.toml"], BAD_INPUT, "/nowhere.toml"),
        (["--walk", ROOT / "tools" / "scenarios" / "main.toml"], BAD_INPUT, f"{ROOT}/tools/scenarios/main.toml: has no"),
        (["--png", "/nowhere/plan.png"], MACHINE_LACKS, "/nowhere/plan.png"),
    ],
)
def test_what_cannot_be_done_is_refused(arguments: list, code: int, said: str):
    finished = surefoot("plan", *arguments)
    message = finished.stderr.decode()
    assert finished.returncode == code, message
    assert message.startswith(said) and "\n  remedy: " in message


def test_a_gait_file_holds_a_gait_for_each_speed(tmp_path: Path):
    file = tmp_path / "gaits.toml"
    finished = surefoot("plan", KHR2, "--speeds", "0.1:0.2:0.05", "--steps", "6", "--out", file, "--json")
    assert finished.returncode == 0, finished.stderr
    written, planned = tomllib.loads(file.read_text()), json.loads(finished.stdout)
    assert written["robot"] == "khr2"
    assert [gait["steps"] for gait in written["planned_gait"]] == [6, 6, 6]
    for gait, result in zip(written["planned_gait"], planned):
        assert gait["single_support_s"] == pytest.approx(result["after"]["gait"]["single_support_s"], abs=1e-6)
        step_s = gait["single_support_s"] + gait["double_support_s"]
        assert gait["step_length_m"] / step_s == pytest.approx(result["wanted_speed_m_s"], rel=1e-4)


@pytest.mark.parametrize("robot", ["khr2", "elkahlout"])
def test_a_gait_file_is_walked_to_its_end(robot: str, tmp_path: Path):
    file = tmp_path / "gait.toml"
    planned = surefoot("plan", "--set", f"robot={robot}", "--set", "gait.step_length_m=0.1", "--steps", 5, "--out", file)
    assert planned.returncode == 0, planned.stderr
    finished = surefoot("plan", "--walk", file, "--json")
    assert finished.returncode == 0, finished.stderr
    (walked,) = json.loads(finished.stdout)
    assert walked["verdict"] == "walked" and walked["steps"] >= 5
    assert walked["least_margin_m"] < walked["planned_margin_m"]
    run = surefoot("run", file, "--out", tmp_path / "run", "--json")
    assert run.returncode == 0, run.stderr


def test_a_walk_that_falls_ends_with_its_own_exit_code(tmp_path: Path):
    file = tmp_path / "pushed.toml"
    push = "[[push]]\nat_s = 2.0\nduration_s = 0.1\nforce_n = [0.0, 900.0, 0.0]\n"
    file.write_text((ROOT / "tools" / "scenarios" / "khr2_pattern1.toml").read_text() + push)
    finished = surefoot("plan", "--walk", file)
    assert finished.returncode == INFEASIBLE, finished.stderr
    assert b" fell " in finished.stdout


def test_samples_and_picture_are_written(tmp_path: Path):
    samples, picture = tmp_path / "step.csv", tmp_path / "plan.png"
    finished = surefoot("plan", "--csv", samples, "--png", picture, cwd=ROOT)
    assert finished.returncode == 0, finished.stderr
    assert picture.read_bytes().startswith(b"\x89PNG")
    rows = list(csv.DictReader(samples.open()))
    double = [row for row in rows if row["support"] == "double"]
    assert 0.15 < len(double) / len(rows) < 0.25
    for row in rows:
        assert float(row["support_rear_m"]) <= float(row["real_zmp_m"]) <= float(row["support_front_m"])


def test_the_patterns_are_compared():
    gaits = _json("--compare")
    assert len(gaits) == 9
    outside = {gait["pattern"] for gait in gaits if gait["margins"]["least_zmp_margin_m"] < 0.0}
    assert outside == {"rolled_together"}


def test_every_key_is_shown():
    shown = surefoot("plan", "--keys").stdout.decode()
    for key in ("gait.com_height_m", "foot.top_z_m", "body.ankle_height_m", "limits.friction", "compensation.slower"):
        assert f"  {key} " in shown
