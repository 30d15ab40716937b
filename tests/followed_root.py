"""The lowest root of two masses over their distance, seen from a line near it, for tests of what follows it."""

from __future__ import annotations

from fractions import Fraction
from functools import cache

import numpy as np

from mpsolve import Case
from mpsolve.problem.cases import as_problem
from mpsolve.problem.shifted import shifted
from mpsolve.ranges.scope import Scope, checked_over, scope_of
from mpsolve.spectrum.candidates import nearest_root

LOWEST, HEIGHT = 0.5616442738, 2.0**-5 * 1.2  # x̂ = d/2 of the lowest root; a line near it
ROOT = 0.171721077 - 0.037841542j


@cache
def plain_scope() -> Scope:
    problem = as_problem(Case(alpha="0.99", eta_b="0.5", eta_m=(70, 70), positions=(0, 1)))
    return scope_of(problem, checked_over(problem, {"gap[0]": ("0.5", 2)}))


@cache
def shifted_scope() -> Scope:
    return Scope(shifted(plain_scope().family, Fraction(HEIGHT)))


def roots(scope: Scope, x: np.ndarray) -> np.ndarray:
    q, out = ROOT + 1j * HEIGHT, []
    for at in x:
        q = nearest_root(scope.family.reduced([Fraction(at)]), q) or q
        out.append(q)
    return np.array(out)
