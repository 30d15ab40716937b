"""The matrix along the cut in balls, against the characteristic function in mpmath just off the cut."""

import pytest
from cut_cases import family
from oracle import Truth

from mpsolve import Case
from mpsolve.cuts.balls import EdgeBalls
from mpsolve.numbers.balls import arb, precision


@pytest.mark.parametrize(("side", "p"), [(-1, -2.0), (1, 1.2), (1, -0.5), (-1, -1.4)])
def test_the_determinant_is_the_characteristic_function_next_to_the_cut(side: int, p: float) -> None:
    """Ratios of det at two points, without g, against those of Δ from mpmath, just off the cut."""
    step, values = 1e-9, []
    for alpha in ("0.9", "0.901"):
        case = Case(alpha=alpha, eta_b="0.05", eta_m=(70, 40), positions=(0, "1.5"))
        with precision(80):
            balls = EdgeBalls(family(), side)
            at = balls.edge(arb(p), arb(float(alpha)))
            if not side * float(at.lean.value.real) > 0:
                pytest.skip("the other side")
            A = balls.matrices(arb(p), arb(float(alpha)))[0]
            det, over_g = complex(A.det().mid()), complex(A[2, 2].mid())
            q = complex(at.z.value.real.mid()) + 0.05j
        truth = complex(Truth(case, 30).delta(q + 1j * side * step))
        values.append(det / over_g / truth)
    assert abs(values[0] / values[1] - 1) < 1e-6


@pytest.mark.parametrize(("side", "p"), [(-1, -2.0), (1, 1.2)])
def test_slopes_are_those_of_differences(side: int, p: float) -> None:
    balls = EdgeBalls(family(), side)
    with precision(160):
        step, x = arb(2) ** -50, arb("0.9")
        _, slopes = balls.matrices(arb(p), x)
        for k, (dp, dx) in enumerate(((step, 0), (0, step))):
            ahead, back = (balls.matrices(arb(p) + s * dp, x + s * dx)[0] for s in (1, -1))
            off = (ahead - back) * (1 / (2 * step)) - slopes[k]
            assert max(abs(complex(y.mid())) for y in off.entries()) < 1e-20
