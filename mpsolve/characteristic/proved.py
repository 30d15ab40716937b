"""The splitting and the receptances at a ball of σ, proved: what is returned holds for every σ of the ball.

With approximations z_1 … z_n of the p-roots and W_k = D(z_k)/(lead Π (z_k − z_i)), D/lead is the characteristic
polynomial of diag(z) − W·1ᵀ; by Gershgorin each group of the discs |P − z_k| ≤ n|W_k| that is apart from the others
holds as many roots as it has discs (Smith). Where roots of one side meet, U and L come from Krawczyk's test on their
coefficients, and the same discs, for U and for L, say which roots they hold.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from mpsolve.characteristic.determinant import Bordering
from mpsolve.characteristic.receptance import Coefficients, Terms, by_companions
from mpsolve.characteristic.splitting import Splitting, monic, sharpened, sylvester, upper_count
from mpsolve.characteristic.symbol import Symbol, Symbols, horner, product, slope_in_P
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import Balls, acb, acb_mat, acb_poly, arb, bits_now, exact_ball, precision, square
from mpsolve.numbers.reduction import Reduction
from mpsolve.problem.reduced import Reduced

_K = Balls()
_NEAR = 2.0**-12
"""Roots of one side that are nearer than this, relative to the largest root, are taken together."""
_SEED_BITS = 40


@dataclass(frozen=True)
class ProvedSplitting:
    """U and L in balls, or their roots in balls of their own, upper ones first; `signed`: Re P < 0 and > 0 is proved.

    Where it is not, the roots are those of the n₊ smallest real parts at the midpoint, apart from the others: the
    caller must know why they are the upper ones.
    """

    symbols: Symbols
    sigma: Any
    upper: int
    roots: tuple[Any, ...] | None
    factors: tuple[tuple[Any, ...], tuple[Any, ...]] | None
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
    def terms(self) -> tuple[Terms, ...]:
        """The terms of G, where the roots are simple."""
        s, z = self.symbols, self.sigma
        every = (s.D, s.N, s.D_sigma, s.N_sigma)
        if _is_exact(z):
            local = Coefficients(*(x.at(_K, z) for x in every))
            return tuple(local.terms(root) for root in self.roots or ())
        orders, out = [_Orders(x, z) for x in every], []
        for root in self.roots or ():
            middle = root.mid()
            local = Coefficients(*(x.about(middle) for x in orders))
            out.append(replace(local.terms(root - middle), z=root))
        return tuple(out)

    def receptances(self, xi: Sequence[Any], slope: bool = True) -> tuple[list[Any], list[Any]]:
        """G(ξ, σ) for each exact ξ, and where asked its slope in σ; `PrecisionError` where balls are too wide."""
        if self.roots is None:
            G, G_sigma = by_companions(_K, self.symbols, self.splitting, self.sigma, xi, slope)
        else:
            G, G_sigma = self._by_terms(xi, slope)
        if not all(g.is_finite() for g in (*G, *G_sigma)):
            raise PrecisionError("the receptance may be infinite over the ball: split the piece")
        return G, G_sigma

    def _by_terms(self, xi: Sequence[Any], slope: bool) -> tuple[list[Any], list[Any]]:
        G, G_sigma = [], []
        for x in xi:
            terms, sign = (self.terms[: self.upper], 1) if x >= 0 else (self.terms[self.upper :], -1)
            ball = _K.number(x)
            waves = [(ball * term.z).exp() if x else acb(1) for term in terms]
            G.append(sum((sign * term.w * e for term, e in zip(terms, waves, strict=True)), acb(0)))
            if slope:
                each = zip(terms, waves, strict=True)
                G_sigma.append(sum((sign * (term.a + ball * term.b) * e for term, e in each), acb(0)))
        return G, G_sigma


def split_ball(symbols: Symbols, sigma: Any, upper: int) -> ProvedSplitting:
    """The splitting over a ball of σ at the precision that is set; `PrecisionError` where it cannot be proved."""
    sigma = acb(sigma)
    local = _Local(symbols.D, sigma)
    z = _approximations(local.middle, upper)
    if _apart(z, upper):
        discs = _discs(local, z)
        return ProvedSplitting(symbols, sigma, upper, tuple(discs), None, _signed(discs, upper))
    return _by_coefficients(symbols, sigma, local, z, upper)


class _Orders:
    """A symbol about the midpoint of σ: `orders[j]`, a polynomial in P, is the coefficient of (σ − middle)^j."""

    def __init__(self, symbol: Symbol, sigma: Any) -> None:
        middle = sigma.mid()
        exact = _is_exact(sigma)
        about = acb_poly([middle]) if exact else acb_poly([middle, 1])
        rows = [acb_poly([_K.number(c) for c in row])(about) for row in symbol.rows]
        width = max(max(row.length() for row in rows), 1)
        self.orders = [acb_poly([row[j] for row in rows]) for j in range(width)]
        self.step = acb(0) if exact else sigma - middle
        self.size = len(symbol.rows)

    def __call__(self, z: Any) -> Any:
        """The value over the ball of σ, at an exact z."""
        return horner([a(z) for a in self.orders], self.step)

    def about(self, z: Any) -> list[Any]:
        """The coefficients of (P − z)^i over the ball of σ: balls only where σ and P depart from their middles."""
        moved = acb_poly([z, 1])
        shifted = [a(moved) for a in self.orders]
        return [horner([a[i] for a in shifted], self.step) for i in range(self.size)]


class _Local(_Orders):
    """D about the midpoint of σ, with its coefficients over the ball and at the midpoint."""

    def __init__(self, symbol: Symbol, sigma: Any) -> None:
        super().__init__(symbol, sigma)
        self.wide = acb_poly([row(self.step) for row in self._rows()])
        self.degree = self.size - 1
        self.middle = acb_poly([self.orders[0][i].mid() for i in range(self.size)])
        self.lead = self.wide[self.degree]
        if self.lead.contains(0) or not self.lead.is_finite():
            raise PrecisionError("the leading coefficient of the dispersion may be 0: split the piece")

    def _rows(self) -> list[Any]:
        return [acb_poly([a[i] for a in self.orders]) for i in range(self.size)]


def _is_exact(z: Any) -> bool:
    return bool(z.real.is_exact() and z.imag.is_exact())


def _approximations(middle: Any, upper: int) -> list[Any]:
    """The roots of the midpoint polynomial, upper ones first, each sharpened as far as it is simple."""
    n = middle.degree()
    coefficients = np.array([complex(middle[i]) for i in range(n + 1)])
    if not np.isfinite(coefficients).all():
        raise PrecisionError("the dispersion polynomial is out of float64's range here")
    found = np.roots(coefficients[::-1])
    if len(found) != n:
        raise PrecisionError("the leading coefficient of the dispersion is 0 in float64: split the piece")
    z = [exact_ball(complex(x)) for x in sorted(found, key=lambda x: x.real)]
    if not _apart(z, upper):
        return z
    slope = middle.derivative()
    target = bits_now()
    ladder = [target]
    while ladder[0] > _SEED_BITS:
        ladder.insert(0, ladder[0] // 2 + 4 if ladder[0] > 16 + _SEED_BITS else _SEED_BITS)
    for bits in (*ladder[1:], target):
        with precision(min(bits + 8, target)):
            z = [(x - middle(x) / slope(x)).mid() for x in z]
    if not all(x.is_finite() for x in z):
        raise PrecisionError("Newton's method for the p-roots left the plane: split the piece")
    return z


def _apart(z: Sequence[Any], upper: int) -> bool:
    """Whether the roots of each side keep their distance; a matter of method, nothing is proved by it."""
    points = np.array([complex(x) for x in z])
    size = np.abs(points).max(initial=0.0)
    gaps = np.abs(points[:, None] - points[None, :]) + size * np.eye(len(points))
    return bool(size > 0 and (gaps > _NEAR * size).all()) or (len(points) == 1 and upper <= 1)


def _discs(local: _Local, z: Sequence[Any]) -> list[Any]:
    """For each approximation a ball with one root of D for every σ; `PrecisionError` where two may touch."""
    n = len(z)
    values = [local(x) for x in z]
    radii = []
    for k, x in enumerate(z):
        spread = abs(local.lead)
        for i, other in enumerate(z):
            if i != k:
                spread = spread * abs(x - other)
        radii.append(arb((n * abs(values[k]) / spread).upper()) if spread > 0 else arb("inf"))
    for k, x in enumerate(z):
        if not all(abs(x - z[i]) > radii[k] + radii[i] for i in range(k)):
            raise PrecisionError("two p-roots cannot be told apart over the ball: split the piece")
    if not local.step.is_zero():
        return [_newton(local, x, value, radius) for x, value, radius in zip(z, values, radii, strict=True)]
    return [x + square(radius) for x, radius in zip(z, radii, strict=True)]


def _newton(local: _Local, x: Any, value: Any, radius: Any) -> Any:
    """The image of the disc under interval Newton where it is smaller: it holds the one root of the disc."""
    disc = x + square(radius)
    about = slope_in_P(local.about(x))
    for _ in range(2):
        image = x - value / horner(about, disc - x)
        if not image.is_finite() or image.rad() > disc.rad():
            break
        disc = image
    return disc


def _signed(discs: Sequence[Any], upper: int) -> bool:
    """Every upper root has Re P < 0 and every lower one Re P > 0, proved."""
    return all(x.real < 0 for x in discs[:upper]) and all(x.real > 0 for x in discs[upper:])


def _by_coefficients(symbols: Symbols, sigma: Any, local: _Local, z: Sequence[Any], upper: int) -> ProvedSplitting:
    """Krawczyk's test for U·L = D/lead, unknown the coefficients."""
    D = [local.middle[i] for i in range(local.degree + 1)]
    U, L = list(monic(z[:upper])), list(monic(z[upper:]))
    for _ in range(max(4, bits_now().bit_length())):
        moved = sharpened(_K, D, U, L)
        U, L = ([c.mid() for c in part] for part in moved)
        if not all(c.is_finite() for c in (*U, *L)):
            raise PrecisionError("an upper and a lower p-root are too close: split the piece")
    step, Y = _krawczyk_step(local, U, L)
    n = local.degree
    one = acb_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    tiny = arb(2) ** (8 - bits_now())
    spread = [2 * abs(step[i, 0]) + tiny for i in range(n)]
    for _ in range(6):
        X = [square(r) for r in spread]
        half = [c + x / 2 for c, x in zip((*U, *L), X, strict=True)]
        J = acb_mat(sylvester(half[: len(U)], half[len(U) :]))
        image = step + (one - Y * J) * acb_mat([[x] for x in X])
        if all(x.contains_interior(image[i, 0]) for i, x in enumerate(X)):
            whole = [c + image[i, 0] for i, c in enumerate((*U, *L))]
            factors = (tuple(whole[:upper]), tuple(whole[upper:]))
            return ProvedSplitting(symbols, sigma, upper, None, factors, _sides(factors, z, upper))
        spread = [2 * r for r in spread]
    raise PrecisionError("the factors U and L cannot be proved over the ball: split the piece")


