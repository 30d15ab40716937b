"""Regions, and the paths that a count in them rests on: what runs elsewhere than it should counts other roots."""

from __future__ import annotations

import itertools
from fractions import Fraction
from types import SimpleNamespace

import numpy as np
import pytest
from flint import fmpq

from mpsolve.certificate import verify2 as v2


def points(*z):
    return [tuple(fmpq(x.numerator, x.denominator) for x in map(Fraction, at)) for at in z]


QUARTER = [(Fraction(30, 10) * c, -Fraction(30, 10) * s) for c, s in ((Fraction(4, 5), Fraction(3, 5)), (0, 1))]
UP = [(0, "1/4"), (1, "1/4"), (3, "1/4"), (3, 0)]
WALLS, AXIS = [(3, 0), (3, -2), (1, -2), (0, -2)], [(3, 0), (5, 0), (9, 0)]
BOX = [(1, -1), (2, -1), (2, 1), ("3/2", 1), (1, 1), (1, 0), (1, -1)]
RIGHT = {  # region, and its paths from −2i
    "unstable": ({}, [[(0, -2), (0, 0)], [(0, 0), (1, 0), (3, 0)], WALLS, AXIS]),
    "below": ({"height": "1/4", "reach": "3"}, [[(0, -2), (0, 0), (0, "1/4")], UP, WALLS, AXIS]),
    "disc": ({"radius": "3"}, [[(0, -2), (0, 0)], [(0, 0), (3, 0), *QUARTER]]),
    "below disc": ({"height": "1/4", "radius": "3"}, [[(0, -2), (0, "1/4")], [*UP, *QUARTER]]),
    "rectangle": ({"re": ["1", "2"], "im": ["-1", "1"]}, [[(0, -2), (0, -1), (1, -1)], BOX]),
}


def checked(kind, number=None, new=None):
    """With one of the paths changed."""
    numbers, paths = RIGHT[kind]
    region = v2.read_region({"kind": kind, **numbers})
    paths = [new if k == number else path for k, path in enumerate(paths)]
    with v2.precision(64):
        v2.check_paths(region, [v2.Path("", points(*path)) for path in paths], fmpq(2))


@pytest.mark.parametrize("kind", RIGHT)
def test_paths_that_are_right(kind):
    checked(kind)


def test_where_the_receptance_is_passive_from_the_corner_on_there_is_no_path_beyond_it():
    checked("unstable", 3, [(3, 0)])


WRONG = {
    "a start elsewhere": ("disc", 0, [(0, -1), (0, 0)], "not begin at the start"),
    "over the region": ("unstable", 0, [(0, -2), (1, 1), (0, 0)], "above the region"),
    "to another point of the axis": ("below", 0, [(0, -2), (0, 0)], "does not end on the imaginary axis"),
    "to another corner": ("rectangle", 0, [(0, -2), (2, -1)], "does not end at the rectangle's corner"),
    "no corner": ("unstable", 1, [(0, 0), (1, 0), (3, -1)], "not come to the real axis at its corner"),
    "to the other side": ("unstable", 1, [(0, 0), (-3, 0)], "rho is not positive"),
    "beyond the corner": ("unstable", 1, [(0, 0), (3, 0), (3, 0)], "goes on beyond its corner"),
    "from elsewhere": ("below", 1, [(0, 0), (3, 0)], "begins elsewhere"),
    "back and forth": ("disc", 1, [(0, 0), (2, 0), (1, 0), (3, 0), *QUARTER], "not in order"),
    "on another line": ("below", 1, [UP[0], (1, "1/5"), *UP[2:]], "not on the line"),
    "up the walls": ("unstable", 2, [(3, 0), (3, 2), (0, 2)], "do not go down"),
    "walls that end before the axis": ("unstable", 2, [*WALLS[:3], (1, -2)], "not in order"),
    "walls that go on": ("unstable", 2, [*WALLS, (-1, -2)], "goes on beyond its end"),
    "walls without an end": ("unstable", 2, [(3, 0), (3, -2)], "ends before its last corner"),
    "an axis from elsewhere": ("unstable", 3, [(4, 0), (9, 0)], "begins elsewhere"),
    "one point elsewhere": ("unstable", 3, [(9, 0)], "beyond the corner begins elsewhere"),
    "an axis downwards": ("unstable", 3, [(3, 0), (9, -1)], "leaves the real axis"),
    "an axis backwards": ("unstable", 3, [(3, 0), (1, 0)], "leaves the real axis"),
    "an arc that ends early": ("disc", 1, [(0, 0), (3, 0), QUARTER[0]], "does not end on the imaginary axis"),
    "an arc over another quarter": ("disc", 1, [(0, 0), (3, 0), (-3, -1), (0, -3)], "not in its quarter"),
    "an arc over the quarter above": ("disc", 1, [(0, 0), (3, 0), (2, 2), (3, 0), (0, -3)], "not in its quarter"),
    "an arc through 0": ("disc", 1, [(0, 0), (3, 0), (0, 0), (0, -3)], "does not hold its arc"),
    "a chord far inside": ("below disc", 1, [*UP, ("1/9", "-1/9"), (0, -3)], "does not hold its arc"),
    "the other way round": ("rectangle", 1, BOX[::-1], "not on the line"),
    "a side left out": ("rectangle", 1, [*BOX[:2], *BOX[4:]], "not on the line"),
}


