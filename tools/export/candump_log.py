"""The frames of a `candump -L` log, classic and FD."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tools.plots.read_run import RunFolderError


@dataclass(frozen=True)
class Frames:
    """One entry a frame, in the log's order."""

    time_us: np.ndarray  # since power-up
    buses: list[str]
    identifiers: np.ndarray
    is_fd: np.ndarray
    flags: np.ndarray  # CAN FD flags of SocketCAN: 1 bit rate switch, 2 error state; 0 for classic frames
    data: list[bytes]

    def __len__(self) -> int:
        return len(self.data)


def read_frames(path: Path) -> Frames:
    """Reads a log; a last line without an end (a run that was killed) is left out.

    Raises RunFolderError with the line that is no frame.
    """
    lines = path.read_text("ascii", "replace").split("\n")[:-1] if path.is_file() else []
    times, buses, identifiers, fd, flags, data = [], [], [], [], [], []
    for number, line in enumerate(lines, 1):
        try:
            time, bus, frame = line.split(" ")
            identifier, _, payload = frame.partition("#")
            is_fd = payload.startswith("#")
            times.append(int(time[1:-8]) * 1_000_000 + int(time[-7:-1]))
            buses.append(bus)
            identifiers.append(int(identifier, 16))
            fd.append(is_fd)
            flags.append(int(payload[1], 16) if is_fd else 0)
            data.append(bytes.fromhex(payload[2:] if is_fd else payload))
        except (ValueError, IndexError) as error:
            raise RunFolderError(
                f"{path}:{number}: not a line of `candump -L`: {line[:60]!r}\n"
                "  remedy: run the scenario again, or leave the frames out with --no-can"
            ) from error
    return Frames(
        np.array(times, np.int64), buses, np.array(identifiers, np.uint32), np.array(fd, bool),
        np.array(flags, np.uint8), data,
    )  # fmt: skip
