"""Every input that cannot be used ends with its exit code, the place of the mistake and a remedy, and costs no data."""

import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import BAD_INPUT, ROOT, SHORT, USAGE, assert_refused, plot, surefoot

_MAIN = (ROOT / "tools" / "scenarios" / "main.toml").read_bytes()
_MAIN_CUT = _MAIN[: _MAIN.index(b"original") + 4]  # within the string of line 'method = "original"'
_GARBAGE = bytes(range(256)) * 8

# What the file holds, where the mistake is (line and column, nothing for the file as a whole), what is said about it.
_SCENARIOS = {
    "empty": (b"", "", "is empty"),
    "only_a_comment": (b"# nothing\n", "", "is empty"),
    "truncated_in_a_string": (_MAIN_CUT, f":{len(_MAIN_CUT.splitlines())}:15", "is not TOML"),
    "truncated_in_a_table_name": (b"seed = 1\n[refl", ":2:6", "is not TOML"),
    "truncated_behind_a_key": (b"seed = 1\nduration_s =", ":2:", "is not TOML"),
    "latin_1": ("seed = 1\n# für\n".encode("latin-1"), ":2:3", "utf-8"),
    "utf_16": (_MAIN.decode().encode("utf-16"), ":1:1", "utf-8"),
    "binary": (_GARBAGE, ":1:1", "is not TOML"),
    "zero_byte": (b"seed = 1\0\n", ":1:9", "is not TOML"),
    "key_twice": (b"seed = 1\nseed = 2\n", ":2:8", "is not TOML"),
    "deep_key": (b".".join([b"a"] * 60000) + b" = 1\n", ":1:", "more than 1000 dots on a line"),
    "too_large": (b"# a log, perhaps\n" * 10000, "", "larger than 128 KiB"),
    "string_for_a_number": (b'\nduration_s = "20"\n', ":2:14", 'duration_s is the string "20"; expected a number'),
    "float_for_an_integer": (b"seed = 1.5\n", ":1:8", "seed is the float 1.5; expected an integer"),
    "number_for_a_table": (b"reflex = 1\n", ":1:10", "expected a table"),
    "table_for_an_array": (b"[payload]\nmass_kg = 5.0\n", ":1:1", "expected an array of tables"),
    "array_too_short": (b"[[payload]]\nposition_m = [0.2, 0.0]\n", ":2:14", "an array of 3 numbers"),
    "unknown_key": (b"seed = 1\nduration = 20\n", ":2:1", "did you mean duration_s?"),
    "unknown_key_in_a_table": (b'[reflex]\nmetod = "off"\n', ":2:1", "did you mean reflex.method?"),
    "unknown_key_of_a_payload": (b"[[payload]]\nmass = 5.0\n", ":2:1", "did you mean payload[0].mass_kg?"),
    "unknown_table": (b"seed = 1\n[weather]\nwind_m_s = 3.0\n", ":2:2", "weather is unknown"),
    "unknown_key_that_a_terminal_obeys": (b'"\\u001B[31mred" = 1\n', ":1:1", r"\x1B[31mred is unknown"),
    "unknown_choice": (b'plant = "moon"\n', ":1:9", 'one of "thesis", "nominal"'),
    "negative_mass": (b"[[payload]]\nat_s = 1.2\nmass_kg = -5\n", ":3:11", "mass_kg is -5; expected 0 to 60 kg"),
    "negative_mass_of_the_robot": (b"[mass]\ntrunk_kg = -50.0\n", ":2:12", "mass.trunk_kg is -50.0"),
    "nan": (b"[[payload]]\nmass_kg = nan\n", ":2:11", "payload[0].mass_kg is nan"),
    "nan_in_an_array": (b"[[payload]]\nposition_m = [0.2, nan, 0.0]\n", ":2:20", "position_m[1] is nan"),
    "infinite": (b"[floor]\nfriction = -inf\n", ":2:12", "floor.friction is -inf"),
    "duration_of_a_year": (b"duration_s = 31536000\n", ":1:14", "expected more than 0, up to 3600 s"),
    "duration_beyond_all_numbers": (b"duration_s = 1e400\n", ":1:", ""),
    "duration_beyond_all_integers": (b"duration_s = 99999999999999999999\n", ":1:", ""),
    "duration_infinite": (b"duration_s = inf\n", ":1:14", "duration_s is inf"),
    "duration_zero": (b"duration_s = 0\n", ":1:14", "expected more than 0"),
    "duration_negative": (b"duration_s = -20.0\n", ":1:14", "expected more than 0"),
    "seventeen_payloads": (b"[[payload]]\nmass_kg = 1.0\n" * 17, ":1:1", "at most 16"),
    "steps_that_do_not_fit": (b"[physics]\nstep_s = 0.0007\n", ":2:10", "divided by a whole number"),
}  # fmt: skip


