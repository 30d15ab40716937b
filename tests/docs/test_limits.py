"""The page on ranges without boxes: its formulas against p-roots, and its orders beyond the speed of shear waves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from theory_pages import THEORY, displayed

PAGE = (THEORY / "limits.md").read_text("utf-8")
EI, S, J = 0.25, 4.0, 0.01  # the page's beam, m = k = 1, c = 0.1: waves at 2 and 5


def weights(sigma: complex, v: float) -> tuple[Any, Any]:
    """N/D_P of the one wave that runs ahead of the contact, or two, and of those behind."""
    s = np.polynomial.Polynomial([sigma, -v])
    P = np.polynomial.Polynomial([0, 1])
    b = -EI * P**2 + J * s**2 + S
    D = (-S * P**2 + s**2 + 0.1 * s + 1) * b + S**2 * P**2
    roots = D.roots()
    roots = roots[np.argsort(roots.real)]
    each = b(roots) / D.deriv()(roots)
    count = 2 if v < 2 else 1
    return each[:count], each[count:]


def test_the_orders_to_the_front_and_to_the_rear() -> None:
    """Ahead together, G(0); behind one by one, as they part by their delays."""
    assert displayed(PAGE, "1 = ").startswith(r"1 = \kappa")
    for v, order in ((3, 3), (1.5, 1)):
        near, far = (abs(weights(s, v)[0].sum()) for s in (2e3j, 4e3j))
        assert near / far == pytest.approx(2**order, rel=0.02)
    near, far = (max(abs(weights(s, 3)[1])) for s in (2e3j, 4e3j))
    assert near / far == pytest.approx(2, rel=0.02)


def test_the_radicand_of_a_string() -> None:
    assert "4T(m" in displayed(PAGE, "G(0)")
    T, m, k, c, v, s = 2.0, 1.5, 0.7, 0.3, 0.9, 0.4 + 1.1j
    roots = np.roots([-(T - m * v * v), -v * (2 * m * s + c), m * s * s + c * s + k])
    D = np.array([-(T - m * v * v), -v * (2 * m * s + c), m * s * s + c * s + k])
    (ahead,) = roots[roots.real < 0]
    G = 1 / np.polyval(np.polyder(D), ahead)
    assert G**2 * (4 * T * (m * s * s + c * s + k) + v * v * (c * c - 4 * m * k)) == pytest.approx(1)
