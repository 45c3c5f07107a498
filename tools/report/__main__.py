"""surefoot report RUN [OTHER]: see --help."""

import argparse
import json
import os
import sys
import time
from pathlib import Path

from tools.plots.messages import MissingGeneratorError
from tools.plots.read_run import RunFolderError
from tools.report.blocks import Blocks
from tools.report.pack_run import pack_run
from tools.report.page import page
from tools.viewer_bundle import ViewerError

_BAD_INPUT, _MACHINE_LACKS = 65, 69
_BINARY = Path(__file__).resolve().parents[2] / "build" / "release" / "tools" / "surefoot"


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> None:
        sys.stderr.write(f"surefoot report: {message}\n  remedy: see tools/surefoot report --help\n")
        sys.exit(64)


def _arguments(given: list[str]) -> argparse.Namespace:
    parser = _Parser(
        prog="surefoot report",
        description="Writes a recorded run as one HTML file: verdict, time line, plots, 3-D replay, bus, scenario.",
        epilog="It opens in any current browser, offline. Two runs are shown on one time axis, the second one ghostly.\n"
        "Values are quantised to 1/65534 of each column's range; the run folder holds them in full.\n"
        "Exit codes: 0, 64 usage, 65 no run there, 69 something the machine lacks.\n"
        "Examples:\n"
        "  tools/surefoot report runs/demo\n"
        "  tools/surefoot report runs/with_reflex runs/without_reflex --out compared.html\n"
        "  tools/surefoot report runs/demo --no-frames --json",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("run", type=Path, metavar="RUN", help="folder that `surefoot run --out RUN` wrote")
    parser.add_argument("other", type=Path, metavar="OTHER", nargs="?", help="another one to compare with")
    parser.add_argument("--out", type=Path, metavar="FILE", help="default: RUN/report.html, or RUN/report_vs_OTHER.html")
    parser.add_argument("--no-frames", action="store_true", help="leave the frames of bus.log out: half the size")
    parser.add_argument("--json", action="store_true", help="print file, size and time as JSON")
    return parser.parse_args(given)


def _default_file(arguments: argparse.Namespace) -> Path:
    if arguments.other is None:
        return arguments.run / "report.html"
    return arguments.run / f"report_vs_{arguments.other.resolve().name}.html"


def _fail(code: int, message: object) -> int:
    print(message, file=sys.stderr)
    return code


def main(given: list[str]) -> int:
    """Returns the exit code."""
    arguments = _arguments(given)
    binary = Path(os.environ.get("SUREFOOT_BINARY", _BINARY))
    folders = [arguments.run, *([arguments.other] if arguments.other else [])]
    file = arguments.out or _default_file(arguments)
    started_s = time.monotonic()
    blocks = Blocks()
    try:
        runs = []
        for number, folder in enumerate(folders):
            if sys.stderr.isatty():
                print(f"\rreport: reading {folder}\033[K", end="", file=sys.stderr, flush=True)
            runs.append(pack_run(blocks, f"r{number}", folder, str(folder), binary, not arguments.no_frames))
        title = " against ".join(str(folder) for folder in folders)
        index = {"format": 1, "mode": "report", "title": title, "runs": runs}
        file.write_text(page(f"Surefoot: {title}", index, blocks))
    except RunFolderError as error:
        return _fail(_BAD_INPUT, error)
    except (MissingGeneratorError, ViewerError) as error:
        return _fail(_MACHINE_LACKS, error)
    except OSError as error:
        return _fail(_MACHINE_LACKS, f"{file}: cannot be written: {error.strerror}\n  remedy: name another place by --out")
    finally:
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)
    size_bytes, elapsed_s = file.stat().st_size, time.monotonic() - started_s
    if arguments.json:
        print(json.dumps({"file": str(file), "size_bytes": size_bytes, "elapsed_s": round(elapsed_s, 3)}))
    else:
        print(f"{file}: {size_bytes / 1e6:.1f} MB in {elapsed_s:.1f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
