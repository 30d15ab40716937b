"""Points of lines: any number of digits, and only the root of the line itself."""

from fractions import Fraction

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem, certify
from mpsolve.loci.lines import frequency_lines
from mpsolve.numbers.balls import precision

PROBLEM = Problem(BEAM, PAIR, v="0.9")


@pytest.mark.parametrize("digits", [15, 60])
def test_points_have_the_digits_that_are_asked_for(digits: int) -> None:
    values = [Fraction("0.7"), Fraction("0.705")]
    found = frequency_lines(PROBLEM, over={"v": ("0.7", "0.71")}, points=values, digits=digits, check=False)
    assert found.values == tuple(values)
    for k, value in enumerate(values):
        height = found.region.height  # type: ignore[union-attr]
        roots = certify(PROBLEM.changed("v", value), region=("below", height), digits=digits, check=False).roots
        with precision(4 * digits):
            for line in found.lines:
                ball = line.q[k]
                assert sum(bool(ball.overlaps(root.q)) for root in roots) == 1
                assert max(ball.real.rad(), ball.imag.rad()) < abs(ball).upper() * 10**-digits
