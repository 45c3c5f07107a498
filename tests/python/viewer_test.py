"""The page's arithmetic, in node: packed columns come back, and what node's own tests say."""

import json
import subprocess

import numpy as np
from command_line import ROOT

from tools.report.blocks import Blocks, add_columns

_NODE = ROOT / ".venv" / "bin" / "node"
_TESTS = ROOT / "tests" / "viewer"


def _unpacked(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    blocks = Blocks()
    described = add_columns(blocks, "block", columns)
    rows = len(next(iter(columns.values())))
    asked = json.dumps({"block": blocks.texts["block"], "rows": rows, "columns": described})
    finished = subprocess.run([_NODE, _TESTS / "columns.js"], input=asked, capture_output=True, text=True, check=True)
    values = json.loads(finished.stdout)
    return {name: np.array(column, float) for name, column in zip(columns, values, strict=True)}


def test_packed_columns_come_back_within_their_resolution() -> None:
    random = np.random.default_rng(7)
    columns = {
        "noise": random.normal(size=5000),
        "walk": random.normal(size=5000).cumsum() * 1e6,
        "constant": np.full(5000, -0.0345),
        "tiny": random.normal(size=5000) * 1e-300,
        "huge": np.array([-1.7e308, 1.7e308] * 2500),
    }
    for name, found in _unpacked(columns).items():
        half_range = 0.5 * columns[name].max() - 0.5 * columns[name].min()
        assert np.abs(found - columns[name]).max() <= half_range / 65534 * 1.01, name


def test_what_is_no_number_is_shown_as_none() -> None:
    values = np.array([1.0, np.nan, -np.inf, np.inf, 2.0])
    found = _unpacked({"values": values, "nothing": np.full(5, np.nan)})
    assert np.isnan(found["nothing"]).all()
    assert list(np.isnan(found["values"])) == [False, True, True, True, False]


def test_whole_numbers_keep_their_value() -> None:
    columns = {
        "ages": np.array([-1, 0, 127, -2147483648, 2147483647]),
        "flags": np.array([True, False, True, True, False]),
    }
    for name, found in _unpacked(columns).items():
        assert (found == columns[name]).all(), name


def test_whole_numbers_beyond_32_bits_keep_their_size() -> None:
    values = np.array([0, 2**31, 2**40, 2**40 + 2**33])
    found = _unpacked({"frames": values})["frames"]
    assert np.abs(found - values).max() <= values.max() / 2 / 65534 * 1.01


def test_node_agrees() -> None:
    tests = sorted(_TESTS.glob("*.test.js"))
    assert tests
    finished = subprocess.run([_NODE, "--test", *tests], capture_output=True, text=True, check=False)
    assert finished.returncode == 0, finished.stdout
