"""The checked-in C codec is what tools/generate-codec makes of surefoot.dbc, byte for byte."""

import os
import subprocess
import sys
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
CHECKED_IN = TREE / "firmware" / "can" / "generated"


def test_codec_is_what_the_dbc_generates(tmp_path):
    beside_python = Path(sys.executable).parent / "cantools"
    environment = {"CANTOOLS": str(beside_python), **os.environ}
    subprocess.run([TREE / "tools" / "generate-codec", tmp_path], env=environment, check=True)
    generated = sorted(path.name for path in tmp_path.iterdir())
    assert generated == ["surefoot.c", "surefoot.h"]
    for name in generated:
        # Compared as a truth value: pytest's difference of two files of 9,000 lines takes minutes.
        is_same = (tmp_path / name).read_bytes() == (CHECKED_IN / name).read_bytes()
        assert is_same, f"{name} is not what surefoot.dbc generates: run tools/generate-codec"
