"""Python functions read on a symbol: what uses z alone is an expression, what is not analytic is refused by name."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import acb, arb

from mpsolve.errors import InputError
from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.program import Program
from mpsolve.zeros.trace import UnreadableError, takes_flag, trace

POINT = acb(0.7, -0.4)


@pytest.mark.parametrize(
    "f",
    [
        lambda z: z.sin() - z / 2,
        lambda z: 2**z + z**3 - z**-1,
        lambda z: acb(1, 2) * z + z * arb(0.25) - 1j * z + Fraction(1, 3),
        lambda z: 1 - z + (+z) * (-z),
        lambda z: z.sqrt(analytic=True) * z.log(analytic=False),
        lambda z: z.bessel_j(3),
    ],
)
def test_the_expression_has_the_values_of_the_function(f: Callable[[Any], Any]) -> None:
    p = Program()
    k = trace(p, f)
    truth = f(POINT) if "Fraction" not in str(f.__code__.co_names) else None
    assert truth is None or Evaluator(p.steps).run(POINT, 1)[k].overlaps(truth)


def test_functions_of_numpy_and_loops_are_read() -> None:
    def f(z: Any) -> Any:
        total = 0
        for k in range(5):
            total = total * z + k
        return total + np.exp(z)

    p = Program()
    k = trace(p, f)
    assert Evaluator(p.steps).run(acb(1), 1)[k].overlaps(acb(10) + acb(1).exp())


@pytest.mark.parametrize(
    "f",
    [lambda z: z.conjugate(), abs, lambda z: z.real + 1, lambda z: z.imag, lambda z: z.sgn(), lambda z: z.mid(),
     lambda z: z.real_abs()],
)  # fmt: skip
def test_parts_of_z_are_refused_by_name(f: Callable[[Any], Any]) -> None:
    with pytest.raises(InputError, match="not analytic"):
        trace(Program(), f)


@pytest.mark.parametrize(
    "f",
    [lambda z: acb(z).sin(), lambda z: 1 if z == 0 else z, complex, float,
     lambda z: z + arb.pi(), lambda z: z.root(3), lambda z: max(z, 1), lambda z: f"{z:.3f}", lambda z, _: z],
)  # fmt: skip
def test_what_a_symbol_cannot_follow_is_told(f: Callable[..., Any]) -> None:
    with pytest.raises((UnreadableError, InputError)):
        trace(Program(), f)


def test_the_flag_of_flint_is_seen() -> None:
    assert takes_flag(lambda z, analytic: z.sqrt(analytic))
    assert not takes_flag(lambda z: z)
    assert not takes_flag(lambda z, scale=2: z * scale)
