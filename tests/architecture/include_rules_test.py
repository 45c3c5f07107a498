"""Who may include whom.

core <- can <- host; can <- sim_hw; lcm_types <- host, sim_hw, tools; everything <- tools, tests.
firmware never includes sim_hw; sim_hw takes from firmware the bus, the geometry and plain structs only.
"""

import re
from pathlib import Path

import pytest
from source_tree import CPP_SUFFIXES, ROOT, files_below

_INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
_OUR_ROOMS = ("firmware/", "sim_hw/", "lcm_types/", "tools/", "tests/")
_LCM = ("surefoot/", "lcm/")  # generated messages, the library

# What sim_hw and can know of the controller: plain structs, no behaviour. Faults are part of the contract: the bus
# tells of them.
_FAULTS = ("firmware/core/safety/fault.hpp", "firmware/core/safety/safe_state.hpp")
_PLAIN_STRUCTS = ("firmware/core/joints.hpp", "firmware/core/leg_command.hpp", "firmware/core/sensor_snapshot.hpp")

# Room -> prefixes of ours that it may include.
_MAY_INCLUDE = {
    "firmware/core": ("firmware/core/",),
    "firmware/can": ("firmware/can/", "firmware/core/geometry/", *_PLAIN_STRUCTS, *_FAULTS),
    "firmware/host": ("firmware/core/", "firmware/can/", "firmware/host/", *_LCM),
    "sim_hw": ("sim_hw/", "firmware/can/", "firmware/core/geometry/", *_PLAIN_STRUCTS, *_LCM),
    "tools": ("firmware/", "sim_hw/", "tools/", *_LCM),
}

# All that the control core takes from outside: no heap, exception, clock, thread, stream or log in them.
_CORE_EXTERNAL = {
    "algorithm", "array", "bit", "cmath", "compare", "concepts", "cstddef", "cstdint", "cstring", "initializer_list",
    "limits", "numbers", "numeric", "optional", "span", "tuple", "type_traits", "utility", "Eigen/Core", "Eigen/Dense",
    "Eigen/Geometry",
}  # fmt: skip


def _includes(path: Path) -> list[tuple[bool, str]]:
    """(quoted, name) of every include of a file."""
    return [(quote == '"', name) for quote, name in _INCLUDE.findall((ROOT / path).read_text())]


def _is_ours(name: str) -> bool:
    return name.startswith((*_OUR_ROOMS, *_LCM))


def _sources(room: str) -> list[Path]:
    return [path for path in files_below(room) if path.suffix in CPP_SUFFIXES]


@pytest.mark.parametrize("room", _MAY_INCLUDE)
def test_a_room_includes_only_what_it_may(room: str):
    sources = _sources(room)
    assert sources, f"no sources below {room}"
    broken = [
        f"{path} includes {name}"
        for path in sources
        for _, name in _includes(path)
        if _is_ours(name) and not name.startswith(_MAY_INCLUDE[room])
    ]
    assert not broken, "\n".join(broken)


@pytest.mark.parametrize("room", _MAY_INCLUDE)
def test_our_headers_are_included_by_their_path_from_the_root(room: str):
    broken = [
        f'{path} includes "{name}"'
        for path in _sources(room)
        for quoted, name in _includes(path)
        if quoted and not _is_ours(name)
    ]
    assert not broken, "\n".join(broken)


def test_the_control_core_takes_nothing_that_allocates_throws_waits_or_prints():
    broken = [
        f"{path} includes <{name}>"
        for path in _sources("firmware/core")
        for quoted, name in _includes(path)
        if not quoted and name not in _CORE_EXTERNAL
    ]
    assert not broken, "\n".join(broken)


def test_every_header_is_guarded_by_pragma_once():
    unguarded = [
        str(path) for room in _MAY_INCLUDE for path in _sources(room)
        if path.suffix == ".hpp" and "#pragma once" not in (ROOT / path).read_text()
    ]  # fmt: skip
    assert not unguarded


def test_every_test_includes_what_its_build_has_precompiled():
    broken = [
        str(path)
        for path in _sources("tests")
        if path.name.endswith("_test.cpp") and "TEST" in (text := (ROOT / path).read_text()) and "#include <g" not in text
    ]
    assert not broken
