"""The independent truth: the paper's transformed displacement (20)–(25), from its p-roots, inverted numerically.

Nothing of the package's formulas, residues, cuts or paths is used: the integral (32) is taken as it stands, along a
line below every singularity.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from oracle import Truth, _polynomial

from mpsolve import Case
from mpsolve.vehicles.load import Load


@dataclass(frozen=True)
class Line:
    """How (32) is summed: the trapezoidal rule with step 2π/T along Im q = −a, faded out towards large |Re q|.

    Such a rule gives w(τ) and, with alternating signs, w(τ + kT) e^{−akT} for k ≥ 1: T = `periods`·τ, and
    (a − growth) T = `drop`. To fade out by erfc((Re q − c)/σ)/2 is to average w over times near τ with a weight that
    falls to e^{−fall} at τ = 0, where alone w is not analytic: σ = 2 √fall/τ. Nothing fades where Re q < `least`.
    """

    periods: float = 3.0
    drop: float = 32.0
    fall: float = 34.0
    least: float = 10.0

    def nodes(
        self, case: Case, loads: Sequence[Load], xi: Sequence[float], tau: float, growth: float
    ) -> tuple[Any, Any, float]:
        """q in Re q > 0, how far each has faded (2 to 0), and the step, so short a float that all q are exact.

        growth: more than the rate at which the motion grows.
        """
        half = 2 * self.fall / tau  # erfc falls from 2 to 0 within 2 half
        fastest = max(abs(float(load.frequency)) for load in loads)
        c = self.least + fastest + self._waves(case, xi, tau) + half
        step = float(np.float32(2 * np.pi / (self.periods * tau)))
        real = step * (np.arange((c + half) / step) + 0.5)
        fading = np.array([math.erfc(x) for x in (real - c) / half * np.sqrt(self.fall)])
        return real - 1j * (growth + self.drop / (self.periods * tau)), fading, step

    def _waves(self, case: Case, xi: Sequence[float], tau: float) -> float:
        """Re q beyond which nothing passes at τ: what has gone the distance D does so with q = D²/2τ².

        It has gone between the masses to and fro n times, each time reflected by about one half.
        """
        x = [float(v) for v in case.positions]
        n = np.arange(150)[:, None]
        D = 2 * n * (x[-1] - x[0]) + 1.5 * np.array([abs(a - b) for a in xi for b in x])
        q = np.maximum(D * D / (2 * tau * tau), 1.0)
        size = 4 / float(min(case.eta_m)) * 0.6**n * q**-2.5 / np.sqrt(tau)
        return float(np.max(q[size > 1e3 * math.exp(-self.fall)], initial=0.0))


@dataclass(frozen=True)
class Inversion:
    """w(ξ, τ), τ > 0, in mpmath; `growth`: more than the rate at which the motion grows."""

    case: Case
    loads: Sequence[Load]
    growth: float = 0.0
    digits: int = 30
    line: Line = Line()

    def __call__(self, xi: Sequence[float], tau: float) -> Any:
        truth = Truth(self.case, self.digits)
        mp = truth.mp
        loads = [
            tuple(
                mp.mpf(x.as_fraction().numerator) / x.as_fraction().denominator
                for x in (load.constant, load.amplitude, load.frequency, load.phase)
            )
            for load in self.loads
        ]
        places, total = [mp.mpf(x) for x in xi], [mp.mpf(0)] * len(xi)
        nodes, fading, step = self.line.nodes(self.case, self.loads, xi, tau, self.growth)
        for point, share in zip(nodes.tolist(), fading.tolist(), strict=True):
            q = mp.mpmathify(point)
            turn = share * mp.expj(q * tau)
            total = [w + (W * turn).real for w, W in zip(total, image(truth, loads, q, places), strict=True)]
        return np.array([float(w * step / (2 * mp.pi)) for w in total])


def image(truth: Truth, loads: Sequence[Any], q: Any, xi: Sequence[Any]) -> list[Any]:
    """W̃(ξ, q) by (20), (25) and (37)."""
    mp, x, n = truth.mp, truth.x, len(truth.x)
    D = truth.quartic(q)
    ahead, behind = ([(p, 2j * mp.pi / _polynomial(D, p)[1]) for p in half] for half in truth.p_roots(q))
    known: dict[Any, Any] = {}

    def K(gap: Any) -> Any:
        if gap not in known:
            terms, sign = (ahead, 1) if gap >= 0 else (behind, -1)
            known[gap] = sign * sum(mp.expj(p * gap) * c for p, c in terms)
        return known[gap]

    s, factor = mp.j * q, 2 * q * q
    F = [4 * (c / s + a * (w * mp.cos(f) + s * mp.sin(f)) / (s * s + w * w)) for c, a, w, f in loads]
    rows = [[mp.pi * (i == j) - factor * K(x[i] - x[j]) * truth.eta_m[j] for j in range(n)] for i in range(n)]
    right = [sum(K(x[i] - x[j]) * F[j] for j in range(n)) for i in range(n)]
    W = mp.lu_solve(mp.matrix(rows), mp.matrix(right))
    total = [F[j] + factor * truth.eta_m[j] * W[j] for j in range(n)]
    return [sum(total[j] * K(place - x[j]) for j in range(n)) / mp.pi for place in xi]
