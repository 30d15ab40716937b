"""−Im G(0, q) > 0 on boxes of (q, v) by the waves of the track: G is the sum of residues at p-roots, a Taylor model.

On a box that holds q = 0 the test is of −Im G/q, on q and −q at once: G(0, 0) is real, and a remainder R that is
analytic on |u| ≤ 1 with |R| ≤ e has |R(u) − R(0)| ≤ 2 e |u| (Schwarz).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import Any

import numpy as np

from mpsolve.characteristic.discs import side_nodes
from mpsolve.characteristic.free_roots import roots_over
from mpsolve.numbers.arrays import Reals, Truths
from mpsolve.numbers.forms import Forms
from mpsolve.numbers.jets import TINY, UP, U
from mpsolve.numbers.quadratic import Quadratic
from mpsolve.problem.reduced import Guide
from mpsolve.tracks.waveguide import Polynomial


@dataclass(frozen=True)
class Waves:
    """A scaled track whose first `upper` p-roots lie ahead; the velocity is free."""

    guide: Guide
    upper: int

    @cached_property
    def forms(self) -> tuple[Forms, Forms]:
        """D and N in (σ, v), by powers of P."""
        return _by_powers(self.guide.D_rest), _by_powers(self.guide.N_rest)

    def receptance(self, low: Reals, high: Reals) -> tuple[Quadratic, Truths]:
        """(G(0) as models over the boxes (q, v) between corners of shape (2, boxes), where they are bounded)."""
        with np.errstate(all="ignore"):
            m = low / 2 + high / 2
            r = np.maximum(high - m, m - low) * UP + 2.0**-1000
            y, rho = m.astype(complex), r.astype(complex)
            y[0] *= 1j
            rho[0] *= 1j
            D, N = (form(y, rho) for form in self.forms)
            lead = D[:, -1]
            least = (np.abs(lead.a) - lead.spread) * (1 - 64 * U)
            roots = roots_over(D, N, side_nodes(D.k[0][:, None, :], self.upper), least, self.upper)
            G = roots.weight[:, : self.upper].sum(-1)
            return G, roots.good[:, : self.upper].all(1) & np.isfinite(G.e) & np.isfinite(G.k).all(0)

    def passes(self, low: Reals, high: Reals) -> Any:
        """For boxes (q, v), q ≥ 0: whether −Im G(0, q) > 0 is proved, −Im G/q > 0 where the box begins at q = 0."""
        touching = low[0] == 0
        below = low.copy()
        below[0] = np.where(touching, -high[0], low[0])
        G, good = self.receptance(below, high)
        with np.errstate(all="ignore"):
            k = -G.k.imag
            slack = G.e + 64 * (len(k) + 4) * U * np.abs(G.k).sum(0) + TINY
            away = k[0] - np.abs(k[1:]).sum(0) - slack * UP
            # (1, q, v, q², q v, v²): what has a factor q, divided by it
            slope = k[1] - np.abs(k[3]) - np.abs(k[4]) - 2 * slack * UP
            return good & (np.where(touching, slope, away) > 0)

    def rises(self, low: Reals, high: Reals) -> Any:
        """For boxes (q, v): whether ∂²Im G/∂q∂v > 0 is proved on them.

        Models of boxes twice as wide are taken: where a remainder is at most e on |u| ≤ 1, its mixed derivative is at
        most 4 e on |u| ≤ 1/2 (Cauchy).
        """
        m, r = low / 2 + high / 2, (high / 2 - low / 2) * (1 + 2.0**-20)
        G, good = self.receptance(m - 2 * r, m + 2 * r)
        with np.errstate(all="ignore"):
            slack = 4 * G.e + 64 * U * np.abs(G.k).sum(0) + TINY
            return good & (G.k.imag[4] - slack * UP > 0)


def _by_powers(polynomial: Polynomial) -> Forms:
    """Σ c P^i (σ − v P)^j by powers of P, with monomials in (σ, v)."""
    rows: list[dict[tuple[int, ...], Any]] = [{} for _ in range(max(i + j for i, j in polynomial) + 1)]
    for (i, j), c in polynomial.items():
        for k in range(j + 1):
            row, key = rows[i + k], (j - k, k)
            row[key] = row.get(key, 0) + c * comb(j, k) * (-1) ** k
    used = max(i for i, row in enumerate(rows) if any(row.values()))
    return Forms.of([{key: c for key, c in row.items() if c} for row in rows[: used + 1]], 2)
