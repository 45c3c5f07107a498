"""surefoot watch: see --help."""

import argparse
import asyncio
import json
import sys

from tornado.httpserver import HTTPServer
from tornado.ioloop import PeriodicCallback
from tornado.netutil import bind_sockets
from tornado.web import Application, RequestHandler

from tools.arguments import Parser
from tools.binary import MissingBinaryError, surefoot_binary
from tools.plots.messages import LIVE_URL, MissingGeneratorError
from tools.report.blocks import Blocks
from tools.report.page import page
from tools.viewer_bundle import ViewerError
from tools.watch.feed import Feed, Page
from tools.watch.listener import Listener

_PORT = 8642
_PICTURES_HZ = 60
_MACHINE_LACKS, _INTERRUPTED = 69, 130
_OWN_NAMES = r"(127\.0\.0\.1|localhost)"  # a page of another name that resolves to this machine gets nothing


def _arguments(given: list[str]) -> argparse.Namespace:
    parser = Parser(
        prog="surefoot watch",
        description="Serves a page on this machine that shows the run that is going on: replay, plots, events.",
        epilog="Start it, open the page, and then any run with --live; the page goes on with the next one by itself.\n"
        "Only this machine can open it. Ctrl-C ends it.\n"
        "Exit codes: 64 usage, 69 something the machine lacks, 130 interrupted.\n"
        "Examples:\n"
        "  tools/surefoot watch & tools/surefoot run --live --pace 1\n"
        "  tools/surefoot watch --port 9000\n"
        "  tools/surefoot firmware --bus socketcan:can0 --clock wall --live --out runs/bench   # is heard as well",
    )
    parser.add_argument("--port", type=_port, default=_PORT, help=f"TCP port on 127.0.0.1 (default: {_PORT}; 0: any)")
    parser.add_argument("--url", default=LIVE_URL, help="where to listen (default: where `--live` publishes)")
    parser.add_argument("--json", action="store_true", help="say where the page is as a line of JSON")
    return parser.parse_args(given)


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > 65535:
        raise argparse.ArgumentTypeError(f"{text} is no port: 0 to 65535")
    return int(text)


class _Front(RequestHandler):
    """The page itself; all that it shows comes by its WebSocket."""

    def initialize(self, content: str) -> None:
        self._content = content

    def get(self) -> None:
        self.set_header("Cache-Control", "no-store")
        self.write(self._content)


async def _serve(arguments: argparse.Namespace, listener: Listener, content: str) -> None:
    feed = Feed(listener, surefoot_binary(), lambda line: print(line, file=sys.stderr, flush=True))
    application = Application()
    application.add_handlers(_OWN_NAMES, [("/", _Front, {"content": content}), ("/feed", Page, {"feed": feed})])
    sockets = bind_sockets(arguments.port, "127.0.0.1")
    HTTPServer(application).add_sockets(sockets)
    where = f"http://127.0.0.1:{sockets[0].getsockname()[1]}/"
    print(json.dumps({"url": where}) if arguments.json else f"watch: {where} (Ctrl-C ends)", flush=True)
    PeriodicCallback(feed.step, 1000 / _PICTURES_HZ).start()
    await asyncio.Event().wait()


def _fail(message: object) -> int:
    print(message, file=sys.stderr)
    return _MACHINE_LACKS


def main(given: list[str]) -> int:
    """Returns the exit code."""
    arguments = _arguments(given)
    try:
        surefoot_binary()
        content = page("Surefoot: watch", {"format": 1, "mode": "watch"}, Blocks())
        listener = Listener(arguments.url)
        asyncio.run(_serve(arguments, listener, content))
    except (MissingBinaryError, MissingGeneratorError, ViewerError) as error:
        return _fail(error)
    except RuntimeError as error:
        return _fail(f"watch: {error}\n  remedy: see tools/surefoot doctor, section multicast")
    except OSError as error:
        return _fail(f"watch: port {arguments.port}: {error.strerror}\n  remedy: name another one by --port, or --port 0")
    except KeyboardInterrupt:
        return _INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
