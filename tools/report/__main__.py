"""surefoot report RUN [OTHER], or SWEEP: see --help."""

import argparse
import json
import os
import sys
import time
from pathlib import Path
from urllib.parse import quote

from tools.arguments import Parser
from tools.binary import MissingBinaryError, surefoot_binary
from tools.plots.messages import MissingGeneratorError
from tools.plots.read_run import RunFolderError
from tools.report.blocks import Blocks
from tools.report.pack_run import pack_run
from tools.report.page import page
from tools.report.progress import Progress
from tools.report.record_rows import is_recorded, record_rows, report_of
from tools.report.sweep_map import is_sweep, map_index, read_results
from tools.viewer_bundle import ViewerError

_BAD_INPUT, _MACHINE_LACKS, _INTERRUPTED = 65, 69, 130
_FEW = 100  # rows that are recorded without being asked to


def _arguments(given: list[str]) -> argparse.Namespace:
    parser = Parser(
        prog="surefoot report",
        description="Writes a recorded run as one HTML file: verdict, time line, plots, 3-D replay, bus, scenario;\n"
        "or a sweep as a map whose cells open their runs.",
        epilog="It opens in any current browser, offline. Two runs are shown on one time axis, the second one ghostly.\n"
        "Values are quantised to 1/65534 of each column's range; the run folder holds them in full.\n"
        "A sweep's runs are not recorded: --runs does them again, to the last bit, and keeps\n"
        "the page of each below SWEEP/rows.\n"
        "Exit codes: 0, 64 usage, 65 no run there, 69 something the machine lacks, 130 interrupted.\n"
        "Examples:\n"
        "  tools/surefoot report runs/demo\n"
        "  tools/surefoot report runs/with_reflex runs/without_reflex --out compared.html\n"
        "  tools/surefoot report runs/demo --no-frames --json\n"
        "  tools/surefoot report runs/friction --runs failed",
    )
    parser.add_argument("run", type=Path, metavar="RUN", help="folder that `surefoot run` or `sweep --out` wrote")
    parser.add_argument("other", type=Path, metavar="OTHER", nargs="?", help="another run to compare with")
    parser.add_argument(
        "--out", type=Path, metavar="FILE", help="default: RUN/report.html, RUN/report_vs_OTHER.html, SWEEP/map.html"
    )
    parser.add_argument("--no-frames", action="store_true", help="leave the frames of bus.log out: half the size")
    parser.add_argument(
        "--runs", choices=("all", "failed", "none"),
        help=f"of a sweep: which runs to record, for its cells to open (default: all of up to {_FEW} rows, else none)",
    )  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print file, size and time as JSON")
    arguments = parser.parse_args(given)
    if is_sweep(arguments.run) and arguments.other is not None:
        parser.error("a sweep has a map of its own: it takes no OTHER")
    if arguments.runs and not is_sweep(arguments.run):
        parser.error(f"--runs is for sweeps; {arguments.run} has no results.csv")
    return arguments


def _default_file(arguments: argparse.Namespace) -> Path:
    if is_sweep(arguments.run):
        return arguments.run / "map.html"
    if arguments.other is None:
        return arguments.run / "report.html"
    return arguments.run / f"report_vs_{arguments.other.resolve().name}.html"


def _runs_page(arguments: argparse.Namespace, binary: Path) -> tuple[str, dict]:
    folders = [arguments.run, *([arguments.other] if arguments.other else [])]
    blocks, progress, runs = Blocks(), Progress("report: run"), []
    for number, folder in enumerate(folders):
        progress.show(number, len(folders))
        runs.append(pack_run(blocks, f"r{number}", folder, str(folder), binary, not arguments.no_frames))
    progress.end()
    title = " against ".join(str(folder) for folder in folders)
    return page(f"Surefoot: {title}", {"format": 1, "mode": "report", "title": title, "runs": runs}, blocks), {}


def _map_page(arguments: argparse.Namespace, binary: Path, file: Path) -> tuple[str, dict]:
    folder = arguments.run
    keys, rows = read_results(folder)
    which = arguments.runs or ("all" if len(rows) <= _FEW else "none")
    wanted = [row for row in rows if which == "all" or (which == "failed" and row["outcome"] != "walked")]
    missing = [row for row in wanted if not is_recorded(folder, row["row"])]
    progress = Progress("report: rows recorded:")
    progress.show(0, len(missing))
    try:
        record_rows(folder, missing, binary, lambda done: progress.show(done, len(missing)))
    finally:
        progress.end()
    reports = {
        row["row"]: quote(os.path.relpath(report_of(folder, row["row"]).resolve(), file.resolve().parent))
        for row in rows
        if is_recorded(folder, row["row"])
    }
    index = map_index(str(folder), keys, rows, reports)
    return page(f"Surefoot: {folder}", index, Blocks()), {"rows": len(rows), "rows_that_open": len(reports)}


def _fail(code: int, message: object) -> int:
    print(message, file=sys.stderr)
    return code


def main(given: list[str]) -> int:
    """Returns the exit code."""
    arguments = _arguments(given)
    file = arguments.out or _default_file(arguments)
    started_s = time.monotonic()
    try:
        binary = surefoot_binary()
        content, more = (
            _map_page(arguments, binary, file) if is_sweep(arguments.run) else _runs_page(arguments, binary)
        )
        file.write_text(content)
    except RunFolderError as error:
        return _fail(_BAD_INPUT, error)
    except (MissingBinaryError, MissingGeneratorError, ViewerError) as error:
        return _fail(_MACHINE_LACKS, error)
    except OSError as error:
        name = error.filename or file
        return _fail(_MACHINE_LACKS, f"{name}: {error.strerror}\n  remedy: name another place by --out")
    except KeyboardInterrupt:
        return _fail(_INTERRUPTED, "report: interrupted; rows recorded so far are kept")
    size_bytes, elapsed_s = file.stat().st_size, time.monotonic() - started_s
    if arguments.json:
        print(json.dumps({"file": str(file), "size_bytes": size_bytes, "elapsed_s": round(elapsed_s, 3), **more}))
    else:
        opens = f"; {more['rows_that_open']} of {more['rows']} runs open" if more else ""
        print(f"{file}: {size_bytes / 1e6:.1f} MB in {elapsed_s:.1f} s{opens}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
