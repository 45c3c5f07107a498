"""`surefoot doctor` on this machine, whatever it has, and on what is left of it without network, rights or room."""

import json
import os
import shutil
from pathlib import Path

import pytest
from command_line import MACHINE_LACKS, ROOT, surefoot

_FIELDS = {"check": str, "purpose": str, "required": bool, "status": str, "detail": str, "remedy": str}
_NOBODY = ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups", "--inh-caps=-all", "--bounding-set=-all"]


def _checks(*, code: int = 0, **options: object) -> dict[str, dict]:
    """What `doctor --json` finds, by name."""
    finished = surefoot("doctor", "--json", **options)
    assert finished.returncode == code, finished.stdout.decode() + finished.stderr.decode()
    assert finished.stderr == b""
    found = json.loads(finished.stdout)
    checks = {check["check"]: check for check in found}
    assert len(checks) == len(found), "a name stands for two checks"
    return checks


@pytest.fixture(scope="module")
def checks() -> dict[str, dict]:
    return _checks(cwd=ROOT)


def test_every_check_has_the_same_fields_and_every_one_that_is_not_ok_a_remedy(checks: dict[str, dict]):
    for check in checks.values():
        assert {name: type(value) for name, value in check.items()} == _FIELDS
        assert check["status"] in ("ok", "warning", "missing")
        assert check["detail"] and all(character.isprintable() for character in check["detail"]), check
        assert bool(check["remedy"]) == (check["status"] != "ok"), check


def test_the_text_says_the_same_as_the_json(checks: dict[str, dict]):
    finished = surefoot("doctor", cwd=ROOT)
    assert finished.returncode == 0 and finished.stderr == b""
    lines = finished.stdout.decode().splitlines()
    word = {"ok": "OK", "warning": "WARN", "missing": "MISSING"}
    for name, check in checks.items():
        shown = [index for index, line in enumerate(lines) if line[11:].startswith(name + "  ")]
        assert len(shown) == 1, name
        assert lines[shown[0]].split()[0] == word[check["status"]]
        below = lines[shown[0] + 1].strip()
        assert below.startswith("remedy: ") == (check["status"] != "ok")
    assert sum("remedy: " in line for line in lines) == sum(check["status"] != "ok" for check in checks.values())


def test_what_it_says_of_programs_and_files_is_so(checks: dict[str, dict]):
    everywhere = os.environ["PATH"] + ":/usr/sbin:/sbin"
    programs = ("candump", "cansend", "canplayer", "canbusload")
    has_all = all(shutil.which(program, path=everywhere) for program in programs)
    assert (checks["can-utils"]["status"] == "ok") == has_all
    assert checks["Python environment"]["status"] == "ok", "this test runs in it"
    jars = all(Path(f"/usr/share/java/{jar}.jar").exists() for jar in ("lcm", "jchart2d"))
    assert jars or checks["lcm-spy"]["status"] == "missing"


def test_a_network_without_a_route_fails_the_self_tests_and_names_the_commands(in_own_network: list[str]):
    checks = _checks(prefix=in_own_network, cwd=ROOT)
    for name in ("multicast route", "LCM self test", "UDP bus self test"):
        assert checks[name]["status"] == "missing", checks[name]
        assert "ip link set lo up" in checks[name]["remedy"]


def test_following_the_remedy_for_multicast_mends_all_three(in_own_network: list[str]):
    remedy = _checks(prefix=in_own_network, cwd=ROOT)["multicast route"]["remedy"]
    obey = ["sh", "-c", 'eval "$1"; shift; exec "$@"', "sh", remedy.removeprefix("sudo ")]
    checks = _checks(prefix=[*in_own_network, *obey], cwd=ROOT)
    for name in ("multicast route", "LCM self test", "UDP bus self test"):
        assert checks[name]["status"] == "ok", checks[name]


@pytest.mark.skipif(os.geteuid() != 0, reason="only root can become nobody")
def test_an_ordinary_user_is_told_how_to_get_real_time_rights():
    tried = surefoot("--help", prefix=_NOBODY, cwd="/")
    if tried.returncode != 0:
        pytest.skip(f"nobody cannot run the binary where it is: {tried.stderr.decode().strip()}")
    checks = _checks(prefix=["prlimit", "--rtprio=0:0", "--memlock=0:0", *_NOBODY], cwd="/tmp")
    assert checks["SCHED_FIFO, rtprio"]["status"] == "missing"
    assert checks["SCHED_FIFO, rtprio"]["remedy"].startswith("sudo setcap cap_sys_nice,cap_ipc_lock=ep /")
    assert checks["memlock"]["status"] == "missing"
    assert "ulimit -l unlimited" in checks["memlock"]["remedy"]


def test_without_a_place_for_runs_the_exit_code_says_so(tmp_path: Path, without_privilege: list[str]):
    tmp_path.chmod(0o555)
    checks = _checks(code=MACHINE_LACKS, prefix=without_privilege, cwd=tmp_path)
    assert checks["run folders"]["status"] == "missing" and checks["run folders"]["required"]
    finished = surefoot("doctor", prefix=without_privilege, cwd=tmp_path)
    assert finished.returncode == MACHINE_LACKS
    assert finished.stdout.decode().splitlines()[-1].startswith("surefoot run lacks 1 ")


def test_it_leaves_nothing_behind(tmp_path: Path):
    _checks(cwd=tmp_path)
    assert list(tmp_path.iterdir()) == []