@pytest.mark.parametrize("name", WRONG)
def test_paths_that_are_wrong(name):
    kind, number, new, why = WRONG[name]
    with pytest.raises(v2.Refused, match=why):
        checked(kind, number, new)


REGIONS = {
    "no kind": ({"kind": None}, "no kind"),
    "a list": ([], "no kind"),
    "no depth": ({"kind": "rectangle", "re": ["0", "1"], "im": ["1", "1"]}, "empty"),
    "another kind": ({"kind": "strip"}, "not known"),
    "no width": ({"kind": "rectangle", "re": ["1", "1"], "im": ["0", "1"]}, "empty"),
    "both sides turned": ({"kind": "rectangle", "re": ["2", "1"], "im": ["1", "-1"]}, "empty"),
    "no height": ({"kind": "below", "height": "0", "reach": "1"}, "not positive"),
    "a height below the axis": ({"kind": "below disc", "height": "-1", "radius": "1"}, "not positive"),
    "no reach": ({"kind": "below", "height": "1", "reach": "0"}, "not positive"),
    "no radius": ({"kind": "disc", "radius": "-1"}, "not positive"),
}


@pytest.mark.parametrize("name", REGIONS)
def test_a_region_is_refused(name):
    value, why = REGIONS[name]
    with pytest.raises(v2.Refused, match=why):
        v2.read_region(value)


def test_the_arcs_lie_in_their_discs():
    """Against points of each arc in floats; chords that a disc holds only just, or just not."""
    rng, seen = np.random.default_rng(4), []
    for _ in range(60):
        angle = np.sort(rng.uniform(0, np.pi / 2, rng.integers(1, 4)))
        radii = rng.uniform(0.5, 2, len(angle))
        path = [(1, 0), *((r * np.cos(t), -r * np.sin(t)) for r, t in zip(radii, angle, strict=True)), (0, -1)]
        try:
            with v2.precision(64):
                v2.check_arc(points(*path), fmpq(1))
            seen.append(True)
        except v2.Refused:
            seen.append(False)
        z = [complex(x, y) for x, y in path]
        inside = True
        for a, b in itertools.pairwise(z):
            arc = np.exp(1j * np.linspace(np.angle(a), np.angle(b), 300))
            inside = inside and np.abs(arc - (a + b) / 2).max() < abs(b - a) / 2 * (1 + 2**-12)
        assert inside == seen[-1]
    assert set(seen) == {True, False}


def test_paths_are_of_the_kinds_asked_for_and_not_too_many(monkeypatch):
    value = [{"kind": "link", "points": [[0, -1, 1], [0, 0, 0]]}, {"kind": "turn", "points": [[0, 0, 0], [1, 0, 0]]}]
    assert [path.kind for path in v2.read_paths(value, "link turn")] == ["link", "turn"]
    for kinds, why in (("link", "in place of 1"), ("link link", "another kind"), ("turn turn", "another kind")):
        with pytest.raises(v2.Refused, match=why):
            v2.read_paths(value, kinds)
    for wrong, why in (([], "no points"), ([[0]], "two or three")):
        with pytest.raises(v2.Refused, match=why):
            v2.read_paths([value[0], {"kind": "turn", "points": wrong}], "link turn")
    monkeypatch.setattr(v2, "MAX_PIECES", 2)
    assert len(v2.read_paths(value, "link turn")) == 2
    monkeypatch.setattr(v2, "MAX_PIECES", 1)
    with pytest.raises(v2.Refused, match="too many pieces"):
        v2.read_paths(value, "link turn")


def test_a_theorem_where_none_is_needed_is_refused():
    for kind, velocity in (("disc", 1), ("rectangle", 1), ("below", 0)):
        with pytest.raises(v2.Refused, match="needs no theorem"):
            v2.count_roots(
                None, v2.read_region({"kind": kind, **RIGHT[kind][0]}), [], {}, SimpleNamespace(v=velocity)
            )


def test_a_turn_between_two_numbers_tells_none():
    with pytest.raises(v2.Refused, match="does not tell"):
        v2.whole(v2.arb("0.5", "0.6"))
    assert v2.whole(v2.arb("1", "0.6")) == 1
