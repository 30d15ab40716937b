"""A subject made of a problem and one made of a family are the same track; distances are those of the places."""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any

import numpy as np
import pytest
from passive_subjects import RAIL, family_and_envelope, reduced_and_envelope

from mpsolve import Problem, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.affine import between
from mpsolve.numbers.model import Rational, nonnegative
from mpsolve.passivity.blocks import passive_on
from mpsolve.passivity.envelope import Envelope
from mpsolve.passivity.subject import Subject, floats_of
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
