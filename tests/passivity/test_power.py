"""The parts of W and |D|² against D and N themselves, exactly, and over boxes."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from passive_subjects import TRACKS, reduced_and_envelope

from mpsolve.numbers.affine import Affine, between
from mpsolve.passivity.power import coefficient, moved, value


@pytest.mark.parametrize("name", TRACKS)
def test_parts_are_those_of_the_quotient(name: str) -> None:
    reduced, envelope = reduced_and_envelope(name, 1)
    power = envelope.subject.power
    for p, omega in ((Fraction(2, 3), Fraction(5, 7)), (Fraction(3), Fraction(-1, 2))):
        D, N = (
            sum(float(c) * (1j * float(p)) ** i * (1j * float(omega)) ** j for (i, j), c in a.items())
            for a in (reduced.guide.D_rest, reduced.guide.N_rest)
        )
        w, real, imaginary = (
            float(sum(c * p ** (2 * i) * omega ** (2 * j) for (i, j), c in a.items()))
            for a in (power.w, power.real, power.imaginary)
        )
        assert complex(real, imaginary * float(omega)) == pytest.approx(D, rel=1e-12)
        assert w * float(omega) == pytest.approx(-(N * np.conj(D)).imag, rel=1e-10, abs=1e-12)
    (iw, nw), (i2, n2) = power.quotient.degrees
    assert i2 == 2 * max(i for i, _ in reduced.guide.D_rest)
    assert n2 == 2 * max(i + j for i, j in reduced.guide.D_rest)
    assert power.alpha == min(i2 - iw, n2 - nw)


def test_a_polynomial_over_a_box() -> None:
    terms = {(1, 2, 0): Fraction(1, 3), (0, 1, 2): Fraction(-2), (3, 0, 1): Fraction(5)}
    x, y, t = (between(np.array([a]), np.array([a + 0.2]), name) for a, name in ((1.0, "x"), (-2.0, "y"), (0.5, "t")))
    form = value(terms, x, y, [t])
    for a in (1.0, 1.1, 1.2):
        for b in (-2.0, -1.8):
            for c in (0.5, 0.7):
                exact = a * b**2 / 3 - 2 * b * c**2 + 5 * a**3 * c
                assert form.low[0] - 1e-12 <= exact <= form.high[0] + 1e-12
    assert moved(terms, lambda i, j: (3 - i, j)) == {
        (2, 2, 0): Fraction(1, 3), (3, 1, 2): Fraction(-2), (0, 0, 1): Fraction(5)}  # fmt: skip


def test_a_coefficient() -> None:
    t = Affine(np.array(2.0))
    assert float(coefficient([((3,), Fraction(1, 4)), ((0,), Fraction(1))], [t]).a) == 3.0
    assert float(coefficient([], [t]).a) == 0.0
