"""The file of a whole sheet: exact, in the problem's own units, one loop after the other along its paths."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from mpsolve import Problem, tracks, vehicles
from mpsolve.certificate.sheet_file import sheet_certificate
from mpsolve.problem.line import on_line
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.sheet import count_sheet


def content(c: str, shorter: int = 1) -> dict[str, Any]:
    """Lengths are so many times shorter, times the square of it: k, v, M and c follow."""
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=shorter**4, c=Fraction(c) * shorter**2)
    reduced = reduce_problem(Problem(track, vehicles.Mass(Fraction(7, shorter)), v=Fraction(shorter, 2)))
    line = on_line(reduced)
    assert line is not None
    return sheet_certificate(reduced, count_sheet(line, Effort(evaluations=10**5)), [], 0).content


def number(pair: list[int]) -> Fraction:
    return Fraction(pair[0]) * Fraction(2) ** pair[1]


@pytest.mark.parametrize("c", ["0.1", "0"])
def test_paths_and_loops_are_one_chain(c: str) -> None:
    made = content(c)
    theorem, paths = made["theorem"], made["paths"]
    assert all(y == 0 for _, y, _ in paths[-1]["points"])
    assert [path["kind"] for path in paths[:2]] == ["link", "turn"]
    assert paths[0]["points"][-1][1] == 0
    m, _, e = paths[0]["points"][-1]
    assert number([m, e]) == number(theorem["begin"])
    for loop in theorem["lower"]:
        assert paths[1]["points"][-1] == loop["points"][0] == loop["points"][-1]
        centre, radius = number(loop["centre"]), number(loop["radius"])
        for x, y, power in loop["points"]:
            z = complex(x * 2.0**power - float(centre), y * 2.0**power)
            assert abs(z) <= float(radius) * (1 + 1e-12)


def test_it_speaks_in_the_problems_own_units() -> None:
    """The same problem in lengths half as long and times a quarter: scaled by powers of two it is the same inside."""
    one, other = content("0.1"), content("0.1", 2)
    assert one["equations"] != other["equations"]
    for name in ("begin", "end"):
        assert number(other["theorem"][name]) == 4 * number(one["theorem"][name])
    (m, n, e), (x, y, f) = (made["paths"][-1]["points"][-1] for made in (one, other))
    assert number([x, f]) == 4 * number([m, e])
    assert n == y == 0
