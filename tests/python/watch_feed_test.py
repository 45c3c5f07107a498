"""What `surefoot watch` passes on to its pages, of made-up messages: run after run, halves of one run, garbage, floods."""

from pathlib import Path

import numpy as np
import pytest
from command_line import binary

from tools.plots.messages import message_types
from tools.watch.feed import Feed
from tools.watch.listener import Heard
from tools.watch.live_run import rows


class _Listener:
    """Hears what a test puts into it."""

    def __init__(self) -> None:
        self.heard = Heard()

    def take(self) -> Heard:
        heard, self.heard = self.heard, Heard()
        return heard


class _Page:
    def __init__(self) -> None:
        self.told: list[dict] = []
        self.shown: list[dict[int, bytes]] = []

    def tell(self, message: dict) -> None:
        self.told.append(message)

    begin = tell

    def show(self, newest: dict[int, bytes]) -> None:
        self.shown.append(newest)

    def runs(self) -> list[str]:
        return [message["run"]["name"] for message in self.told if message["what"] == "run"]


class _Watched:
    """A feed with one page, and what is said to the terminal."""

    def __init__(self) -> None:
        self.listener, self.page, self.said = _Listener(), _Page(), []
        self.feed = Feed(self.listener, Path(binary()), self.said.append)
        self.feed.add(self.page)
        self.now_s = 0.0

    def hears(self, newest: dict[str, bytes] | None = None, events: tuple[bytes, ...] = ()) -> None:
        self.listener.heard = Heard(dict(newest or {}), list(events))
        self.feed.step()


@pytest.fixture
def watched() -> _Watched:
    return _Watched()


def _announcement(folder: Path | str, started_ns: int) -> bytes:
    message = message_types().run_t()
    message.started_ns = started_ns
    message.folder = str(folder).encode().ljust(1024, b"\0")
    return message.encode()


def _event(time_s: float, name: str, value: float = 0.0) -> bytes:
    message = message_types().event_t()
    message.utime, message.name, message.value = round(time_s * 1e6), name.encode().ljust(24, b"\0"), value
    return message.encode()


def _truth(time_s: float, roll_rad: float) -> bytes:
    message = message_types().simulator_truth_t()
    message.utime, message.roll_rad = round(time_s * 1e6), roll_rad
    return message.encode()


def _run(folder: Path, scenario: str = "duration_s = 3.0\n") -> Path:
    folder.mkdir(parents=True)
    (folder / "scenario.toml").write_text(scenario)
    return folder


def test_a_row_holds_its_table_its_time_and_every_column() -> None:
    [(place, row)] = rows({"SUREFOOT_TRUTH": _truth(-1.25, 0.5)}).items()
    numbers = np.frombuffer(row, "<f8")
    assert numbers[0] == place and numbers[1] == -1.25
    assert list(numbers[2:]).count(0.5) == 1


@pytest.mark.parametrize("garbage", [b"", b"\0", b"x" * 7, b"\xff" * 2000, _event(1.0, "fell")])
def test_messages_of_another_kind_are_left_out(watched: _Watched, tmp_path: Path, garbage: bytes) -> None:
    run = _run(tmp_path / "run")
    watched.hears({"SUREFOOT_RUN": garbage, "SUREFOOT_STATE": garbage})
    assert watched.page.told == []
    watched.hears({"SUREFOOT_RUN": _announcement(run, 1)})
    watched.hears({"SUREFOOT_STATE": garbage, "SUREFOOT_TRUTH": _truth(1.0, 0.1)}, events=(garbage[:50],))
    assert watched.page.runs() == [str(run)]
    assert len(watched.page.shown[-1]) == 1, "the truth, and no state"
    assert all(message["what"] == "run" for message in watched.page.told)


def test_every_event_is_passed_on_and_a_late_page_hears_of_them_too(watched: _Watched, tmp_path: Path) -> None:
    watched.hears({"SUREFOOT_RUN": _announcement(_run(tmp_path / "run"), 1)})
    watched.hears(events=(_event(1.0, "settled"), _event(2.0, "fell", float("nan"))))
    told = [message["event"] for message in watched.page.told if message["what"] == "event"]
    assert [(event["time_s"], event["name"], event["value"]) for event in told] == [(1.0, "settled", 0.0), (2.0, "fell", None)]
    late = _Page()
    watched.feed.add(late)
    assert late.told[0]["run"]["events"] == told


def test_events_are_bounded(watched: _Watched, tmp_path: Path) -> None:
    watched.hears({"SUREFOOT_RUN": _announcement(_run(tmp_path / "run"), 1)})
    for _ in range(3):
        watched.hears(events=tuple(_event(0.001 * i, "settled") for i in range(900)))
    assert sum(message["what"] == "event" for message in watched.page.told) == 1000


