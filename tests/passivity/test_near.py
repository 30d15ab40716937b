"""−Im G/q near q = 0, against residue sums: never told where it is not so, and told where it is clear."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from passive_subjects import TRACKS

from mpsolve.characteristic.floats import Receptance
from mpsolve.numbers.affine import Affine
from mpsolve.passivity.near import Near, divided
from mpsolve.passivity.subject import Subject
from mpsolve.problem.reduced import track_guide


def truth(track: object, v: float, unit: Fraction, q: float) -> float:
    """−Im G(0, q)/q in floats, over |G|."""
    receptance = Receptance(track_guide(track, Fraction(v) / unit))  # type: ignore[arg-type]
    G = receptance(np.array([1j * max(q, 1e-5)]), [Fraction(0)], False)[0][0][0]
    return float(-G.imag / max(q, 1e-5) / abs(G))


@pytest.mark.parametrize("name", ["rail", "kelvin-voigt", "timoshenko", "two layers"])
def test_against_residue_sums(name: str) -> None:
    track, v = TRACKS[name]
    guide = track_guide(track, Fraction(0))
    unit = Fraction(2) ** (guide.time - guide.length)
    top = float(v * unit) * 2.2
    subject = Subject.of_guide(guide, free_velocity=True)
    near, told = Near(subject, (0.0,), (top,), 0.1), []
    for speed in np.linspace(0.05, 0.99, 14) * top:
        for a, b in ((0.0, 0.01), (0.01, 0.03), (0.06, 0.0625)):
            passes = near.passes(np.array([[a, speed]]), np.array([[b, speed * 1.001]]), 48)[0]
            values = [truth(track, u, unit, q) for u in (speed, speed * 1.001) for q in (a, (a + b) / 2, b)]
            assert not passes or min(values) > -1e-9
            told += [passes] if min(values) > 0.3 else []
    assert not told or np.mean(told) > (0.7 if name in ("rail", "kelvin-voigt") else 0.1)


def test_a_divided_difference() -> None:
    terms = {(1, 3): Fraction(2), (0, 1): Fraction(-1), (2, 0): Fraction(7), (0, 2): Fraction(1, 2)}
    f = lambda y, z: 2 * y * z**3 - z + 7 * y**2 + z**2 / 2  # noqa: E731
    y, a, b = (Affine(np.array(x)) for x in (1.5, 0.75, -0.25))
    assert float(divided(terms, y, a, b, []).a) == pytest.approx((f(1.5, 0.75) - f(1.5, -0.25)) / 1.0)
