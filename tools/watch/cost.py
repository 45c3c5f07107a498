"""What a live page costs the loop: the same walk by turns without anybody listening, and with pages open.

    unshare -rn sh -c 'ip link set lo up; ip link set lo multicast on; ip route add 224.0.0.0/4 dev lo
      PYTHONPATH=. .venv/bin/python -m tools.watch.cost --rounds 8'
"""

import asyncio
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from tornado.websocket import websocket_connect

from tools.arguments import Parser
from tools.binary import surefoot_binary

_ROOT = Path(__file__).resolve().parents[2]
_OF_THE_LOOP = {min(os.sched_getaffinity(0))}
_OF_THE_PAGES = os.sched_getaffinity(0) - _OF_THE_LOOP or _OF_THE_LOOP
_THREADS_BEGIN_S = 0.3
# Nobody listens twice: what the two differ by is noise.
_NOBODY, _AGAIN, _PAGE, _BROWSES = _KINDS = (
    "nobody listens", "nobody listens, again", "surefoot watch and a page", "the same, and a browser draws",
)  # fmt: skip
_FIGURES = ("mean", "p50", "p999", "max")
_BROWSER = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--disable-accelerated-2d-canvas", "--window-size=1500,950"]  # fmt: skip


@contextmanager
def _server() -> Iterator[str]:
    command = [sys.executable, "-m", "tools.watch", "--port", "0", "--json"]
    with subprocess.Popen(command, cwd=_ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        try:
            yield json.loads(server.stdout.readline())["url"]
        finally:
            server.terminate()


@contextmanager
def _reader(url: str) -> Iterator[dict]:
    """A page's WebSocket without a page; counts what comes."""
    heard = {"rows": 0}
    loop = asyncio.new_event_loop()

    async def read() -> None:
        connection = await websocket_connect(url.replace("http", "ws") + "feed")
        while (message := await connection.read_message()) is not None:
            heard["rows"] += isinstance(message, bytes)

    thread = threading.Thread(target=lambda: loop.run_until_complete(read()), daemon=True)
    thread.start()
    yield heard


@contextmanager
def _browser(url: str) -> Iterator[None]:
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [shutil.which("chromium"), *_BROWSER, f"--user-data-dir={profile}", url]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as browser:
            try:
                yield
            finally:
                browser.terminate()


def _walk(kind: str, folder: Path, given: list[str]) -> dict:
    with ExitStack() as running:
        if kind in (_PAGE, _BROWSES):
            url = running.enter_context(_server())
            running.enter_context(_reader(url) if kind == _PAGE else _browser(url))
        walk = [str(surefoot_binary()), "run", *given, "--live", "--out", str(folder), "--overwrite"]
        with subprocess.Popen(walk, stdout=subprocess.DEVNULL) as running_walk:
            # The thread that began is the loop; the recorder stays where the pages are. As on a robot, the loop has a
            # processor that nothing else uses (surefoot doctor).
            time.sleep(_THREADS_BEGIN_S)
            os.sched_setaffinity(running_walk.pid, _OF_THE_LOOP)
    return json.loads((folder / "verdict.json").read_text())["tick_us"]


def _against(nobody: list[dict], ticks: list[dict], name: str) -> str:
    """Round by round, so that what changes slowly on a machine is on both sides: the middle, and the middle half."""
    percent = sorted(100 * (tick[name] / other[name] - 1) for tick, other in zip(ticks, nobody, strict=True))
    quarter = len(percent) // 4
    return f"{statistics.median(percent):+.2f} % ({percent[quarter]:+.2f} to {percent[-1 - quarter]:+.2f})"


def _table(found: dict[str, list[dict]]) -> str:
    head = "".join(f"{name:>9}" for name in _FIGURES)
    lines = [f"{'us a tick, median of the rounds':<32}{head}   p50 against nobody        mean against nobody"]
    nobody = found[_NOBODY]
    for kind, ticks in found.items():
        figures = "".join(f"{statistics.median(tick[name] for tick in ticks):>9.2f}" for name in _FIGURES)
        lines.append(f"{kind:<32}{figures}   {_against(nobody, ticks, 'p50'):<26}{_against(nobody, ticks, 'mean')}")
    return "\n".join(lines)


def main(given: list[str]) -> int:
    """Returns the exit code."""
    parser = Parser(prog="surefoot watch cost", description=__doc__)
    parser.add_argument("--rounds", type=int, default=8, help="walks of each kind (default: 8)")
    parser.add_argument("--browser", action="store_true", help="also with Chromium, which draws on the processor")
    parser.add_argument("walk", nargs="*", default=["--pace", "1", "--set", "duration_s=2"], help="arguments of the walk")
    arguments = parser.parse_args(given)
    kinds = _KINDS if arguments.browser else _KINDS[:3]
    os.sched_setaffinity(0, _OF_THE_PAGES)
    found: dict[str, list[dict]] = {kind: [] for kind in kinds}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.rounds):
            for turn in range(len(kinds)):
                kind = kinds[(turn + number) % len(kinds)]
                print(f"round {number + 1} of {arguments.rounds}: {kind}", file=sys.stderr, flush=True)
                found[kind].append(_walk(kind, Path(folder) / "run", arguments.walk))
    print(_table(found))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
