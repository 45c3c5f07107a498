"""Runs ranges of a sweep's rows on a Dask cluster; prints the lines of finished rows as they come.

Usage: dask_rows.py SCHEDULER PROGRAM SWEEP.toml FIRST-LAST...
`surefoot sweep --executor dask` starts it. PROGRAM and SWEEP.toml are paths that every worker can open.
"""

import signal
import subprocess
import sys

from dask.distributed import Client, as_completed
from distributed.scheduler import KilledWorker

_PATIENCE_S = 10
_MACHINE_LACKS = 69


def run_rows(program: str, sweep: str, rows: str) -> tuple[int, str, str]:
    """On a worker: the rows' lines; the same each time, so that it may run more than once."""
    command = [program, "sweep-rows", sweep, "--rows", rows, "--jobs", "1"]
    finished = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    return finished.returncode, finished.stdout, finished.stderr


def fail(message: str, remedy: str) -> int:
    print(f"dask: {message}\n  remedy: {remedy}", file=sys.stderr)
    return _MACHINE_LACKS


def main(scheduler: str, program: str, sweep: str, ranges: list[str]) -> int:
    try:
        client = Client(scheduler, timeout=_PATIENCE_S)
    except (OSError, ValueError) as error:
        return fail(f"no scheduler at {scheduler}: {error}", "start one with `dask scheduler`, or correct --scheduler")
    with client:
        try:
            client.wait_for_workers(1, timeout=_PATIENCE_S)
        except TimeoutError:
            return fail(f"the scheduler at {scheduler} has no worker", f"start some with `dask worker {scheduler}`")
        # Not pure: an earlier result of the same call may be that of another build.
        futures = [client.submit(run_rows, program, sweep, rows, pure=False) for rows in ranges]
        for future in as_completed(futures):
            try:
                returned, lines, messages = future.result()
            except KilledWorker as error:
                return fail(str(error), "see why workers die, for example of too little memory")
            if returned != 0:
                return fail(f"{program} ended with {returned} on a worker: {messages.strip()}",
                            "program and sweep need the same path on every worker")  # fmt: skip
            sys.stdout.write(lines)
            sys.stdout.flush()
            future.release()
    return 0


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    sys.exit(main(*sys.argv[1:4], sys.argv[4:]))