@pytest.mark.parametrize("form", [[], ["--json"]], ids=["text", "json"])
@pytest.mark.parametrize(("content", "at", "said"), _SCENARIOS.values(), ids=_SCENARIOS.keys())
def test_bad_scenario_is_refused_before_anything_is_made(tmp_path: Path, content: bytes, at: str, said: str, form):
    scenario = tmp_path / "bad.toml"
    scenario.write_bytes(content)
    assert_refused(surefoot("run", scenario, "--out", tmp_path / "run", *form), BAD_INPUT, f"{scenario}{at}", said)
    assert not (tmp_path / "run").exists()


def test_all_mistakes_of_a_scenario_are_said_at_once(tmp_path: Path):
    scenario = tmp_path / "bad.toml"
    scenario.write_text("duration_s = -1\nsed = 1\n[floor]\nfriction = 3.0\n")
    finished = surefoot("run", scenario, "--out", tmp_path / "run")
    assert_refused(finished, BAD_INPUT, f"{scenario}:1:14", f"\n{scenario}:2:1", f"\n{scenario}:4:12")
    assert finished.stderr.count(b"  remedy: ") == 3


@pytest.mark.parametrize(
    ("name", "said"),
    [("missing.toml", "there is no such file"), (".", "is a directory"), ("/dev/zero", "larger than 128 KiB")],
)
def test_what_is_no_scenario_file_is_refused(tmp_path: Path, name: str, said: str):
    assert_refused(surefoot("run", name, cwd=tmp_path), BAD_INPUT, f"{name}: ", said)


def test_scenario_that_may_not_be_read_is_refused(tmp_path: Path, without_privilege: list[str]):
    scenario = tmp_path / "secret.toml"
    scenario.write_bytes(_MAIN)
    scenario.chmod(0)
    assert_refused(surefoot("run", scenario, prefix=without_privilege), BAD_INPUT, scenario, "Permission denied")


_OVERRIDES = {
    "no_equals_sign": ("duration_s", "expected key=value"),
    "no_key": ("=5", "expected key=value"),
    "no_value": ("duration_s=", "has no value"),
    "unknown_key": ("duration=5", "did you mean duration_s?"),
    "wrong_type": ("duration_s=long", 'duration_s is the string "long"; expected a number'),
    "out_of_range": ("payload.0.mass_kg=-5", "payload[0].mass_kg is -5; expected 0 to 60 kg"),
    "nan": ("floor.friction=nan", "floor.friction is nan"),
    "absurd_duration": ("duration_s=1e300", "expected more than 0, up to 3600 s"),
    "payload_that_is_not_there": ("payload.3.mass_kg=5", "payload[3] does not exist, there are 1"),
    "two_values": ("seed=1\nduration_s=1", "more than one TOML value"),
    "no_toml": ("seed=[1", "not a TOML value"),
}


@pytest.mark.parametrize(("override", "said"), _OVERRIDES.values(), ids=_OVERRIDES.keys())
def test_bad_override_is_refused_and_named(tmp_path: Path, override: str, said: str):
    finished = surefoot("run", "--set", override, "--json", cwd=tmp_path)
    assert_refused(finished, BAD_INPUT, "--set " + override.replace("\n", r"\x0A") + ": ", said)
    assert list(tmp_path.iterdir()) == []


