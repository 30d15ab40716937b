"""A pair that becomes two imaginary roots: an overdamped suspension, both ways, against certified spectra."""

from fractions import Fraction

import pytest

from mpsolve import Problem, certify, tracks, vehicles
from mpsolve.loci.answer import FrequencyLines
from mpsolve.loci.lines import frequency_lines
from mpsolve.numbers.balls import rational_ball
from mpsolve.outcome import Status

TRACK = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.5")
PROBLEM = Problem(TRACK, vehicles.Oscillator(wheel="0.1", body=1, k="0.01", c="0.15").at(0), v="0.3")
PATH = "vehicles[0].c"


@pytest.fixture(scope="module", params=[("0.15", "0.25"), ("0.19", "0.25"), ("0.15", "0.205")])
def found(request: pytest.FixtureRequest) -> FrequencyLines:
    """Roots are counted in the middle of the range: before or behind the place where two meet."""
    return frequency_lines(PROBLEM, over={PATH: request.param}, points=4, check=False)


def test_the_pair_ends_where_two_imaginary_roots_begin(found: FrequencyLines) -> None:
    assert found.status is Status.UNVERIFIED
    assert found.counts == (2,)
    pair, *single = found.lines
    assert [line.weight for line in (pair, *single)] == [2, 1, 1]
    assert [end.kind for end in pair.ends] == ["range", "collision"]
    for line in single:
        assert [end.kind for end in line.ends] == ["collision", "range"]
        assert line.ends[0].value.overlaps(pair.ends[1].value)
        assert all(q.real.is_zero() for q in line.q)


def test_certified_roots_change_their_kind_within_the_ball(found: FrequencyLines) -> None:
    ball = found.lines[0].ends[1].value
    assert ball.rad() < 1e-3
    for value, real in ((Fraction(float(ball.lower())), True), (Fraction(float(ball.upper())), False)):
        roots = certify(PROBLEM.changed(PATH, value), region=("below", "0.23"), check=False).roots
        assert len(roots) == 2
        assert all(bool(root.q.real.is_zero()) is not real for root in roots)
    assert not ball.contains(rational_ball(Fraction("0.15")))
