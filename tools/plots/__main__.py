"""`tools/surefoot plot RUN...`: draws the pictures of run folders into them."""

import argparse
import sys
from pathlib import Path

import matplotlib.pyplot as plt

from tools.arguments import Parser
from tools.plots import look
from tools.plots.figures import controllers, foot_references, joint_torques, overview, payload_force, torso_angles, zmp
from tools.plots.messages import MissingGeneratorError
from tools.plots.read_run import Run, RunFolderError, read_run
from tools.plots.time_figure import Window, default_window

FIGURES = {
    "overview": overview,
    "foot_references": foot_references,
    "torso_angles": torso_angles,
    "payload_force": payload_force,
    "zmp": zmp,
    "joint_torques": joint_torques,
}

# Of runs whose robot walks on floors.
FLOOR_FIGURES = {"controllers": controllers}
_ALL = FIGURES | FLOOR_FIGURES

_EXIT_BAD_INPUT, _EXIT_LACKS = 65, 69


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="surefoot plot",
        description="Draws PNG pictures of recorded runs into their folders.",
        epilog="example: tools/surefoot plot runs/demo --from 0 --to 8",
    )
    parser.add_argument("runs", nargs="+", type=Path, metavar="RUN", help="folder that `surefoot run --out` wrote")
    parser.add_argument("--from", dest="start_s", type=float, metavar="S", help="scenario time at which to begin")
    parser.add_argument("--to", dest="end_s", type=float, metavar="S", help="scenario time at which to end")
    parser.add_argument("--only", choices=_ALL, action="append", help="draw this picture only; may be repeated")
    return parser


def _window(run: Run, start_s: float | None, end_s: float | None) -> Window:
    default_start_s, default_end_s = default_window(run)
    window = (default_start_s if start_s is None else start_s, default_end_s if end_s is None else end_s)
    recorded = run.state["time_s"]
    if not window[0] < window[1] or window[1] < recorded[0] or window[0] > recorded[-1]:
        raise RunFolderError(
            f"{run.folder}: nothing was recorded from {window[0]} to {window[1]} s\n"
            f"  remedy: choose --from and --to between {recorded[0]:.3f} and {recorded[-1]:.3f} s"
        )
    return window


def main(arguments: list[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    look.apply()
    try:
        for folder in options.runs:
            run = read_run(folder)
            window = _window(run, options.start_s, options.end_s)
            possible = _ALL if run.stabilizer else FIGURES
            for name in options.only or possible:
                picture = folder / f"{name}.png"
                figure = _ALL[name].figure(run, window)
                figure.savefig(picture)
                plt.close(figure)
                print(picture)
    except (RunFolderError, OSError) as error:
        print(f"plot: {error}", file=sys.stderr)
        return _EXIT_BAD_INPUT
    except MissingGeneratorError as error:
        print(f"plot: {error}", file=sys.stderr)
        return _EXIT_LACKS
    return 0


if __name__ == "__main__":
    sys.exit(main())
