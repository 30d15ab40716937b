"""A and its slopes in balls: the matrix of the problem, and difference quotients in every parameter."""

from free_cases import of_many

from mpsolve.characteristic.free_matrix import FreeMatrix
from mpsolve.characteristic.free_proved import FreeProved
from mpsolve.characteristic.proved import Proved
from mpsolve.numbers.balls import acb, arb, precision, rational_ball


def test_the_matrix_is_that_of_the_problem() -> None:
    family = of_many()
    x = [a + (b - a) / 3 for a, b in family.box]
    with precision(128):
        sigma = acb("0.01", "0.9")
        free = FreeProved(family, FreeMatrix(family).receptance.track.up)
        A, _ = free.matrices(sigma, [rational_ball(y) for y in x])
        whole = Proved(family.reduced(x)).matrices(sigma, False)[0]
        assert all((a - b).contains(0) for a, b in zip(A.entries(), whole.entries(), strict=True))
        assert max(float(a.rad()) for a in A.entries()) < 1e-30


def test_slopes_are_those_of_difference_quotients() -> None:
    family = of_many()
    x = [a + (b - a) / 3 for a, b in family.box]
    with precision(300):
        free = FreeProved(family, FreeMatrix(family).receptance.track.up)
        at = [acb("0.01", "0.9"), *(acb(rational_ball(y)) for y in x)]
        _, slopes = free.matrices(at[0], at[1:])
        step = arb(2) ** -100
        for k, slope in enumerate(slopes):
            ends = []
            for sign in (1, -1):
                moved = [y + sign * step if i == k else y for i, y in enumerate(at)]
                ends.append(free.matrices(moved[0], moved[1:], slopes=False)[0])
            quotient = (ends[0] - ends[1]) / (2 * step)
            for a, b in zip(quotient.entries(), slope.entries(), strict=True):
                assert abs(a - b) < (1 + abs(b)) * arb(2) ** -150