def _krawczyk_step(local: _Local, U: list[Any], L: list[Any]) -> tuple[Any, Any]:
    """The first step from (U, L), over the ball, and the approximate inverse that it was made with."""
    found = product([*U, 1], [*L, 1])
    try:
        Y = acb_mat(sylvester(U, L)).inv()
    except ZeroDivisionError:
        raise PrecisionError("an upper and a lower p-root are too close: split the piece") from None
    n = local.degree
    Y = acb_mat(n, n, [e.mid() for e in Y.entries()])
    total = acb_mat(n, 1, [acb(0)] * n)
    scale = acb(1) / local.lead
    rest = acb_mat([[local.wide[i] * scale - found[i]] for i in range(n)])
    return total + Y * rest, Y


def _sides(factors: Sequence[Sequence[Any]], z: Sequence[Any], upper: int) -> bool:
    """Whether all roots of U have Re P < 0 and all of L Re P > 0, by Gershgorin's discs about moved nodes."""
    size = max(float(abs(x).upper()) for x in z)
    for part, nodes, sign in ((factors[0], z[:upper], -1), (factors[1], z[upper:], 1)):
        nodes = _spread_out(nodes, 2.0**-8 * size)
        polynomial = acb_poly([*part, 1])
        for k, x in enumerate(nodes):
            gap = arb(1)
            for i, other in enumerate(nodes):
                gap = gap if i == k else gap * abs(x - other)
            radius = len(nodes) * abs(polynomial(x)) / gap
            if not sign * x.real > radius:
                return False
    return True


