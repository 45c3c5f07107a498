"""Pictures: from a run folder that is made up, whole, cut short, or none at all."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
from synthetic_run import EVENTS, write_synthetic_run

from tools.plots import look
from tools.plots.__main__ import FIGURES, main
from tools.plots.event_labels import stack_labels
from tools.plots.figures import payload_force
from tools.plots.read_run import RunFolderError, read_run
from tools.plots.time_figure import default_window, phase_spans

_PNG_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def test_every_picture_is_drawn_into_the_run_folder(synthetic_run: Path):
    assert main([str(synthetic_run)]) == 0
    for name in FIGURES:
        assert (synthetic_run / f"{name}.png").read_bytes().startswith(_PNG_SIGNATURE)


def test_every_axis_names_its_unit(synthetic_run: Path):
    look.apply()
    run = read_run(synthetic_run)
    for name, module in FIGURES.items():
        figure = module.figure(run, default_window(run))
        for axis in figure.axes:
            assert axis.get_ylabel().rstrip().endswith(("(m)", "(deg)", "(N)", "(N m)")), f"{name}: {axis.get_ylabel()}"
        assert figure.axes[-1].get_xlabel() == "time (s)"
        plt.close(figure)


def test_no_two_event_labels_overlap_and_none_leaves_the_picture(synthetic_run: Path):
    look.apply()
    run = read_run(synthetic_run)
    figure = FIGURES["torso_angles"].figure(run, default_window(run))
    figure.canvas.draw()
    boxes = [text.get_window_extent() for text in figure.axes[0].texts]
    # The box of an annotation includes its leader: compare the text rows only.
    rows = [(box.x0, box.x1, box.y1) for box in boxes]
    plt.close(figure)
    assert len(rows) == len(EVENTS)
    for i, (left, right, top) in enumerate(rows):
        assert right <= figure.bbox.x1
        assert not any(other[0] < right and left < other[1] and abs(other[2] - top) < 8.0 for other in rows[i + 1 :])


def test_the_trigger_stands_on_the_filtered_force(synthetic_run: Path):
    look.apply()
    run = read_run(synthetic_run)
    figure = payload_force.figure(run, default_window(run))
    (trigger,) = [line for line in figure.axes[0].lines if line.get_label() == "trigger"]
    plt.close(figure)
    assert list(trigger.get_xdata()) == [1.2625]
    at_trigger_n = np.interp(1.2625, run.state["time_s"], run.state["filtered_force_n"])
    assert list(trigger.get_ydata()) == pytest.approx([at_trigger_n])


def test_messages_come_back_as_they_were_written(synthetic_run: Path):
    run = read_run(synthetic_run)
    assert [(e.code, e.name, e.value) for e in run.events] == [(code, name, value) for _, code, name, value in EVENTS]
    assert run.state["foot_reference_m"].shape == (len(run.state["time_s"]), 2, 3)
    assert run.truth["torque_nm"].shape[1:] == (2, 6)
    assert run.torque_limit_nm == 200.0


def test_a_log_that_ends_inside_a_message_gives_the_whole_ones(tmp_path: Path):
    folder = write_synthetic_run(tmp_path / "cut", end_s=2.0)
    log = folder / "telemetry.lcmlog"
    log.write_bytes(log.read_bytes()[:-100])
    (folder / "verdict.json").unlink()
    assert read_run(folder).state["time_s"][-1] == pytest.approx(2.0, abs=0.01)
    assert main([str(folder), "--only", "overview"]) == 0


def test_a_run_that_ended_during_start_up_is_drawn_as_far_as_it_went(tmp_path: Path):
    folder = write_synthetic_run(tmp_path / "early", end_s=-1.0)
    assert main([str(folder)]) == 0


@pytest.mark.parametrize("content", [None, b"", b"no log at all"])
def test_a_folder_without_a_log_is_bad_input_and_says_what_to_do(tmp_path: Path, capsys, content: bytes | None):
    if content is not None:
        (tmp_path / "telemetry.lcmlog").write_bytes(content)
    with pytest.raises(RunFolderError):
        read_run(tmp_path)
    assert main([str(tmp_path)]) == 65
    message = capsys.readouterr().err
    assert str(tmp_path) in message and "remedy:" in message


def test_a_window_without_data_is_bad_input(synthetic_run: Path, capsys):
    assert main([str(synthetic_run), "--from", "100", "--to", "200"]) == 65
    assert "remedy:" in capsys.readouterr().err


def test_a_wrong_argument_is_a_usage_error(synthetic_run: Path):
    with pytest.raises(SystemExit) as stopped:
        main([str(synthetic_run), "--only", "nonsense"])
    assert stopped.value.code == 64


def test_phase_spans_touch_and_cover_the_time():
    spans = phase_spans(np.array([0.0, 1.0, 2.0, 3.0, 4.0]), np.array([1, 1, 2, 3, 3]))
    assert spans == [(0.0, 2.0, 1), (2.0, 3.0, 2), (3.0, 4.0, 3)]


# A label stands above every later one whose mark lies under it.
@pytest.mark.parametrize(
    ("positions", "widths", "levels"),
    [
        ([], [], []),
        ([0.0, 5.0], [1.0, 1.0], [0, 0]),
        ([0.0, 0.5, 0.9], [1.0, 1.0, 1.0], [2, 1, 0]),
        ([0.0, 0.5, 1.2], [1.0, 1.0, 1.0], [2, 1, 0]),
        ([0.0, 0.0], [1.0, 1.0], [1, 0]),
        ([0.0, 2.0, 2.5], [1.0, 1.0, 1.0], [0, 1, 0]),
    ],
)
def test_labels_are_stacked_without_crossing_a_leader(positions, widths, levels):
    assert stack_labels(positions, widths) == levels
