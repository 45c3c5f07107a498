"""A file that needs more than 400 lines is more than one thing."""

from source_tree import CPP_SUFFIXES, ROOT, all_files

_MAX_LINES = 400
_SUFFIXES = CPP_SUFFIXES | {".py", ".cmake", ".lcm", ""}  # scripts have no suffix


def test_no_source_file_is_longer_than_400_lines():
    sources = [path for path in all_files() if path.suffix in _SUFFIXES or path.name == "CMakeLists.txt"]
    assert len(sources) > 50
    lengths = {path: len((ROOT / path).read_text().splitlines()) for path in sources}
    too_long = {str(path): lines for path, lines in lengths.items() if lines > _MAX_LINES}
    assert not too_long
