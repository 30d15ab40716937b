"""The characteristic matrix of a family in balls: at (σ̂, x̂), with its slopes in σ̂ and in every parameter.

The premise is that of `characteristic.proved`: σ̂ where the upper p-roots are the n₊ with Re P < 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, cast

from mpsolve.characteristic.bordering import Bordering, vector
from mpsolve.characteristic.proved import split_ball
from mpsolve.characteristic.symbol import Symbols
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, acb_mat, acb_poly, rational_ball
from mpsolve.numbers.several import Several, evaluated
from mpsolve.problem.family import Family
from mpsolve.problem.free_track import FreePolynomial
from mpsolve.tracks.waveguide import slope_in_s


class BallSymbol:
    """D or N with balls for the parameters: what `Symbol` is for exact ones."""

    def __init__(self, polynomial: FreePolynomial, x: Sequence[Any], size: int) -> None:
        self._terms, self._x = polynomial, x
        self.rows: tuple[Any, ...] = ((),) * size

    def balls(self) -> list[acb_poly]:
        """The rows as polynomials in σ at the precision that is set."""
        rows: list[dict[int, Any]] = [{} for _ in self.rows]
        for (i, j), c in self._terms.items():
            rows[i][j] = value_at(c, self._x)
        return [acb_poly([row.get(j, 0) for j in range(max(row, default=0) + 1)]) for row in rows]

    def at(self, _: Any, sigma: Any) -> list[Any]:
        return [row(sigma) for row in self.balls()]


def value_at(c: Several, x: Sequence[Any]) -> Any:
    """A polynomial in the parameters at balls."""
    return evaluated(c, x, lambda factor: acb(rational_ball(factor)))


def slope_of(c: Several, k: int) -> Several:
    """The derivative in the k-th parameter."""
    terms = {(*e[:k], e[k] - 1, *e[k + 1 :]): e[k] * value for e, value in c if e[k]}
    return Several(c.ring, terms)


@dataclass(frozen=True)
class FreeProved:
    """A and its slopes in balls, at the precision that is set."""

    family: Family
    upper: int

    @cached_property
    def border(self) -> Bordering:
        return Bordering.of(self.family)

    @cached_property
    def _present(self) -> FreePolynomial:
        """D without powers of P that are not there at the only point of the family: a damping that is still 0."""
        point, D = self.family.ring.point, self.family.D
        if any(a != b for a, b in self.family.over.values()):
            return D
        top = max(i for (i, _), c in D.items() if c.at(point))
        return {key: c for key, c in D.items() if key[0] <= top}

    @cached_property
    def _slopes(self) -> list[tuple[FreePolynomial, FreePolynomial]]:
        """Of D and N in σ and in each parameter."""
        D, N = self.family.D, self.family.N
        out = [(slope_in_s(D), slope_in_s(N))]
        for k in range(len(self.family.paths)):
            first, second = ({key: slope for key, c in a.items() if (slope := slope_of(c, k))} for a in (D, N))
            out.append((first, second))
        return out

    def matrices(self, sigma: Any, x: Sequence[Any], slopes: bool = True) -> tuple[acb_mat, list[acb_mat]]:
        """(A, [∂A/∂σ, ∂A/∂x₁, …]); `PrecisionError` where balls cannot decide."""
        sigma, x = acb(sigma), [acb(y) for y in x]
        G, turned = self._receptances(sigma, x, slopes)
        terms = [[(k, value_at(c, x), c) for k, c in enumerate(f)] for f in self.border.polynomials]
        f, g = vector([sum((c * sigma**k for k, c, _ in some), acb(0)) for some in terms]), vector(G)
        out = []
        for n, g_slope in enumerate(turned):
            if n:
                rates = [
                    sum((value_at(slope_of(c, n - 1), x) * sigma**k for k, _, c in some), acb(0)) for some in terms
                ]
            else:
                rates = [sum((k * c * sigma ** (k - 1) for k, c, _ in some if k), acb(0)) for some in terms]
            out.append(acb_mat(self.border.slope(f, g, vector(rates), vector(g_slope)).tolist()))
        return acb_mat(self.border.matrix(f, g).tolist()), out

    def _receptances(self, sigma: Any, x: list[Any], slopes: bool) -> tuple[list[acb], list[list[acb]]]:
        """G at each distance, and for σ and each parameter its slopes."""
        size = self.family.degree + 1
        D = BallSymbol(self._present, x, max(i for i, _ in self._present) + 1)
        N = BallSymbol(self.family.N, x, max(i for i, _ in self.family.N) + 1)
        none = BallSymbol({}, x, 1)
        split = split_ball(cast(Symbols, _Pairs(D, N, none, none)), sigma, self.upper)
        if split.roots is None or not split.signed:
            raise PrecisionError("the p-roots cannot be told apart here: take smaller balls")
        each = []
        for D_slope, N_slope in self._slopes if slopes else []:
            turned = (BallSymbol(D_slope, x, size), BallSymbol(N_slope, x, len(N.rows)))
            each.append(replace(split, symbols=cast(Symbols, _Pairs(D, N, *turned))).terms)
        G: list[Any] = []
        out: list[list[Any]] = [[] for _ in each]
        weights = [term.w for term in each[0]] if each else list(split.weights)
        for distance, way in zip(self.border.distances, self.border.signs, strict=True):
            side, sign = (slice(0, self.upper), 1) if way >= 0 else (slice(self.upper, None), -1)
            xi = value_at(distance, x)
            waves = [(xi * z).exp() * sign for z in split.roots[side]]
            G.append(sum((w * e for w, e in zip(weights[side], waves, strict=True)), acb(0)))
            for k, terms in enumerate(each):
                moved = sum(((t.a + xi * t.b) * e for t, e in zip(terms[side], waves, strict=True)), acb(0))
                if k and (rate := slope_of(distance, k - 1)):
                    grown = (w * z * e for w, z, e in zip(weights[side], split.roots[side], waves, strict=True))
                    moved += value_at(rate, x) * sum(grown, acb(0))
                out[k].append(moved)
        if not all(g.is_finite() for row in (G, *out) for g in row):
            raise PrecisionError("the receptance may be infinite over the ball: split the piece")
        return G, out


@dataclass(frozen=True)
class _Pairs:
    """What `Symbols` holds, in balls."""

    D: BallSymbol
    N: BallSymbol
    D_sigma: BallSymbol
    N_sigma: BallSymbol

    @property
    def degree(self) -> int:
        return len(self.D.rows) - 1


__all__ = ["BallSymbol", "FreeProved", "slope_of", "value_at"]
