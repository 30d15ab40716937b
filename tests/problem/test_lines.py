"""The line of a key in an input file."""

from __future__ import annotations

import pytest

from mpsolve.problem.lines import line_of

TEXT = """v = 3
[track]
EI = 1   # EI = 2
"m" = 2
[[vehicle]]
wheel = 1
[vehicle.bogie]
wheel = 2
[[vehicle]]
wheel = 3
positions = [1, 2]
"""


@pytest.mark.parametrize(
    ("key", "line"),
    [
        ("v", 1), ("track.EI", 3), ("track.m", 4), ("track", 2), ("track.k", 2), ("vehicle[1].wheel", 6),
        ("vehicle[1].bogie.wheel", 8), ("vehicle[2].wheel", 10), ("vehicle[2].mass", 9),
        ("vehicle[2].positions[2]", 11), ("w", None), ("mine.toml", None),
    ],
)  # fmt: skip
def test_it_is_found(key: str, line: int | None) -> None:
    assert line_of(TEXT, key) == line
