"""A Dask scheduler and its workers on loopback, as processes of their own."""

import json
import signal
import subprocess
import sys
from pathlib import Path
from types import TracebackType

from command_line import wait_until

_DASK = Path(sys.executable).parent / "dask"


class DaskCluster:
    """Ends with its `with` block, and every process in it."""

    def __init__(self, folder: Path, workers: int) -> None:
        folder.mkdir()
        self._folder = folder
        self._count = workers
        self._processes: list[subprocess.Popen] = []

    def __enter__(self) -> "DaskCluster":
        file = self._folder / "scheduler.json"
        try:
            self._start("scheduler", "--port", "0", "--scheduler-file", file)
            wait_until(file.exists, 60.0)
            wait_until(lambda: file.read_text().endswith("}"), 60.0)
            self.address = json.loads(file.read_text())["address"]
            for _ in range(self._count):
                self._start("worker", self.address, "--no-nanny", "--nthreads", "1", "--local-directory", self._folder)
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, kind: type | None, error: BaseException | None, trace: TracebackType | None) -> None:
        self._end()

    def kill_a_worker(self) -> None:
        self._processes[-1].send_signal(signal.SIGKILL)

    def _start(self, *arguments: object) -> None:
        # By itself Dask would open a dashboard and listen on every interface.
        command = [_DASK, *map(str, arguments), "--host", "127.0.0.1", "--no-dashboard"]
        log = (self._folder / f"{len(self._processes)}.log").open("wb")
        with log:
            self._processes.append(subprocess.Popen(command, stdout=log, stderr=log))

    def _end(self) -> None:
        for process in self._processes:
            process.kill()
        for process in self._processes:
            process.wait()
