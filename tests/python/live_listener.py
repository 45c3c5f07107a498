"""Writes what is heard on LCM while a command runs into an event log: live_listener.py LOG COMMAND...

Exits with the command's code. Meant for a network namespace of its own, where nobody else talks.
"""

import subprocess
import sys
import time

import lcm

_PROVIDER = "udpm://239.255.76.67:7667?ttl=0"
_DEADLINE_S = 8.0
_SILENCE_MS = 200  # after the command has ended: nothing more is under way


def main(log_file: str, *command: str) -> int:
    log = lcm.EventLog(log_file, "w")
    bus = lcm.LCM(_PROVIDER)
    started_s = time.monotonic()

    def elapsed_us() -> int:
        return round((time.monotonic() - started_s) * 1e6)

    bus.subscribe("SUREFOOT_.*", lambda channel, encoded: log.write_event(elapsed_us(), channel, encoded))
    bus.handle_timeout(1)  # the receiving thread of liblcm starts with the first call
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    try:
        while bus.handle_timeout(_SILENCE_MS) > 0 or process.poll() is None:
            if elapsed_us() > _DEADLINE_S * 1e6:
                print(f"still not silent after {_DEADLINE_S} s", file=sys.stderr)
                return 1
    finally:
        process.kill()
        process.wait()
        log.close()
    return process.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
