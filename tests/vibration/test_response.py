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


@pytest.mark.parametrize(
    ("given", "options", "said"),
    [
        (as_problem(CASE), {"tau": [1]}, r"response\(\) of a Problem missing a required argument: 'times': its arg"),
        (as_problem(CASE), {"times": [1], "tau": [1]}, "of a Problem got an unexpected keyword argument 'tau'"),
        (as_problem(CASE), {}, r"response\(\) of a Problem missing a required .*'times'"),
        (as_problem(CASE), {"times": [1], "digits": 20}, "of a Problem .*'digits'"),
        (CASE, {"times": [1]}, r"response\(\) of a case of the paper .*'times': its arguments are loads, xi, tau"),
        (CASE, {"tau": [1], "balls": True, "initial": "rest"}, "of a case of the paper .*'initial'"),
        (CASE, {"tau": [1], "digits": 9, "places": [0]}, "of a case of the paper .*'places'"),
    ],
)
def test_a_wrong_argument_is_one_of_response(given, options, said):
    """It was one of `vibrate()` or `motion_of_case()`, which nobody had called."""
    with pytest.raises(TypeError, match=said):
        response(given, **options)
