"""Balls hold the truth of mpmath at random points inside; nothing passes across a branch cut or a pole."""

from __future__ import annotations

import random

import mpmath
import pytest
from flint import acb, arb

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision
from mpsolve.zeros.evaluate import CutError, Evaluator, PoleError, coefficients
from mpsolve.zeros.parse import parse
from mpsolve.zeros.program import Program

CASES = {
    "sin(z)*exp(z) - z**5": lambda z: mpmath.sin(z) * mpmath.exp(z) - z**5,
    "log(z + 3)*sqrt(z + 4)": lambda z: mpmath.log(z + 3) * mpmath.sqrt(z + 4),
    "rgamma(z) + erf(z)": lambda z: mpmath.rgamma(z) + mpmath.erf(z),
    "airy_ai(z) - airy_bi(z)": lambda z: mpmath.airyai(z) - mpmath.airybi(z),
    "bessel_j(1, z**2)": lambda z: mpmath.besselj(1, z**2),
    "bessel_j(-2, z)": lambda z: mpmath.besselj(-2, z),
    "cos_sqrt(z)*sinc_sqrt(z + 1)": lambda z: mpmath.cos(mpmath.sqrt(z)) * mpmath.sinc(mpmath.sqrt(z + 1)),
    "sinh(z) + cosh(2*z) + atan(z/4)": lambda z: mpmath.sinh(z) + mpmath.cosh(2 * z) + mpmath.atan(z / 4),
    "1/(z + 5) + tan(z/9)": lambda z: 1 / (z + 5) + mpmath.tan(z / 9),
}


def evaluator(text: str) -> Evaluator:
    p = Program()
    parse(p, text)
    return Evaluator(p.steps)


@pytest.mark.parametrize("text", CASES)
@pytest.mark.parametrize("seed", range(4))
def test_taylor_coefficients_hold_the_truth_at_points_inside(text: str, seed: int) -> None:
    rng = random.Random(seed)
    centre, radius = complex(rng.uniform(-2, 2), rng.uniform(-2, 2)), 10 ** rng.uniform(-6, -1)
    ball = acb(arb(centre.real, radius), arb(centre.imag, radius))
    with precision(100):
        row = coefficients(evaluator(text).run(ball, 4)[-1], 4)
        with mpmath.workdps(60):
            for _ in range(5):
                inside = complex(
                    centre.real + radius * rng.uniform(-1, 1) * 0.999,
                    centre.imag + radius * rng.uniform(-1, 1) * 0.999,
                )
                truth = mpmath.taylor(CASES[text], mpmath.mpc(inside), 3)
                for one, value in zip(truth, row, strict=True):
                    point = acb(arb(mpmath.nstr(one.real, 40)), arb(mpmath.nstr(one.imag, 40)))
                    assert value.overlaps(point + acb(arb(0, 1e-25), arb(0, 1e-25)))


@pytest.mark.parametrize(
    ("text", "ball"),
    [
        ("sqrt(z)", acb(arb(-1, 0.1), arb(0, 0.1))),
        ("log(z)", acb(arb(-1, 0.1), arb(0, 1e-30))),
        ("sqrt(z)", acb(0)),
        ("sqrt(z)", acb(-1)),
        ("z**(1/3)", acb(arb(-1, 0.1), arb(0, 0.1))),
        ("log(log(z))", acb(arb(0.5, 0.1), arb(0, 0.1))),
        ("asin(z)", acb(arb(2, 0.1), arb(0, 0.1))),
        ("atan(z)", acb(arb(0, 0.1), arb(2, 0.1))),
        ("acosh(z)", acb(arb(0.5, 0.1), arb(0, 0.1))),
        ("asinh(z)", acb(arb(0, 0.1), arb(2, 0.1))),
        ("sqrt(1 - z**2)", acb(arb(2, 0.1), arb(0, 0.1))),
    ],
)
def test_no_ball_across_a_cut_passes(text: str, ball: acb) -> None:
    for n in (1, 2):
        with pytest.raises(CutError):
            evaluator(text).run(ball, n)


def test_no_ball_round_a_pole_passes() -> None:
    for text in ("1/z", "tan(z + pi/2)", "gamma(z)", "cos(1/z)", "1/(1/z)"):
        for n in (1, 2):
            with pytest.raises(PoleError):
                evaluator(text).run(acb(arb(0, 0.01), arb(0, 0.01)), n)


def test_beside_a_cut_a_root_is_continued_from_the_named_side() -> None:
    f = evaluator("sqrt(z**2 + 1)")
    line = acb(0, arb(2, 0.1))
    for side in (1, -1):
        value = f.sided(line, 2, line, acb(side))[-1]
        near = complex(mpmath.sqrt(mpmath.mpc(side * 1e-12, 2.05) ** 2 + 1))
        assert value[0].contains(acb(0, arb(near.imag)))
        assert value[0].imag > 0 if side > 0 else value[0].imag < 0


def test_a_cut_off_the_named_line_or_seen_along_it_is_refused() -> None:
    f = evaluator("sqrt(z**2 + 1)")
    off = acb(1e-3, arb(2, 0.1))
    wide = acb(arb(0, 0.1), arb(2, 0.1))
    with pytest.raises(CutError):
        f.sided(wide, 2, off, acb(1))
    with pytest.raises(CutError):
        f.sided(wide, 2, acb(0, arb(2, 0.1)), acb(0, 1))  # along the line w stays real


def test_a_cut_that_is_longer_than_declared_is_refused() -> None:
    f = evaluator("sqrt(z)")
    edge, box = acb(arb(0.05, 0.05), 0), acb(arb(0.05, 0.05), arb(0.05, 0.05))
    f.sided(box, 2, edge, acb(0, 1), (acb(0), acb(1)))  # the cut ends at 0, this edge lies beyond
    late = acb(arb(-0.05, 0.05), 0)
    with pytest.raises(CutError):
        f.sided(late + acb(0, arb(0.05, 0.05)), 2, late, acb(0, 1), (acb(-0.1), acb(1)))
    assert issubclass(CutError, PrecisionError)
