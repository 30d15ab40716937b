"""A second way to the complete motion: the Laplace integral on a path of its own, over the paper's sums of residues.

The path starts below every induced frequency and the poles of the forces, so that it gives the complete motion
without any residue; it crosses the cut and leaves at another height than the package's. The p-roots follow by nearest
neighbours from node to node. Nothing is proved here, and no formula of the package is used; flint's numbers serve as
many-digit arithmetic.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import flint

from mpsolve import Case
from mpsolve.numbers.balls import precision
from mpsolve.vehicles.load import Load

acb, arb = flint.acb, flint.arb


def _number(x: Any) -> Any:
    fraction = x.as_fraction()
    return arb(flint.fmpq(fraction.numerator, fraction.denominator))


class Continued:
    """w(ξ, τ) of `case` under `loads`, by Gauss–Legendre panels with `order` nodes each, at `bits` bits."""

    def __init__(self, case: Case, loads: Sequence[Load], bits: int = 160) -> None:
        self.bits = bits
        with precision(bits):
            self.alpha, self.eta_b = _number(case.alpha), _number(case.eta_b)
            self.A = _number(case.eta_n) - _number(case.eta_s) + self.alpha**2
            self.eta_m, self.x = [_number(v) for v in case.eta_m], [_number(v) for v in case.positions]
            self.loads = [tuple(_number(v) for v in (a.constant, a.amplitude, a.frequency, a.phase)) for a in loads]

    def motion(
        self,
        xi: Sequence[Any],
        tau: Sequence[Any],
        centre: float,
        depth: float,
        corner: float,
        height: float,
        end: float,
        step: float,
        order: int,
    ) -> list[list[Any]]:
        """w, shape (len(xi), len(tau)). q = centre + iη_b + v²/2, centre next to the limiting frequency.

        The path starts at q = −i·depth, turns at v = corner + i·height, and leaves along Im v = height up to
        Re v = end, in panels of length `step` in v.
        """
        with precision(self.bits):
            start = (2 * (acb(0, -depth) - acb(centre, self.eta_b))).sqrt().mid()
            return self._integral(xi, tau, centre, [start, acb(corner, height), acb(end, height)], step, order)

    def _integral(
        self, xi: Any, tau: Any, centre: float, corners: list[Any], step: float, order: int
    ) -> list[list[Any]]:
        rule = [arb.legendre_p_root(order, k, weight=True) for k in reversed(range(order))]
        places, times = [arb(x) for x in xi], [arb(t) for t in tau]
        total = [[arb(0)] * len(times) for _ in places]
        roots: list[Any] = []
        for low, high in pairwise(corners):
            count = int(float(abs(high - low)) / step) + 1
            half = (high - low) / (2 * count)
            for k in range(count):
                for x, weight in rule:
                    v = (low + half * (2 * k + 1 + x)).mid()
                    q = acb(centre, self.eta_b) + v * v / 2
                    roots = self._roots(q, roots)
                    images = self._images(q, roots, places)
                    for column, t in enumerate(times):
                        wave = (acb(0, 1) * q * t).exp() * v * half * weight / arb.pi()
                        for row, image in enumerate(images):
                            total[row][column] = (total[row][column] + (image * wave).real).mid()
        return total

    def _roots(self, q: Any, before: list[Any]) -> list[Any]:
        """The p-roots, upper ones first."""
        r = q - acb(0, self.eta_b)
        D = flint.acb_poly([4 * (1 - self.eta_b**2 - r * r), 8 * self.alpha * r, -4 * self.A, 0, 1])
        slope = D.derivative()
        found = [p.mid() for p in D.roots()]
        if not before:
            found = sorted(found, key=lambda p: -float(p.imag))
        else:
            found = [min(found, key=lambda p, o=o: float(abs(p - o))) for o in before]
        for _ in range(3):
            found = [(p - D(p) / slope(p)).mid() for p in found]
        return found

    def _images(self, q: Any, roots: list[Any], places: list[Any]) -> list[Any]:
        i, pi = acb(0, 1), arb.pi()
        # D_p of (18)
        terms = [(p, 4 * p**3 - 8 * self.A * p + 8 * self.alpha * (q - i * self.eta_b)) for p in roots]

        def K(g: Any) -> Any:
            pick, sign = (terms[:2], 2) if g >= 0 else (terms[2:], -2)
            return sign * pi * i * sum((i * p * g).exp() / slope for p, slope in pick)

        s, n = i * q, len(self.x)
        F = [4 * C / s + 4 * A * (s * phi.sin() + w * phi.cos()) / (s * s + w * w) for C, A, w, phi in self.loads]
        rows = [
            [int(j == k) - 2 * q * q / pi * self.eta_m[j] * K(self.x[j] - self.x[k]) for k in range(n)]
            for j in range(n)
        ]
        S = flint.acb_mat(rows).solve(flint.acb_mat([[f] for f in F]))
        return [sum(S[j, 0] * K(x - self.x[j]) for j in range(n)) / pi for x in places]