def _spread_out(nodes: Sequence[Any], gap: float) -> list[Any]:
    """Nodes that keep a distance, moved a little along the imaginary axis where they do not."""
    points = sorted((complex(x) for x in nodes), key=lambda x: (x.imag, x.real))
    for _ in range(len(points)):
        for a, b in pairwise(range(len(points))):
            if abs(points[b] - points[a]) < gap:
                points[b] += 1j * gap
    return [exact_ball(x) for x in points]


class Proved:
    """Δ̂ of a problem in balls, at the precision that is set; its premise is that of `split_ball`.

    signed: refuse a ball of σ at which it is not proved which p-roots are upper (Re P < 0) and which lower. That
    is so wherever a wave's Re P can be 0, on the cuts; with signed=False the caller must know the sheet.
    """

    def __init__(self, reduced: Reduced, signed: bool = True) -> None:
        self.reduced = reduced
        self.symbols = Symbols.of(reduced.guide)
        self.border = Bordering.of(reduced)
        self.signed = signed

    @cached_property
    def upper(self) -> int:
        """n₊, proved."""
        return upper_count(self.symbols.D)

    def splitting(self, sigma: Any) -> ProvedSplitting:
        """The splitting over the ball σ."""
        split = split_ball(self.symbols, sigma, self.upper)
        if self.signed and not split.signed:
            raise PrecisionError("a p-root may be real, so which side it belongs to is open: split the piece")
        return split

    def matrices(self, sigma: Any, slope: bool = True) -> tuple[Any, Any]:
        """A(σ) and A'(σ) as acb_mat; over a wide ball A by the mean value, from its middle and its slope."""
        sigma = acb(sigma)
        exact = _is_exact(sigma)
        G, G_sigma = self.splitting(sigma).receptances(self.border.distances, slope or not exact)
        if not exact:
            middle = sigma.mid()
            inner = self.splitting(middle).receptances(self.border.distances, False)[0]
            G = [g + g_s * (sigma - middle) for g, g_s in zip(inner, G_sigma, strict=True)]
        A = acb_mat(self.border.rows(_K, sigma, G))
        return A, (acb_mat(self.border.slopes(_K, sigma, G_sigma)) if slope else None)

    def delta(self, sigma: Any) -> tuple[Any, Any]:
        """Δ̂ and dΔ̂/dσ over the ball σ."""
        A, A_sigma = self.matrices(sigma)
        reduction = Reduction.of(A)
        return reduction.determinant(A, A_sigma)
