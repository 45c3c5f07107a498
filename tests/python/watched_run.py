"""Inside a network of its own: serves the live page, opens it, lets a robot walk, and prints what the page showed.

Called by watch_test.py: FOLDER, then the arguments of `surefoot run` beyond --live and --out, once for each "--".
"""

import http.client
import json
import os
import subprocess
import sys
import time
import urllib.error
import urllib.parse
import urllib.request
from pathlib import Path

from browser import Opened, browser
from command_line import ROOT, binary, wait_until

_PATIENCE_S = 60.0  # of a browser that draws on a busy processor


def _walk(folder: Path, arguments: list[str]) -> None:
    subprocess.run([binary(), "run", *arguments, "--live", "--out", folder], check=False, stdout=subprocess.DEVNULL)


def _wait_until_nothing_comes(opened: Opened) -> None:
    """The verdict may overtake rows: all of them have come when none came for a second, and are drawn."""
    received = -1
    while received != (received := opened.page.evaluate("() => window.surefoot.received()")):
        time.sleep(1.0)
    opened.page.wait_for_function("() => window.surefoot.isSettled()")


def _shown(opened: Opened) -> dict:
    shown = opened.page.evaluate("() => ({received: window.surefoot.received(), drawn: window.surefoot.drawn()})")
    shown["pose"] = opened.pose()
    shown["verdict"] = opened.page.inner_text(".verdict b")
    shown["name"] = opened.page.inner_text(".verdict .name")
    shown["events"] = opened.page.eval_on_selector_all(".tick", "all => all.map(tick => tick.title.split(' ')[0])")
    shown["plots"] = opened.page.locator(".plot:visible").count()
    return shown


def _answer(address: str, host: str) -> int:
    try:
        with urllib.request.urlopen(urllib.request.Request(address, headers={"Host": host}), timeout=5) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code


def _upgrade(address: str, origin: str) -> int:
    """Status of a WebSocket's opening from a page of another place, or of our own."""
    place = urllib.parse.urlsplit(address)
    connection = http.client.HTTPConnection(place.hostname, place.port, timeout=5)
    key = {"Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==", "Sec-WebSocket-Version": "13"}
    connection.request("GET", "/feed", headers={"Upgrade": "websocket", "Connection": "Upgrade", "Origin": origin, **key})
    status = connection.getresponse().status
    connection.close()
    return status


def main() -> None:
    folder, *given = sys.argv[1:]
    walks = " ".join(given).split(" -- ")
    server = subprocess.Popen(
        [sys.executable, "-m", "tools.watch", "--port", "0", "--json"], cwd=ROOT, stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    try:
        url = json.loads(server.stdout.readline())["url"]
        told = {"foreign_host": _answer(url, "example.org"), "own_host": _answer(url, "localhost")}
        told |= {"foreign_origin": _upgrade(url, "http://example.org"), "own_origin": _upgrade(url, url.rstrip("/"))}
        with browser(may_ask=(url, url.replace("http", "ws"))) as new_page:
            opened = new_page()
            opened.open(url)
            told["before"] = opened.page.inner_text("#surefoot-app")
            told["walks"] = []
            for number, walk in enumerate(walks):
                run = Path(folder) / str(number)
                _walk(run, walk.split())
                wait_until(lambda run=run: str(run) == opened.page.inner_text(".verdict .name"), _PATIENCE_S)
                wait_until(lambda: opened.page.inner_text(".verdict b") != "live", _PATIENCE_S)
                _wait_until_nothing_comes(opened)
                told["walks"].append(_shown(opened))
            late = new_page()
            late.open(url)
            late.page.wait_for_selector(".verdict b")
            told["joined_late"] = {"events": late.page.locator(".tick").count(), "verdict": late.page.inner_text(".verdict b")}
    finally:
        server.terminate()
        server.wait(timeout=10)
    print(json.dumps(told))


if __name__ == "__main__":
    main()