_USAGE = {
    "nothing_at_all": ([], "surefoot: ", "subcommand is required"),
    "unknown_subcommand": (["walk"], "surefoot: ", "walk is no subcommand"),
    "unknown_option": (["--fast"], "surefoot: ", "--fast is no option"),
    "unknown_option_of_run": (["run", "--fast"], "surefoot run: ", "--fast"),
    "two_scenarios": (["run", "a.toml", "b.toml"], "surefoot run: ", "b.toml"),
    "set_without_argument": (["run", "--set"], "surefoot run: ", "--set"),
    "scenario_without_name": (["run", ""], "surefoot run: ", "is empty"),
    "folder_without_name": (["run", "--out", ""], "surefoot run: ", "is empty"),
    "folder_that_is_not_recorded_into": (["run", "--out", "x", "--no-record"], "surefoot run: ", "excludes"),
    "live_without_recorder": (["run", "--live", "--no-record"], "surefoot run: ", "excludes"),
    "overwrite_what": (["run", "--overwrite"], "surefoot run: ", "requires --out"),
    "pace_is_no_number": (["run", "--pace", "fast"], "surefoot run: ", "expected 0, or 0.01 to 1000"),
    "pace_is_nan": (["run", "--pace", "nan"], "surefoot run: ", "expected 0, or 0.01 to 1000"),
    "pace_stands_still": (["run", "--pace", "1e-300"], "surefoot run: ", "expected 0, or 0.01 to 1000"),
    "replay_of_nothing": (["replay"], "surefoot replay: ", "required"),
    "replay_of_two": (["replay", "a", "b"], "surefoot replay: ", "b"),
}


@pytest.mark.parametrize(("arguments", "place", "said"), _USAGE.values(), ids=_USAGE.keys())
def test_wrong_usage_is_refused(tmp_path: Path, arguments: list[str], place: str, said: str):
    assert_refused(surefoot(*arguments, cwd=tmp_path), USAGE, place, said, "--help")
    assert list(tmp_path.iterdir()) == []


def _cut(path: Path, size: int) -> None:
    path.write_bytes(path.read_bytes()[:size])


def _spoil_line_3(path: Path) -> None:
    lines = path.read_bytes().split(b"\n")
    lines[2] = b"(0.000000) can0 181##1ZZ\x1b[31m\xff"
    path.write_bytes(b"\n".join(lines))


# What was done to the run folder, the place that is named, what is said about it.
_RUN_FOLDERS: dict[str, tuple[Callable[[Path], object], str, str]] = {
    "missing": (shutil.rmtree, "scenario.toml: ", "there is no such file"),
    "no_log": (lambda run: (run / "bus.log").unlink(), "bus.log: ", "there is no such file"),
    "log_is_a_directory": (lambda run: ((run / "bus.log").unlink(), (run / "bus.log").mkdir()), "bus.log: ", "no such"),
    "log_is_empty": (lambda run: _cut(run / "bus.log", 0), "bus.log: ", "holds no whole tick"),
    "log_ends_in_the_first_line": (lambda run: _cut(run / "bus.log", 20), "bus.log: ", "holds no whole tick"),
    "log_ends_in_the_first_tick": (lambda run: _cut(run / "bus.log", 150), "bus.log: ", "holds no whole tick"),
    "log_is_garbled": (lambda run: _spoil_line_3(run / "bus.log"), "bus.log:3: ", "can0 181##1ZZ.[31m."),
    "log_is_binary": (lambda run: (run / "bus.log").write_bytes(_GARBAGE), "bus.log:1: ", "not a CAN FD frame"),
    "scenario_is_empty": (lambda run: _cut(run / "scenario.toml", 0), "scenario.toml: ", "is empty"),
    "scenario_is_garbled": (lambda run: (run / "scenario.toml").write_bytes(b"seed 1"), "scenario.toml:1:", "not TOML"),
}


@pytest.mark.parametrize(("damage", "place", "said"), _RUN_FOLDERS.values(), ids=_RUN_FOLDERS.keys())
def test_run_folder_that_cannot_be_replayed_is_refused(tmp_path: Path, short_run: Path, damage, place: str, said: str):
    run = tmp_path / "run"
    shutil.copytree(short_run, run)
    damage(run)
    assert_refused(surefoot("replay", run), BAD_INPUT, f"{run / place}", said)


def test_log_that_is_cut_in_a_line_replays_up_to_its_last_whole_tick(tmp_path: Path, short_run: Path):
    run = tmp_path / "run"
    shutil.copytree(short_run, run)
    _cut(run / "bus.log", 100_000)
    finished = surefoot("replay", run)
    assert finished.returncode == 0, finished.stderr
    assert b" 0 differ\n" in finished.stdout and b"middle of a tick" in finished.stdout


def test_plot_of_what_is_no_run_is_refused(tmp_path: Path):
    (tmp_path / "telemetry.lcmlog").touch()
    assert_refused(plot(tmp_path / "missing"), BAD_INPUT, f"plot: {tmp_path / 'missing'}", "no such file")
    assert_refused(plot(tmp_path), BAD_INPUT, f"plot: {tmp_path}/telemetry.lcmlog", "holds no message")
