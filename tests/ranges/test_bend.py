"""A root that is convex over a short interval is told to be; nothing is told where there is no root."""

from __future__ import annotations

import numpy as np
from followed_root import LOWEST, roots, shifted_scope

from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.ranges.bend import is_convex
from mpsolve.ranges.curves import RootCurve


def test_convex_at_the_lowest_point_only() -> None:
    scope = shifted_scope()
    x = np.linspace(LOWEST - 0.004, LOWEST + 0.004, 9)
    q = roots(scope, x)
    curve = RootCurve(scope.proved)
    with precision(80):
        first = complex(curve.near((acb(q[4]),), arb(x[4]))[1][0])

    def path(at: float) -> complex:
        return complex(np.interp(at, x, q.real), np.interp(at, x, q.imag))

    assert is_convex(scope.matrix, scope.proved, path, x[3], x[5], first)
    assert not is_convex(scope.matrix, scope.proved, lambda at: path(at) + 0.05, x[3], x[5], first)
