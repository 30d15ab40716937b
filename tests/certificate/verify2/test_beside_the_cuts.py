"""The way past the branch points of a beam at rest, and rectangles beside its cuts: what each bound is for."""

from __future__ import annotations

import itertools
from types import SimpleNamespace

import numpy as np
import planner as p
import pytest
from flint import acb, arb, fmpq

from mpsolve.certificate import verify2 as v2


def sheet(places=(0,), c="1/10", velocity="9/10", masses=None, **more):
    eq = p.equations(p.beam("1/4", 1, 1, c, **more), velocity, masses or p.masses([70] * len(places), places))
    return v2.Sheet.of(v2.read_track(eq["track"], eq["velocity"]), v2.read_vehicle(eq["vehicle"], None))


# --- at rest, past the branch points ----------------------------------------------------------------------------


def form(constant, linear, rest):
    return v2.Form([[acb(constant)], [acb(linear)]], [arb(rest)], 1)


def test_a_square_root_over_a_disc_holds_its_values():
    rng = np.random.default_rng(2)
    for _ in range(40):
        a, b, e = complex(*rng.normal(size=2)), complex(*rng.normal(size=2)) * 0.3, float(rng.uniform(0, 0.2))
        try:
            found = v2.root(form(a, b, e), fmpq(-3, 2))
        except v2.Refused:
            assert abs(b) + e > 0.89 * abs(a)
            continue
        for u, t in itertools.product(np.exp(2j * np.pi * rng.uniform(size=5)), (0, 1)):
            true = 1j * np.sqrt(1.5 * a) * np.sqrt((a + b * u + t * e * u.conjugate()) / a)
            assert abs(true - complex(found.k[0][0]) - complex(found.k[1][0]) * u) <= float(found.e[0]) * (1 + 1e-9)


@pytest.mark.parametrize(
    ("f", "why"),
    [
        (form(1, 0, 0), "z = 0 lies on a piece"),
        (form(0, "0.1", 0), "z = 0 lies on a piece"),
        (form(-1, "0.6", "0.35"), "too close to z = 0"),
    ],
)
def test_where_z_is_0_its_square_root_has_no_values(f, why):
    with pytest.raises(v2.Refused, match=why):
        v2.root(f, fmpq(1))


@pytest.mark.parametrize("gap", [10, 100])
def test_places_far_apart_are_refused(gap):
    beam = sheet([0, gap], velocity=0)
    edge = v2.AtRest(fmpq(1, 4), fmpq(0), beam.along(0)[0], fmpq(1))
    with v2.precision(64):
        bordered = v2.Bordered(beam.lower, v2.Waves(beam.track, beam.lower.places))
        place = edge.disc(fmpq(63, 64), fmpq(127, 128))
        if gap == 10:
            assert len(edge.matrix(bordered, place)[0]) == 2
        else:
            with pytest.raises(v2.Refused, match="too far apart"):
                edge.matrix(bordered, place)


@pytest.mark.parametrize(
    ("velocity", "z"), [("1/10", ["1/2", 2]), (0, ["1/2", "3/4"]), (0, [2, 3]), (0, ["1/2", 2, 2]), (0, [2, "1/2"])]
)
def test_another_way_past_the_branch_points_is_refused(velocity, z):
    """At z = 1 there is one, at rest."""
    beam, spent = sheet([0], velocity=velocity), SimpleNamespace(pieces=0, spend=lambda _: None)
    with v2.precision(64), pytest.raises(v2.Refused, match="another one"):
        v2.turn_at_rest(beam, None, [fmpq(p.F(x).numerator, p.F(x).denominator) for x in z], spent)


# --- rectangles beside the cuts -----------------------------------------------------------------------------------

BOX = {"kind": "rectangle", "re": ["1/10", "1/5"], "im": ["-1/10", "1/25"]}
UPPER = {"kind": "rectangle", "re": ["1/10", "2"], "im": ["1/10", "1"]}
BESIDE = {
    "to another corner": (BOX, "lower", [(0, -1), (0, 0)], "the rectangle's corner"),
    "from elsewhere": (BOX, "lower", [(0, -2), ("1/10", "-3/20")], "the rectangle's corner"),
    "over the line of the cuts": (BOX, "lower", [(0, -1), (0, 1), ("1/10", "-3/20")], "the rectangle's corner"),
    "across the cut on the left": (
        BOX | {"re": ["-2", "1/10"], "im": ["-1/10", "1"]},
        "lower",
        [(0, -1)],
        "meets a cut",
    ),
    "across a cut": (BOX | {"re": ["1/10", "2"], "im": ["-1/10", "1"]}, "lower", [(0, -1)], "meets a cut"),
    "above the line from below": (
        BOX | {"re": ["1/20", "1/10"], "im": ["1/10", "1"]},
        "lower",
        [(0, -1), ("1/20", "1/20")],
        "the rectangle's corner",
    ),
    "across the line above": (BOX | {"im": ["-1/10", "1"]}, "upper", [(0, -1)], "not above the cuts"),
    "no half": (UPPER, "left", [(0, -1)], "not above the cuts"),
    "of the mirror": (UPPER, "upper", [(0, -1), ("1/10", "-19/20"), (0, -1)], "the rectangle's corner"),
}


@pytest.mark.parametrize("name", BESIDE)
def test_a_way_to_a_rectangle_is_refused(name):
    box, half, link, why = BESIDE[name]
    points = [[str(x) for x in z] for z in link]
    paths = [{"kind": "link", "points": points}, {"kind": "turn", "points": points}]
    with v2.precision(64), pytest.raises(v2.Refused, match=why):
        v2.count_beside(sheet(), v2.read_region(box), None, {"theorem": {"half": half}, "paths": paths}, fmpq(1))
