"""The values of each path: lists, steps, ranges, and tables in tables."""

from __future__ import annotations

from fractions import Fraction

from mpsolve import Problem, tracks, vehicles
from mpsolve.studies.axes import read_axes, total_of
from mpsolve.studies.design import Listed, Span, Steps

PROBLEM = Problem(tracks.String(T=1, m=1, k=1, c=1), vehicles.Mass(1), v=1)


def test_paths_and_kinds() -> None:
    given = {"track": {"k": [1, "2"], "c": 3}, "v": {"start": 0, "stop": 1, "step": "1/4"}}
    axes = read_axes(given, "grid", PROBLEM)
    assert list(axes) == ["track.k", "track.c", "v"]
    assert axes["track.k"] == Listed((Fraction(1), Fraction(2)))
    assert axes["v"] == Steps(Fraction(0), Fraction(1, 4), 5)
    assert total_of(axes, "grid", 0) == 10


def test_a_range_counts_as_many_as_are_drawn() -> None:
    axes = read_axes({"v": {"low": "36 km/h", "high": 20}}, "random", PROBLEM)
    assert axes["v"] == Span(Fraction(10), Fraction(20))
    assert total_of(axes, "random", 77) == 77
