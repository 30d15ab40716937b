import numpy as np
import pytest

from mpsolve import Problem, certify, response, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.residues import radius_round, residues

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")

ONE = Problem(BEAM, vehicles.Mass(20), v="0.5")


def test_a_residue_is_what_float64_has(balls):
    image, found = balls(ONE), certify(ONE, digits=30, check=False)
    other = response(ONE, times=[3.0])
    with precision(image.bits):
        roots = [acb(0, 1) * root.q for root in found.roots]
        here = next(k for k, z in enumerate(roots) if z.imag > 0)
        others = [*(z for k, z in enumerate(roots) if k != here), acb(0)]
        rows = residues(image, roots[here], others, 0.02, [arb(3)], 60, Effort())
        part = other.induced[0]
        known = (part.rail[0] * np.exp(1j * part.q * 3.0)).real
        assert 2 * float(rows[2][0].real.mid()) == pytest.approx(known, abs=1e-9)
        assert float(rows[2][0].rad()) < 1e-14
        with pytest.raises(PrecisionError):
            residues(image, roots[here] + acb(arb(0, 1), 0), others, 0.02, [arb(3)], 60, Effort())


def test_circles_keep_clear_of_others():
    one, two = acb(0, 1), acb(0, 2)
    assert radius_round(one, [two, -one], 0.5, 1.0) == pytest.approx(0.15)
    assert radius_round(one, [two], 9.0, 1000.0) == pytest.approx(0.004)
    with precision(200):  # nearer than float64 can tell
        assert radius_round(one, [one + arb(10) ** -30], 9.0, 1.0) == pytest.approx(3e-31)
