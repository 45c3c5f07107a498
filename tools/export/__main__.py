"""`tools/surefoot export RUN --to FORMAT`: writes a run in the format of another program."""

import argparse
import sys
from pathlib import Path

from tools.arguments import Parser
from tools.export.lcm_schema import SchemaError
from tools.export.run_files import read_run_files
from tools.export.to_mcap import write_mcap
from tools.export.to_rerun import MissingRerunError, write_rerun
from tools.export.to_tables import write_tables
from tools.plots.messages import MissingGeneratorError
from tools.plots.read_run import RunFolderError

_EXIT_BAD_INPUT, _EXIT_LACKS, _EXIT_INTERRUPTED = 65, 69, 130

# By format: what it becomes within the run folder.
_DEFAULT_OUT = {"mcap": "run.mcap", "rerun": "run.rrd", "csv": "csv", "parquet": "parquet"}


def _parser() -> argparse.ArgumentParser:
    parser = Parser(
        prog="surefoot export",
        description="Writes a recorded run for other programs. The logs in the run folder stay the primary record.",
        epilog="""\
Formats:
  mcap      one file for Foxglove and PlotJuggler: every message and every CAN frame
  rerun     one file for Rerun: scalars, events, the body's pose; without CAN frames
  csv       a folder: a file a channel, one of all CAN frames, one a CAN message decoded by the DBC
  parquet   the same as columns with types, for pandas and others

An interrupted run gives what was recorded until then. Exit codes: 0, 64 usage, 65 bad input,
69 something the machine lacks, 130 interrupted.
Examples:
  tools/surefoot export runs/demo --to mcap
  tools/surefoot export runs/demo --to parquet --no-can --out /tmp/demo
""",
    )
    parser.add_argument("run", type=Path, metavar="RUN", help="folder that `surefoot run --out` wrote")
    parser.add_argument("--to", required=True, choices=_DEFAULT_OUT, help="format")
    parser.add_argument("--out", type=Path, metavar="PATH", help="file or folder to write (default: in RUN)")
    parser.add_argument("--no-can", action="store_true", help="leave the CAN frames out")
    return parser


def _write(options: argparse.Namespace, out: Path) -> None:
    run = read_run_files(options.run, with_frames=not options.no_can and options.to != "rerun")
    if options.to in ("csv", "parquet"):
        write_tables(run, out, options.to)
        return
    # Complete before it gets its name: an export that fails leaves nothing that looks like one.
    unfinished = out.with_name(f".{out.name}.part")
    try:
        {"mcap": write_mcap, "rerun": write_rerun}[options.to](run, unfinished)
        unfinished.replace(out)
    finally:
        unfinished.unlink(missing_ok=True)


def main(arguments: list[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    out = options.out or options.run / _DEFAULT_OUT[options.to]
    try:
        _write(options, out)
        print(out)
    except (RunFolderError, SchemaError) as error:
        print(f"export: {error}", file=sys.stderr)
        return _EXIT_BAD_INPUT
    except OSError as error:
        place = error.filename or out
        print(f"export: {place}: {error.strerror}\n  remedy: give another --out, or free disk space", file=sys.stderr)
        return _EXIT_LACKS
    except (MissingGeneratorError, MissingRerunError) as error:
        print(f"export: {error}", file=sys.stderr)
        return _EXIT_LACKS
    except KeyboardInterrupt:
        print("export: interrupted\n  remedy: export again; the run itself is untouched", file=sys.stderr)
        return _EXIT_INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main())