def test_the_verdict_comes_once_and_a_damaged_one_never(watched: _Watched, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("tools.watch.feed._VERDICT_EVERY_S", 0.0)
    run = _run(tmp_path / "run")
    watched.hears({"SUREFOOT_RUN": _announcement(run, 1)})
    for damaged in ("[", "[" * 99999, '{"verdict": "walked", "distance_m": 1e999}'):
        (run / "verdict.json").write_text(damaged)
        watched.hears()
    assert all(message["what"] == "run" for message in watched.page.told)
    (run / "verdict.json").write_text('{"verdict": "walked"}')
    watched.hears()
    watched.hears()
    assert [message["what"] for message in watched.page.told] == ["run", "verdict"]


def _ends(run: Path) -> None:
    (run / "verdict.json").write_text('{"verdict": "walked"}')


def test_the_next_run_takes_the_page_and_an_old_one_never_again(watched: _Watched, tmp_path: Path) -> None:
    first, second = _run(tmp_path / "a"), _run(tmp_path / "b")
    watched.hears({"SUREFOOT_RUN": _announcement(first, 1)})
    _ends(first)
    for folder, started_ns in ((second, 2), (first, 1), (second, 2)):
        watched.hears({"SUREFOOT_RUN": _announcement(folder, started_ns)}, events=(_event(1.0 * started_ns, "settled"),))
    assert watched.page.runs() == [str(first), str(second)], "at once, though the scenario is the same"
    told = [message["event"]["time_s"] for message in watched.page.told if message["what"] == "event"]
    assert told == [2.0, 1.0, 2.0], "none is lost"


def test_the_same_folder_again_is_another_run(watched: _Watched, tmp_path: Path) -> None:
    run = _run(tmp_path / "a")
    for started_ns in (1, 2):
        watched.hears({"SUREFOOT_RUN": _announcement(run, started_ns)})
    assert watched.page.runs() == [str(run), str(run)]


def test_rows_heard_with_the_first_word_of_a_run_are_left_out(watched: _Watched, tmp_path: Path) -> None:
    first, second = _run(tmp_path / "a"), _run(tmp_path / "b")
    watched.hears({"SUREFOOT_RUN": _announcement(first, 1)})
    _ends(first)
    watched.hears({"SUREFOOT_RUN": _announcement(second, 2), "SUREFOOT_TRUTH": _truth(30.0, 0.1)})
    assert watched.page.shown[-1] == {}
    watched.hears({"SUREFOOT_TRUTH": _truth(-12.0, 0.1)})
    assert len(watched.page.shown[-1]) == 1


def test_two_runs_at_once_are_not_shown_by_turns_and_the_terminal_says_so(watched: _Watched, tmp_path: Path) -> None:
    first, second = _run(tmp_path / "a"), _run(tmp_path / "b", "duration_s = 4.0\n")
    for _ in range(3):
        watched.hears({"SUREFOOT_RUN": _announcement(first, 1)})
        watched.hears({"SUREFOOT_RUN": _announcement(second, 2)})
    assert watched.page.runs() == [str(first)]
    assert len([line for line in watched.said if str(second) in line]) == 1
    _ends(first)
    watched.hears({"SUREFOOT_RUN": _announcement(second, 2)})
    assert watched.page.runs() == [str(first), str(second)]


def test_a_run_after_a_killed_one_of_its_scenario_keeps_its_first_events(
    watched: _Watched, tmp_path: Path, monkeypatch
) -> None:
    killed, next_one = _run(tmp_path / "a"), _run(tmp_path / "b")
    watched.hears({"SUREFOOT_RUN": _announcement(killed, 1)})
    watched.hears({"SUREFOOT_RUN": _announcement(next_one, 2)})
    watched.hears(events=(_event(-9.0, "standing_done"),))
    monkeypatch.setattr("tools.watch.feed._SILENT_S", -1.0)
    watched.hears({"SUREFOOT_RUN": _announcement(next_one, 2)})
    begun = watched.page.told[-1]["run"]
    assert begun["name"] == str(next_one) and [event["name"] for event in begun["events"]] == ["standing_done"]


def test_two_processes_with_one_scenario_are_one_run(watched: _Watched, tmp_path: Path) -> None:
    firmware, robot = _run(tmp_path / "firmware"), _run(tmp_path / "robot")
    for _ in range(3):
        watched.hears({"SUREFOOT_RUN": _announcement(firmware, 1)})
        watched.hears({"SUREFOOT_RUN": _announcement(robot, 2)})
    _ends(firmware)
    watched.hears({"SUREFOOT_RUN": _announcement(robot, 2)})
    assert watched.page.runs() == [str(firmware)], "the half that still speaks does not empty the page"


def test_the_other_half_takes_over_when_one_is_silent(watched: _Watched, tmp_path: Path, monkeypatch) -> None:
    firmware, robot = _run(tmp_path / "firmware"), _run(tmp_path / "robot")
    watched.hears({"SUREFOOT_RUN": _announcement(firmware, 1)})
    monkeypatch.setattr("tools.watch.feed._SILENT_S", -1.0)
    watched.hears({"SUREFOOT_RUN": _announcement(robot, 2)})
    assert watched.page.runs() == [str(firmware), str(robot)]


def test_a_folder_that_cannot_be_looked_at_breaks_nothing(watched: _Watched) -> None:
    watched.hears({"SUREFOOT_RUN": _announcement("/" + "x" * 300, 1)})
    watched.hears({"SUREFOOT_TRUTH": _truth(1.0, 0.1)})
    assert len(watched.page.shown[-1]) == 1


def test_what_json_has_no_word_for_is_none(watched: _Watched, tmp_path: Path) -> None:
    faults = "[[fault]]\nfor_s = inf\nat = 2026-01-31\nkind = 'x'\n"
    watched.hears({"SUREFOOT_RUN": _announcement(_run(tmp_path / "a", faults), 1)})
    assert watched.page.told[-1]["run"]["faults"] == [{"for_s": None, "at": "2026-01-31", "kind": "x"}]


def test_a_run_without_a_readable_scenario_is_told_or_shown_without_its_robot(watched: _Watched, tmp_path: Path) -> None:
    watched.hears({"SUREFOOT_RUN": _announcement(_run(tmp_path / "damaged", "duration_s = = 3"), 1)})
    assert watched.page.runs() == [] and "scenario.toml" in watched.said[0] and "  remedy: " in watched.said[0]
    watched.hears({"SUREFOOT_RUN": _announcement(tmp_path / "gone", 2)})
    assert watched.page.told[-1]["run"]["model"] is None
    watched.hears({"SUREFOOT_RUN": _announcement("not/absolute", 3)})
    assert len(watched.page.runs()) == 1
