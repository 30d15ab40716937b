"""The splitting, the receptances and Δ̂ at a ball of σ, proved: what is returned holds for every σ of the ball."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from mpsolve.characteristic.bordering import Bordering
from mpsolve.characteristic.receptance import by_companions
from mpsolve.characteristic.roots import Orders, apart, float_roots, root_balls, sharp_roots
from mpsolve.characteristic.splitting import Factors, Splitting, factor_balls, monic, sides, upper_count
from mpsolve.characteristic.spread import Spread
from mpsolve.characteristic.symbol import Coefficients, Symbols, Terms
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import Balls, acb, acb_mat, is_thin
from mpsolve.numbers.reduction import Reduction, det_and_trace
from mpsolve.problem.reduced import Reduced

if TYPE_CHECKING:
    from mpsolve.numbers.arrays import Complexes

_K = Balls()


@frozen
class ProvedSplitting:
    """U and L in balls, or their roots in balls of their own, upper ones first; `signed`: Re P < 0 and > 0 is proved.

    Where it is not, the roots are those of the n₊ smallest real parts at the midpoint, apart from the others: the
    caller must know why they are the upper ones.
    """

    symbols: Symbols
    sigma: Any
    upper: int
    roots: tuple[acb, ...] | None
    factors: Factors | None
    signed: bool

    @cached_property
    def splitting(self) -> Splitting:
        """As coefficients."""
        lead = _K.evaluate(self.symbols.D.rows[-1], self.sigma)
        if self.factors is not None:
            return Splitting(lead, *self.factors)
        roots = self.roots or ()
        return Splitting(lead, monic(roots[: self.upper]), monic(roots[self.upper :]))

    @cached_property
    def weights(self) -> tuple[acb, ...]:
        """N/D_P at each root: the least that a value of G takes."""
        if not is_thin(self.sigma):
            return tuple(term.w for term in self.terms)
        D, N = (Orders(x, self.sigma).wide for x in (self.symbols.D, self.symbols.N))
        slope = D.derivative()
        return tuple(N(z) / slope(z) for z in self.roots or ())

    @cached_property
    def terms(self) -> tuple[Terms, ...]:
        """The terms of G and of its slope, where the roots are simple."""
        s = self.symbols
        orders = [Orders(x, self.sigma) for x in (s.D, s.N, s.D_sigma, s.N_sigma)]
        if is_thin(self.sigma):
            local = Coefficients(*(x.orders[0].coeffs() for x in orders))
            return tuple(local.terms(root) for root in self.roots or ())
        out = []
        for root in self.roots or ():
            middle = root.mid()
            local = Coefficients(*(x.about(middle) for x in orders))
            out.append(replace(local.terms(root - middle), z=root))
        return tuple(out)

    def receptances(self, xi: Sequence[Any] | Spread, slope: bool = True) -> tuple[list[acb], list[acb]]:
        """G(ξ, σ) for each exact ξ, and where asked its slope in σ; `PrecisionError` where balls are too wide."""
        spread = xi if isinstance(xi, Spread) else Spread(tuple(xi))
        if self.roots is None:
            local, ahead = self.symbols.at(_K, self.sigma), [x >= 0 for x in spread.exact]
            G, G_sigma = by_companions(_K, local, self.splitting, spread.balls, ahead, slope)
        else:
            G, G_sigma = self._by_residues(spread, slope)
        if not all(g.is_finite() for g in (*G, *G_sigma)):
            raise PrecisionError("the receptance may be infinite over the ball: split the piece")
        return G, G_sigma

    def _by_residues(self, spread: Spread, slope: bool) -> tuple[list[acb], list[acb]]:
        roots, count, thin = self.roots or (), len(spread.exact), is_thin(self.sigma)
        G, G_sigma, xi = [acb(0)] * count, [acb(0)] * (count if slope else 0), spread.balls
        for side in spread.sides:
            here = slice(0, self.upper) if side.sign > 0 else slice(self.upper, None)
            if not side.own or not roots[here]:
                continue
            parts = [[t.w, t.a, t.b] for t in self.terms[here]] if slope else [[w] for w in self.weights[here]]
            sums = (acb_mat(side.waves(roots[here], thin)) * acb_mat(parts) * side.sign).tolist()
            for k, (value, *rates) in zip(side.own, sums, strict=True):
                G[k] = value
                if slope:
                    G_sigma[k] = rates[0] + xi[k] * rates[1]
        return G, G_sigma


def split_ball(symbols: Symbols, sigma: Any, upper: int) -> ProvedSplitting:
    """The splitting over a ball of σ at the precision that is set; `PrecisionError` where it cannot be proved."""
    sigma = acb(sigma)
    middle = [row(sigma.mid()) for row in symbols.D.balls()]
    z = float_roots(middle, symbols.degree)
    if apart(z):
        try:
            roots = tuple(root_balls(symbols.D, sigma, z))
        except PrecisionError:  # over the ball roots of one side may meet
            roots = ()
        if roots:
            signed = all(x.real < 0 for x in roots[:upper]) and all(x.real > 0 for x in roots[upper:])
            return ProvedSplitting(symbols, sigma, upper, roots, None, signed)
    try:
        factors = factor_balls(symbols.D, sigma, z, upper)
        signed = sides(factors, z, upper)
    except PrecisionError:
        found = told_apart(symbols, sigma, (middle, z), upper)
        if found is None:
            raise
        return found
    found = None if signed else told_apart(symbols, sigma, (middle, z), upper)
    return found or ProvedSplitting(symbols, sigma, upper, None, factors, signed)


def told_apart(symbols: Symbols, sigma: Any, near: tuple[list[acb], Complexes], upper: int) -> ProvedSplitting | None:
    """The splitting by sides where roots nearly meet, closer than floats tell; None where it is open.

    near: the coefficients of D at the middle, and floats near its roots.
    """
    try:
        roots = tuple(root_balls(symbols.D, sigma, sharp_roots(*near)))
    except PrecisionError:
        return None
    signed = all(x.real < 0 for x in roots[:upper]) and all(x.real > 0 for x in roots[upper:])
    return ProvedSplitting(symbols, sigma, upper, roots, None, True) if signed else None


class Proved:
    """Δ̂ of a problem in balls, at the precision that is set.

    Its premise: σ is in the part of the plane that reaches to Re σ → ∞ without crossing a cut (Re σ > 0, or above
    −h for h below the lowest cut), where the upper p-roots are the n₊ with Re P < 0. signed: refuse a ball of σ at
    which these signs are not proved; with signed=False the caller must know which roots are upper. eliminate: take
    out the bodies of direct contacts (see `Bordering`), so that the matrix is smaller.
    """

    def __init__(self, reduced: Reduced, signed: bool = True, eliminate: bool = True) -> None:
        self.reduced = reduced
        self.symbols = Symbols.of(reduced.guide)
        self.border = Bordering.of(reduced, eliminate)
        self.spread = Spread(self.border.distances)
        self.signed = signed

    @cached_property
    def upper(self) -> int:
        """n₊, proved."""
        return upper_count(self.symbols.D)

    @cached_property
    def lossless(self) -> bool:
        """Whether nothing damps: then roots off the cuts come in pairs q, q̄."""
        track = all(
            j % 2 == 0
            for j in (*(j for _, j in self.reduced.guide.D_rest), *(j for _, j in self.reduced.guide.N_rest))
        )
        return track and not any(map(any, self.reduced.S[1])) and not self.reduced.neutral

    def splitting(self, sigma: Any) -> ProvedSplitting:
        """The splitting over the ball σ."""
        split = split_ball(self.symbols, sigma, self.upper)
        if self.signed and not split.signed:
            raise PrecisionError("a p-root may be real, so which side it belongs to is open: split the piece")
        return split

    def matrices(self, sigma: Any, slope: bool = True, mean: bool = True) -> tuple[Any, Any]:
        """A(σ) and A'(σ) as acb_mat.

        mean: over a wide ball A by the mean value, from its middle and its slope, which is narrower and costs more.
        """
        sigma = acb(sigma)
        mean = mean and not is_thin(sigma)
        G, G_sigma = self.splitting(sigma).receptances(self.spread, slope or mean)
        A_sigma = self.border.slope_at(_K, sigma, G, G_sigma) if slope or mean else None
        if not mean:
            return self.border.at(_K, sigma, G), A_sigma
        middle = sigma.mid()
        inner = self.splitting(middle).receptances(self.spread, False)[0]
        return self.border.at(_K, middle, inner) + A_sigma * (sigma - middle), A_sigma

    def delta(self, sigma: Any) -> tuple[acb, acb]:
        """Δ̂ and dΔ̂/dσ over the ball σ."""
        A, A_sigma = self.matrices(sigma)
        if is_thin(sigma):
            value, trace = det_and_trace(A, A_sigma)
            if trace.is_finite():
                return value, value * trace
        return Reduction.of(A).determinant(A, A_sigma)


__all__ = ["Proved", "ProvedSplitting", "split_ball", "upper_count"]
