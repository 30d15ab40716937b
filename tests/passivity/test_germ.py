"""Germs of the point receptance against residue sums and their differences, and that balls hold what points give."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from passive_subjects import TRACKS

from mpsolve.characteristic.floats import Receptance
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.passivity.germ import germ, root_balls
from mpsolve.problem.reduced import Guide, track_guide

NAMES = ["rail", "kelvin-voigt", "string", "timoshenko", "two layers", "slab"]


def rest(name: str) -> tuple[Guide, float, Receptance]:
    track, v = TRACKS[name]
    moving = Receptance(track_guide(track, Fraction(v)))
    return track_guide(track, Fraction(0)), float(moving.guide.v), moving


def at(
    guide: Guide, upper: int, sigma: object, v: object, order: int
) -> tuple[tuple[object, ...], tuple[object, ...]]:
    found = germ(guide.D_rest, guide.N_rest, upper, sigma, v, order)
    return found.value, found.by_velocity


@pytest.mark.parametrize("name", NAMES)
def test_against_residue_sums(name: str) -> None:
    guide, v, receptance = rest(name)
    with precision(120):
        value, by_v = at(guide, receptance.upper, acb(0, 0.7), arb(v), 3)
        G, slope = receptance(np.array([0.7j]), [Fraction(0)])
        assert complex(value[0]) == pytest.approx(G[0][0], rel=1e-9)
        assert complex(value[1]) == pytest.approx(slope[0][0], rel=1e-7)
        h = arb(2) ** -30
        up, down = (at(guide, receptance.upper, acb(0, 0.7), arb(v) + s * h, 3)[0] for s in (1, -1))
        for k in range(4):
            assert complex((up[k] - down[k]) / (2 * h)) == pytest.approx(complex(by_v[k]), rel=1e-7)
        near = at(guide, receptance.upper, acb(0, 0.7) + h, arb(v), 3)[0]
        for k in range(3):
            assert complex((near[k] - value[k]) / ((k + 1) * h)) == pytest.approx(complex(value[k + 1]), rel=1e-6)


@pytest.mark.parametrize("name", NAMES)
def test_balls_hold_points(name: str) -> None:
    guide, v, receptance = rest(name)
    with precision(90):
        width = arb(2) ** -14
        q = arb(0.4).union(arb(0.4) + width)
        wide = at(guide, receptance.upper, acb(0, q), (arb(v)).union(arb(v) + width * v), 2)
        for s, t in ((0.0, 1.0), (0.3, 0.6), (1.0, 0.0)):
            thin = at(guide, receptance.upper, acb(0, arb(0.4) + width * s), arb(v) + width * v * t, 2)
            for one, other in zip(wide, thin, strict=True):
                assert all(a.overlaps(b) and a.rad() >= b.rad() for a, b in zip(one, other, strict=True))


def test_what_cannot_be_told_apart_is_refused() -> None:
    guide, v, receptance = rest("rail")
    with precision(90):
        with pytest.raises(PrecisionError):
            at(guide, receptance.upper, acb(0, arb(0.5, 0.5)), arb(v), 1)
        with pytest.raises(PrecisionError):
            at(guide, 1, acb(0, 0.5), arb(v), 1)
        assert len(root_balls(guide.D_rest, acb(0, 0.5), arb(v))) == 4
