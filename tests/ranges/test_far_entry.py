"""What a certificate of a range says of high frequencies."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from itertools import product

import pytest
from free_cases import BEAM, PAIR

from mpsolve import Problem, tracks
from mpsolve.errors import CertificateError
from mpsolve.passivity.far import far_numbers
from mpsolve.ranges.far_entry import beyond, far_entry
from mpsolve.ranges.scope import Scope, checked_over, scope_of


@pytest.fixture(scope="module")
def scope() -> Scope:
    problem = Problem(BEAM, PAIR, v="0.9")
    return scope_of(problem, checked_over(problem, {"track.c": ("0.1", "0.3")}))


def test_cells_lie_between_their_ends_and_ascend() -> None:
    ends = beyond(Fraction(3), Fraction(40))
    assert [Fraction(3) < x < 40 for x in ends] == [True] * len(ends)
    assert all(1 < b / a < 1.3 for a, b in zip([Fraction(3), *ends], [*ends, Fraction(40)], strict=True))
    assert beyond(Fraction(3), Fraction(3)) == []


def test_bounds_of_short_waves_hold(scope: Scope) -> None:
    """|W|/|D|² ≤ Cp^−α for p ≥ p₀, 0 ≤ −Ω ≤ vp (SPEC2 6.2); of D = p⁴/4 + 1 − Ω² + icΩ, W = cΩ."""
    far = far_numbers(scope.envelope)
    assert far is not None
    entry = far_entry(scope, far, Fraction(100))
    assert entry["Q"] == [25, 2]
    alpha = entry["alpha"]
    for (m, e), (n, f) in entry["bounds"]:
        start, C = m * 2.0**e, n * 2.0**f
        for c, p in product((0.1, 0.3), (start, 2 * start, 50 * start)):
            for share in (0.1, 0.3, 0.5, 0.7, 0.9, 1):
                Omega = share * 0.9 * p
                assert c * Omega * p**alpha <= C * abs(p**4 / 4 + 1 - Omega**2 + 1j * c * Omega) ** 2


def test_a_scaling_that_is_no_power_of_two_is_refused() -> None:
    problem = Problem(tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770), PAIR, v=100)
    scope = scope_of(problem, checked_over(problem, {"v": (90, 100)}))
    far = far_numbers(scope.envelope)
    assert far is not None
    with pytest.raises(CertificateError, match="power of two"):
        far_entry(scope, replace(far, gamma=far.gamma + Fraction(1, 3)), Fraction(100))
