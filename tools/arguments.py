"""The command line of a Python command: what all of them have in common."""

import argparse
import sys
from typing import NoReturn

_USAGE = 64


class Parser(argparse.ArgumentParser):
    """Epilogue as it is written; a wrong argument ends with code 64 and the way to --help. `prog` as people type it."""

    def __init__(self, **described: object) -> None:
        super().__init__(formatter_class=argparse.RawDescriptionHelpFormatter, **described)

    def error(self, message: str) -> NoReturn:
        sys.stderr.write(f"{self.prog}: {message}\n  remedy: see tools/{self.prog} --help\n")
        sys.exit(_USAGE)
