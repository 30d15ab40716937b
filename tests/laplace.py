"""The independent truth: the paper's transformed displacement (20)–(25), from its p-roots, inverted numerically."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from oracle import Truth

from mpsolve import Case
from mpsolve.model.load import Load


class Inversion:
    """w(ξ, τ) by de Hoog's inversion of the Laplace image along the line of (31): no residues, no cuts."""

    def __init__(self, case: Case, loads: Sequence[Load], digits: int = 30, degree: int = 40) -> None:
        self.truth, self.degree = Truth(case, digits), degree
        number = self.truth.mp.mpf
        self.loads = [
            tuple(
                number(x.as_fraction().numerator) / x.as_fraction().denominator
                for x in (load.constant, load.amplitude, load.frequency, load.phase)
            )
            for load in loads
        ]

    def image(self, s: Any, xi: Sequence[Any]) -> list[Any]:
        """W̃ at the Laplace variable s = iq."""
        truth, mp = self.truth, self.truth.mp
        q, n = s / mp.j, len(truth.x)
        p_roots = truth.p_roots(q)

        def K(gap: Any) -> Any:
            return truth._residue_sum(gap, q, p_roots)

        forces = [4 * (c / s + a * (w * mp.cos(f) + s * mp.sin(f)) / (s * s + w * w)) for c, a, w, f in self.loads]
        rows = mp.matrix(n, n)
        for i in range(n):
            for j in range(n):
                rows[i, j] = mp.pi * (i == j) - 2 * q * q * K(truth.x[i] - truth.x[j]) * truth.eta_m[j]
        right = mp.matrix([sum(K(truth.x[i] - truth.x[j]) * forces[j] for j in range(n)) for i in range(n)])
        W = mp.lu_solve(rows, right)
        total = [forces[j] + 2 * truth.eta_m[j] * q * q * W[j] for j in range(n)]
        return [sum(total[j] * K(mp.mpf(x) - truth.x[j]) for j in range(n)) / mp.pi for x in xi]

    def __call__(self, xi: Sequence[float], tau: float) -> Any:
        mp, known = self.truth.mp, {}

        def image(s: Any, k: int) -> Any:
            if s not in known:
                known[s] = self.image(s, xi)
            return known[s][k]

        values = (
            mp.invertlaplace(lambda s, k=k: image(s, k), tau, method="dehoog", degree=self.degree)
            for k in range(len(xi))
        )
        return np.array([float(mp.re(value)) for value in values])
