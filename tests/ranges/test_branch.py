"""A root followed through boxes: it holds the true root and no other, and its slopes are those of differences."""

from __future__ import annotations

import numpy as np
import pytest
from followed_root import LOWEST, roots, shifted_scope

from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.ranges.branch import Tube, tube
from mpsolve.ranges.scope import Scope


@pytest.fixture(scope="module")
def scope() -> Scope:
    return shifted_scope()


def followed(scope: Scope, low: float, high: float, parts: int, shift: complex = 0) -> Tube | None:
    x = np.linspace(low, high, 2 * parts + 1)
    with precision(80):
        return tube(scope.matrix, roots(scope, x) + shift, [arb(t) for t in x[::2]])


def test_it_holds_the_root_and_no_other(scope: Scope) -> None:
    found = followed(scope, LOWEST - 0.01, LOWEST + 0.01, 4)
    assert found is not None
    for x in np.linspace(LOWEST - 0.0099, LOWEST + 0.0099, 7):
        (q,) = roots(scope, np.array([x]))
        assert found.holds(acb(q), arb(x))
        assert not found.holds(acb(q + 0.05), arb(x))
    assert not found.holds(acb(roots(scope, np.array([LOWEST]))[0]), arb(LOWEST + 0.02))
    assert found.bends_up(0, 4)
    assert (found.rises, found.falls) == (False, False)


def test_signs_of_slopes(scope: Scope) -> None:
    before, behind = followed(scope, 0.5, 0.52, 4), followed(scope, 0.6, 0.62, 4)
    assert before is not None
    assert behind is not None
    assert (before.falls, before.rises, behind.falls, behind.rises) == (True, False, False, True)
    for found, x in ((before, 0.5), (behind, 0.6)):
        part = found.parts[0]
        q = roots(scope, np.array([x, x + 1e-6]))
        slope = (q[1] - q[0]).imag / 1e-6 * part.r_x / part.r_q
        assert any(abs(float(rise.mid()) - slope) < 0.05 * abs(slope) + 2 * float(rise.rad()) for rise in part.rises)


def test_where_there_is_no_root_nothing_is_followed(scope: Scope) -> None:
    assert followed(scope, LOWEST - 0.01, LOWEST + 0.01, 4, shift=0.05) is None
