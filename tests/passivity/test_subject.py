"""A subject made of a problem and one made of a family are the same track; distances are those of the places."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any

import numpy as np
import pytest
from passive_subjects import RAIL, TRACKS, family_and_envelope, reduced_and_envelope

from mpsolve import Problem, vehicles
from mpsolve.characteristic.floats import Receptance
from mpsolve.errors import PrecisionError
from mpsolve.numbers.affine import between
from mpsolve.numbers.model import Rational, nonnegative
from mpsolve.passivity.blocks import passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.subject import Subject, cells, floats_of, wavenumbers
from mpsolve.problem.family import family_of
from mpsolve.tracks.waveguide import Track


def test_a_family_at_a_point_is_the_problem() -> None:
    pair = Problem(RAIL, [vehicles.Mass(900), vehicles.Mass(900).at("2.5")], v=150)
    family, envelope = family_and_envelope(pair, {"track.k": (9e5, 11e5), "gap[0]": (2, 3), "v": (100, 200)})
    x = [(Fraction(a) + Fraction(b)) / 2 for a, b in family.box]
    q = np.geomspace(0.1, 3, 40)[:, None]
    rows = np.broadcast_to([float(t) for t in x], (40, 3))
    whole = np.concatenate([q, rows], 1)
    guide, places = family.guide(x), [place.at(x) for place in family.places]
    alone = Envelope(Subject.of_guide(guide, places), (), ())
    # but for the bound of short waves, which is one for the whole family
    assert (passive_on(envelope, whole, whole) != passive_on(alone, q, q)).sum() <= 2


def test_distances_are_told_once() -> None:
    _, envelope = reduced_and_envelope("rail", 4)
    distances, number = envelope.subject.distances([])
    assert len(distances) == 3
    assert number[3, 2] == number[2, 1] == number[1, 0]
    gaps = [float(d.a) for d in distances]
    assert gaps[number[3, 0]] == pytest.approx(3 * gaps[number[1, 0]])


def test_a_free_velocity() -> None:
    reduced, _ = reduced_and_envelope("rail", 1)
    subject = Subject.of_guide(reduced.guide, free_velocity=True)
    low, high = np.array([[0.2]]), np.array([[0.3]])
    speed = subject.speed(subject.parameters(low, high))
    assert speed.low[0, 0] <= 0.2
    assert speed.high[0, 0] >= 0.3
    assert floats_of(subject.v.items(), np.array([[0.25]]))[0] == 0.25
    assert between(low, high, "v").b["v"][0, 0] == pytest.approx(0.05)


class Pushing(Track, frozen=True):
    """A string whose damper pushes at short waves."""

    c2: Annotated[Rational, nonnegative("N s", "push")]

    @staticmethod
    def equations(x: Any) -> list[list[Any]]:
        return [[x.s**2 + 4 * x.s + x.c2 * x.s * x.P**2 - x.P**2 + x.P**4 + 1]]


def test_a_track_that_may_give_energy_is_refused() -> None:
    family = family_of(
        Problem(Pushing(c2="0.1"), vehicles.Mass(1), v="0.1"), {"track.c2": (Fraction(1, 20), Fraction(1, 10))}
    )
    with pytest.raises(PrecisionError, match="take energy"):
        Subject.of_family(family)


@pytest.mark.parametrize("name", TRACKS)
def test_cells(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 1)
    v, q = float(reduced.guide.v), np.array([0.3, 1.0, 7.0])
    ends = cells(envelope.subject, q, np.zeros((3, 0)), np.zeros(3), 12)
    assert (np.diff(ends, axis=1) >= 0).all()
    roots = wavenumbers(envelope.subject, q, np.full(3, v), np.zeros((3, 0)))
    for row in range(3):
        assert q[row] / v > ends[row, -1] or np.abs(ends[row] - q[row] / v).min() == 0
        for root in roots[row]:
            if abs(root.real) < ends[row, -1] and abs(root.imag) > 1e-4:
                assert np.abs(ends[row] - root.real).min() < 1e-9 * max(abs(root), 1)


@pytest.mark.parametrize("name", TRACKS)
def test_wavenumbers(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 1)
    q = np.array([0.3, 2.0])
    mine = wavenumbers(envelope.subject, q, np.full(2, float(reduced.guide.v)), np.zeros((2, 0)))
    theirs = Receptance(reduced.guide).roots(1j * q) / 1j
    for a, b in zip(mine, theirs, strict=True):
        assert np.sort(np.abs(a)) == pytest.approx(np.sort(np.abs(b)), rel=1e-8)


def test_wavenumbers_far_out_are_those_of_the_rail_alone() -> None:
    """EI p⁴ = m q²: at q = 10⁸ no coefficient may be lost beside q²."""
    reduced, envelope = reduced_and_envelope("rail", 1)
    guide, q = reduced.guide, 1e8
    found = wavenumbers(envelope.subject, np.array([q]), np.array([float(guide.v)]), np.zeros((1, 0)))
    assert np.abs(found) == pytest.approx((q * q * float(guide.D_rest[0, 2] / guide.D_rest[4, 0])) ** 0.25, rel=1e-3)
