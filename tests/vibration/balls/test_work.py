import math

import pytest

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.progress import silent
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.work import Work
from mpsolve.vibration.path import Path

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")


def test_the_parts_make_up_the_whole_whatever_the_line(balls):
    """Another α crosses other ground: the sum must be the same."""
    problem = Problem(BEAM, vehicles.Mass(20), v="0.5")
    image, found = balls(problem), certify(problem, digits=30, check=False)
    totals = []
    with precision(image.bits):
        poles = [acb(0, 1) * root.q for root in found.roots]
        for alpha in (0.2, 0.4):
            work = Work(image, poles, Path(alpha), [arb(3)], (8, 0), Effort(), silent, lambda _: math.inf)
            total, steady, harmonic, transient = work.parts([100.0] * 3)
            assert (total - steady - harmonic - transient)[0, 0].contains(0)
            totals.append(total[0, 0])
        assert totals[0].overlaps(totals[1])
        assert max(float(x.rad()) for x in totals) < 1e-5
        with pytest.raises(PrecisionError, match="on the path"):
            Work(
                image, [acb(arb(0.3, 0.01), 1)], Path(0.3), [arb(3)], (8, 0), Effort(), silent, lambda _: math.inf
            ).parts([100.0] * 3)
