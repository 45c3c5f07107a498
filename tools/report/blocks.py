"""Arrays as compressed text that a page can hold. The page's half is tools/viewer/src/data/blocks.js."""

import base64
import gzip
from dataclasses import dataclass, field

import numpy as np

# Level 6 is within 2 % of the smallest and three times faster than it.
_GZIP_LEVEL = 6
_NOT_A_NUMBER = -32768
_LARGEST = 32767


@dataclass
class Blocks:
    """Compressed byte strings by name, as base64."""

    texts: dict[str, str] = field(default_factory=dict)

    def add(self, name: str, content: bytes) -> str:
        self.texts[name] = base64.b64encode(gzip.compress(content, _GZIP_LEVEL, mtime=0)).decode("ascii")
        return name


def _planes(values: np.ndarray) -> bytes:
    """Differences from value to value, lowest bytes first, then the next: what changes little compresses well."""
    unsigned = values.astype(values.dtype.str.replace("i", "u"))
    steps = np.diff(unsigned, prepend=unsigned.dtype.type(0))
    return steps.astype(steps.dtype.newbyteorder("<")).view(np.uint8).reshape(len(steps), -1).T.tobytes()


def _quantised(values: np.ndarray) -> tuple[np.ndarray, float, float]:
    """Whole numbers of 16 bits over the column's range, with scale and offset; what is no number has a code of its own."""
    finite = np.isfinite(values)
    if not finite.any():
        return np.full(len(values), _NOT_A_NUMBER, np.int16), 1.0, 0.0
    low, high = float(values[finite].min()), float(values[finite].max())
    offset = 0.5 * low + 0.5 * high
    scale = (0.5 * high - 0.5 * low) / _LARGEST or 1.0
    codes = np.full(len(values), _NOT_A_NUMBER, np.int16)
    codes[finite] = np.rint((values[finite] - offset) / scale).astype(np.int16)
    return codes, scale, offset


def _fits_32_bits(values: np.ndarray) -> bool:
    bounds = np.iinfo(np.int32)
    return not values.size or (values.min() >= bounds.min and values.max() <= bounds.max)


def add_columns(blocks: Blocks, name: str, columns: dict[str, np.ndarray]) -> list[dict]:
    """Packs columns of one length into one block, and says how to read each of them.

    Whole numbers keep their value where 32 bits hold it; others are quantised to 1/65534 of the column's range.
    """
    content, described = [], []
    for index, (column, values) in enumerate(columns.items()):
        is_whole = values.dtype.kind in "iub" and _fits_32_bits(values)
        codes, scale, offset = (values.astype(np.int32), 1.0, 0.0) if is_whole else _quantised(values.astype(float))
        content.append(_planes(codes))
        described.append(
            {
                "name": column, "block": name, "index": index, "type": "i32" if is_whole else "i16",
                "scale": scale, "offset": offset, "from_byte": sum(map(len, content[:-1])),
            }
        )  # fmt: skip
    blocks.add(name, b"".join(content))
    return described
