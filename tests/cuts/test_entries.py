"""The bordered matrix against the receptance by its residues, at arbitrary p-roots."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from mpsolve.characteristic.bordering import Bordering
from mpsolve.cuts.entries import Parts, of_one, of_two
from mpsolve.cuts.sloped import Sloped
from mpsolve.numbers.balls import acb, precision


def number(x: complex) -> Sloped:
    return Sloped(acb(complex(x).real, complex(x).imag), ())


APART = (1.1j, 0.7j + 0.2, -1.0 - 1.4j, 0.8 - 0.4j)
MET = (0.7j + 2e-9, 0.7j - 2e-9, -0.7j + 1e-9, -0.7j - 1e-9)


@pytest.mark.parametrize(("roots", "met"), [(APART, False), (MET, True)])
def test_the_determinant_is_that_of_the_receptance_over_g(roots: tuple[complex, ...], met: bool) -> None:
    """With one unknown over G(0), with two over both residues, and then bounded where both pairs meet."""
    rng = np.random.default_rng(4)
    a, b, a2, b2 = roots
    assert abs(sum(roots)) < 1e-12
    lead, N, sigma, places = 0.25, 1.3, 0.2 + 0.9j, (0.0, 1.1)
    S, B, h = rng.normal(size=(3, 2, 2)), np.diag([1.0, 2.0]), (0.3, 0.0)
    pencil = S[0] + S[1] * sigma + S[2] * sigma**2
    ordered = np.array([a, a2, b, b2])
    weight = [N / (lead * np.prod([z - w for w in ordered if w != z])) for z in ordered]

    def G(xi: float) -> complex:
        side, sign = (slice(0, 2), 1) if xi >= 0 else (slice(2, 4), -1)
        return sign * sum(w * np.exp(z * xi) for w, z in zip(weight[side], ordered[side], strict=True))

    over = {1: G(0.0), 2: weight[0] * weight[1]}
    gain = np.array([[G(x - y) for y in places] for x in places]) + np.diag(h)
    truth = np.linalg.det(np.block([[pencil, -B], [B.T, gain]]))

    exact = [Fraction(x) for x in places]
    bodies = [[[Fraction(x) for x in row] for row in rows] for rows in (*S, B)]
    given: Any = SimpleNamespace(S=bodies[:3], B=bodies[3], h=[Fraction(x) for x in h], places=exact, index=(0, 1))
    for unknowns, received in ((1, of_one), (2, of_two)):
        border = Bordering.of(given, eliminate=False, waves=unknowns)
        contacts, apart = ([number(float(x)) for x in some] for some in (exact, border.distances))
        with precision(80):
            parts = Parts(
                *map(number, (a, b, a2, b2, lead, N, sigma)), contacts, apart, border.signs, number(1), number(0)
            )
            g = np.array([complex(x.value.mid()) for x in received(parts)])
        f = np.array([sum(float(c) * sigma**k for k, c in enumerate(row)) for row in border.polynomials])
        if unknowns == 2 or not met:
            found = np.linalg.det(border.matrix(f, g))
            assert abs(found / (truth / over[unknowns]) - 1) < (1e-5 if met else 1e-12)
