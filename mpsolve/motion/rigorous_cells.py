"""Small discs in v over which the p-roots, R·Δ and W̃ are enclosed at once, in rigorous float64.

Each p-root has a disc of its own, by Brouwer's theorem (boxes.py), and a name: a, b upper and c, e lower. The names
are guesses until neighbours are compared: where two discs of v share a point, and no disc of a p-root of the one
meets a disc of another name of the other, both name the p-roots at that point alike.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import flint
import numpy as np

from mpsolve.discs import Discs
from mpsolve.model.boxes import Shifts, disjoint, sharpened
from mpsolve.model.branch import Track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.motion.rigorous_path import Guide, Route
from mpsolve.motion.transform import numerators

acb, arb = flint.acb, flint.arb

NAMES = range(4)


@dataclass(frozen=True)
class Cells:
    """p-roots over discs of v: valid where `known`, then pairwise apart.

    roots, slopes (D_p over each root's disc): in the order a, b, c, e.
    """

    q: Discs
    roots: tuple[Discs, ...]
    slopes: tuple[Discs, ...]
    known: Any

    @property
    def split(self) -> SplitRoots:
        return SplitRoots(*self.roots)

    def alike(self, one: Any, other: Any) -> Any:
        """Whether cells `one` name the p-roots as cells `other` do, given that they share a point."""
        result = np.logical_and(self.known[one], self.known[other])
        for j in NAMES:
            for k in NAMES:
                if j != k:
                    result = result & (self.roots[j][one] - self.roots[k][other]).nonzero()
        return result

    def ball(self, name: int, place: Any) -> Any:
        """The p-root of one cell in a ball."""
        return _ball(self.roots[name], place)

    def slope_ball(self, name: int, place: Any) -> Any:
        return _ball(self.slopes[name], place)


def _ball(disc: Discs, place: Any) -> Any:
    m, r = complex(disc.m[place]), float(disc.r[place])
    return acb(m.real, m.imag) + acb(arb(0, r), arb(0, r))


def cells(track: Track, guide: Guide, way: Route, v: Discs) -> Cells:
    """The p-roots over discs of v, named as the guide does; `track` in discs."""
    with np.errstate(all="ignore"):
        q = way.frequency(track, v)
        shifts = Shifts(track, q)
        found = [shifts.isolate(m) for m in guide.seeds(v.m)]
        proved = np.logical_and.reduce([one.proved for one in found])
        roots = sharpened(found, proved)
        known = proved & disjoint(SplitRoots(*roots))
        r = q - 1j * track.eta_b
        slopes = [(p * p * 4 - track.A * 8) * p + r * track.alpha * 8 for p in roots]
        known = known & np.logical_and.reduce([slope.nonzero() for slope in slopes])
        return Cells(q, tuple(roots), tuple(slopes), known)


def scaled_delta(track: Track, over: Cells) -> Discs:
    """R·Δ; proved to be away from 0 where `known` and `nonzero()`."""
    with np.errstate(all="ignore"):
        kappa = over.q * over.q * 2 / track.field.pi
        value: Discs = scaled_characteristic(track, over.split, (kappa,))[0]
        return value


@dataclass(frozen=True)
class Beam:
    """K and W̃ over named p-roots, in balls or discs: by residues, (37), K(ξ ≥ 0) = 2πi Σ_upper e^{ipξ}/D_p."""

    track: Track
    roots: SplitRoots

    def kernel(self, sign: int, xi: Any) -> Any:
        """K(ξ), ξ of this sign (0 at the contact)."""
        z, i = self.roots, self.track.field.i
        scale = self.track.field.pi * i * 2
        if sign == 0:
            return -(scale * (z.a + z.b) * 2) / z.R
        if sign > 0:
            one = (i * z.a * xi).exp() / ((z.a - z.b) * (z.a - z.c) * (z.a - z.e))
            return scale * (one + (i * z.b * xi).exp() / ((z.b - z.a) * (z.b - z.c) * (z.b - z.e)))
        one = (i * z.c * xi).exp() / ((z.c - z.a) * (z.c - z.b) * (z.c - z.e))
        return -(scale * (one + (i * z.e * xi).exp() / ((z.e - z.a) * (z.e - z.b) * (z.e - z.c))))

    def image(self, q: Any, F: Sequence[Any], gaps: Sequence[Sequence[tuple[int, Any]]]) -> list[Any]:
        """W̃(ξ, q) for each row of gaps (sign, ξ − x_j), by Cramer's rule; not finite where Δ may vanish."""
        track = self.track
        order, kappa, x = range(len(track.eta_m)), q * q * 2 / track.field.pi, track.positions
        contact = self.kernel(0, None)
        kernels = [[contact if i == j else self.kernel((i > j) - (i < j), x[i] - x[j]) for j in order] for i in order]
        rows = [[int(i == j) - kappa * track.eta_m[i] * kernels[i][j] for j in order] for i in order]
        scale = self.roots.R / (scaled_characteristic(track, self.roots, (kappa,))[0] * track.field.pi)
        S = [value * scale for value in numerators(track, rows, F)]
        shown = []
        for row in gaps:
            terms = [s * (self.kernel(*gap) if gap[0] else contact) for s, gap in zip(S, row, strict=True)]
            total = terms[0]
            for term in terms[1:]:
                total = total + term
            shown.append(total)
        return shown
