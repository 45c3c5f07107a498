"""What all exports start from: telemetry, frames and texts of a run folder, and the clocks between them."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from tools.export.candump_log import Frames, read_frames
from tools.export.lcm_log import Channel, read_channels
from tools.plots.read_run import RunFolderError

DBC = Path(__file__).resolve().parents[2] / "firmware" / "can" / "surefoot.dbc"


@dataclass(frozen=True)
class RunFiles:
    folder: Path
    channels: dict[str, Channel]
    frames: Frames | None  # None: not asked for
    texts: dict[str, str]  # scenario.toml, verdict.json: as far as they are there
    verdict: dict  # empty when the run was interrupted before it

    @property
    def scenario_zero_us(self) -> int:
        """The scenario's time zero on the logs' clock, which begins at power-up."""
        first = min(self.channels.values(), key=lambda channel: channel.numbers[0])
        return int(first.recorded_us[0] - first.rows["utime"][0])

    @property
    def frame_time_s(self) -> np.ndarray:
        """Of each frame, on the scenario's clock."""
        return (self.frames.time_us - self.scenario_zero_us) / 1e6


def read_run_files(folder: Path, with_frames: bool) -> RunFiles:
    """Raises RunFolderError where there is no telemetry, or a file is none of ours."""
    channels = read_channels(folder / "telemetry.lcmlog")
    frames = read_frames(folder / "bus.log") if with_frames else None
    paths = [folder / name for name in ("scenario.toml", "verdict.json")]
    texts = {path.name: path.read_text("utf-8", "replace") for path in paths if path.is_file()}
    try:
        verdict = json.loads(texts.get("verdict.json", "{}"))
    except ValueError as error:
        raise RunFolderError(f"{folder / 'verdict.json'}: {error}\n  remedy: run the scenario again") from error
    return RunFiles(folder, channels, frames, texts, verdict)


def body_poses(truth: Channel) -> tuple[np.ndarray, np.ndarray]:
    """Positions in m and quaternions x, y, z, w of the body frame in the world frame."""
    half = [truth.rows[f"{angle}_rad"].astype(float) / 2 for angle in ("roll", "pitch", "yaw")]
    (cr, cp, cy), (sr, sp, sy) = np.cos(half), np.sin(half)
    quaternions = np.stack(
        [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ],
        axis=-1,
    )
    return truth.rows["body_position_world_m"].astype(float), quaternions
