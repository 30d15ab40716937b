import pytest

from mpsolve import Case, InputError, Load, response
from mpsolve.problem.cases import as_problem
from mpsolve.vibration.case_motion import Response
from mpsolve.vibration.motion import Vibration

CASE = Case(alpha="0.5", eta_b="0.05", eta_m=20)


def test_a_problem_and_a_case_are_answered_in_their_own_units():
    mine = response(as_problem(CASE), [Load(1)], times=[5])
    paper = response(CASE, [Load(1)], tau=[5])
    assert (type(mine), type(paper)) == (Vibration, Response)
    assert 2 * mine.rail == pytest.approx(paper.w, rel=1e-9)


def test_balls_and_digits_of_a_case():
    ball = response(CASE, [Load(1)], tau=[5], balls=True).w[0, 0]
    number = response(CASE, [Load(1)], tau=[5], digits=10).w[0, 0]
    assert abs(float(ball.mid()) - float(number)) < 1e-10


def test_what_is_no_problem_is_refused():
    with pytest.raises(InputError, match="problem"):
        response("x", times=[1])
