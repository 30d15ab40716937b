"""Checks certificates of answers over ranges of parameters against certs/SPEC2.md, section 10; shares no code with
their maker.

Needs Python ≥ 3.11 and python-flint, and verify2.py beside it, which checks the spectrum at one point of the range.
Runs as a plain script:  python verify_ranges.py FILE [FILE …]
Exit status 0: every file is valid; 1: one is not, and its line says why.

A certificate carries the equations with free parameters as polynomials, their ranges, the spectrum at one point, the
tree of boxes of (q, parameters) with what excludes real roots from each leaf, boxes round crossings, and numbers of
a theorem at large q. A leaf is checked by Taylor forms of second order in balls, about its middle; one that is too
wide for them is halved, so and so often. Throughout P = ip, σ = iq, s = σ − vP.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations, pairwise, product
from math import asinh, comb, sinh
from typing import Any

import flint
from flint import acb, acb_mat, acb_poly, arb, arb_mat, arb_poly, fmpq

if __package__:
    from mpsolve.certificate import verify2 as spectra
else:
    import verify2 as spectra  # type: ignore[import-not-found,no-redef]

Refused, Verdict = spectra.Refused, spectra.Verdict
require, keys, items, integer, rational, dyadic, listed = (
    spectra.require, spectra.keys, spectra.items, spectra.integer, spectra.rational, spectra.dyadic, spectra.listed,
)  # fmt: skip

KEYS = "equations basis range base tail X beyond tree zeros claim"
MAX_BYTES, MAX_PARAMETERS, MAX_NODES, MAX_ZEROS = 32_000_000, 6, 4_000_000, 100
MAX_BODIES, MAX_CONTACTS, MAX_CELLS = 24, 12, 400
DEPTH, EXTRA, PIECES = 24, 8, 4_000  # halvings of a leaf; boxes looked at: EXTRA a leaf, and PIECES
LEAF = 400
BITS = 64
TOGETHER, WIDER, NARROWER = (
    0.3,
    16,
    fmpq(1, 1 << 20),
)  # p-roots closer than this share of other distances share a circle
SIDE, REACH = 20, 12.0  # cells of wavenumber on each side of a wave, and how far they go

Exponents = tuple[int, ...]
Free = dict[Exponents, Any]  # {exponents of the parameters: c}
Box = tuple[tuple[Any, Any], ...]  # exact ends of q and of the parameters, or of the parameters alone


def verify(path: Any) -> spectra.Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    return spectra.of_file(path, verify_bytes, MAX_BYTES)


def verify_bytes(raw: bytes, most: int | None = None) -> spectra.Verdict:
    """The verdict on a certificate's bytes. Never raises for what they hold. most: boxes that it
    may look at, and then LEAF of them for one leaf; by default it is bounded by the length of the file."""
    claim = lambda: checked(spectra.opened(raw, {"crossings": KEYS, "stable": KEYS}), most)  # noqa: E731
    return spectra.judged(raw, claim, MAX_BYTES)


# --- the equations ----------------------------------------------------------------------------------------


def by_power(f: Free) -> list[Free]:
    """For each power of P, or p, what stands with it."""
    out: list[Free] = [{} for _ in range(max(e[0] for e in f) + 1)]
    for (i, *e), c in f.items():
        out[i][tuple(e)] = c
    return out


def check_track(track: spectra.Track, box: Box) -> None:
    """For all parameters: passive at rest, no p-root real for Re σ ≥ 0, and none lost (section 10.2)."""
    require(track.velocity, "the velocity is 0 throughout: at rest nothing grows")
    lead = {e: c for e, c in track.d.items() if e[0] == track.degree}
    require(all(e[1] == 0 for e in lead), "the highest coefficient of D depends on the frequency")
    top = {e[2:]: c for e, c in lead.items()}
    if spectra.at(top, [(a + b) / 2 for a, b in box]) < 0:
        top = {e: -c for e, c in top.items()}
    spectra.everywhere(spectra.always_positive, [top], box, "a wave speed may lie in the range")
    for rows in spectra.hurwitz(track.ring, track.D, box):
        why = "the track is not proved stable and damped for all these parameters"
        spectra.everywhere(spectra.always_positive, rows, box, why)
    spectra.check_passive(track.ring, track.rows, box)
    check_inertia(track, box)


def check_inertia(track: spectra.Track, box: Box) -> None:
    """N/D ~ a/s² for s → ∞ at every wavenumber, with one a > 0 (section 10.3)."""
    tops = []
    for p in (track.D, track.N):
        top = max(int(e[1]) for e in p.to_dict())
        terms_ = {tuple(map(int, e)): c for e, c in p.to_dict().items() if e[1] == top}
        require(all(e[0] == 0 for e in terms_), "the inertia of the track depends on the wavenumber")
        tops.append((top, {e[2:]: c for e, c in terms_.items()}))
    (d, big), (n, small) = tops
    require(d == n + 2, "the track's receptance does not fall as a mass's at high frequency")
    both = spectra.times(big, small)
    spectra.everywhere(spectra.always_positive, [both], box, "the inertia of the track may vanish")


def apart(vehicle: spectra.Bodies, box: Box) -> list[Free]:
    """The different places, in order: they stay apart for all parameters."""
    kept = [place for k, place in enumerate(vehicle.places) if place not in vehicle.places[:k]]
    middle = [(a + b) / 2 for a, b in box]
    kept.sort(key=lambda f: spectra.at(f, middle))
    for one, other in pairwise(kept):
        spectra.everywhere(spectra.always_positive, [spectra.minus(other, one)], box, "two places may meet")
    return kept


# --- Taylor forms of second order -------------------------------------------------------------------------


@lru_cache(maxsize=16)
def pairs(m: int) -> tuple[tuple[int, int, int], ...]:
    """(number of the coefficient, i, j) for i ≤ j, variables counted from 1."""
    both = [(i, j) for i in range(1, m + 1) for j in range(i, m + 1)]
    return tuple((1 + m + n, i, j) for n, (i, j) in enumerate(both))


def product_of(a: Sequence[Any], b: Sequence[Any], m: int) -> list[Any]:
    """The coefficients of a product, up to the second order."""
    a0, b0 = a[0], b[0]
    k = [a0 * b0]
    k += [a0 * b[i] + a[i] * b0 for i in range(1, m + 1)]
    for n, i, j in pairs(m):
        term = a0 * b[n] + a[n] * b0 + a[i] * b[j]
        k.append(term + a[j] * b[i] if i != j else term)
    return k


def inverse_of(a: Sequence[Any], m: int) -> list[Any]:
    c = 1 / a[0]
    w = [x * c for x in a]
    k = [c, *(-x * c for x in w[1 : m + 1])]
    for n, i, j in pairs(m):
        k.append((w[i] * w[j] * (1 if i == j else 2) - w[n]) * c)
    return k


def exponential_of(a: Sequence[Any], m: int) -> list[Any]:
    value = a[0].exp()
    k = [value, *(x * value for x in a[1 : m + 1])]
    for n, i, j in pairs(m):
        k.append((a[n] + (a[i] * a[i] / 2 if i == j else a[i] * a[j])) * value)
    return k


class Form:
    """f(u) = k_0 + Σ k_i u_i + Σ_{i≤j} k_ij u_i u_j + rest, |rest| ≤ e, for all complex |u_i| ≤ 1.

    The k are numbers in balls; k_0 … are those of f up to what the rest holds.
    """

    __slots__ = ("_sizes", "e", "k", "m")

    def __init__(self, k: list[Any], e: Any, m: int) -> None:
        self.k, self.e, self.m = k, e, m
        self._sizes: tuple[Any, Any, Any] | None = None

    @property
    def sizes(self) -> tuple[Any, Any, Any]:
        """Moduli: of the first, the linear, the quadratic part."""
        if self._sizes is None:
            size = [abs(x) for x in self.k]
            self._sizes = (size[0], sum(size[1 : 1 + self.m], ZERO), sum(size[1 + self.m :], ZERO))
        return self._sizes

    @property
    def spread(self) -> Any:
        _, first, second = self.sizes
        return first + second + self.e

    @property
    def size(self) -> Any:
        return self.sizes[0] + self.spread

    def __add__(self, other: Form) -> Form:
        return Form([a + b for a, b in zip(self.k, other.k, strict=True)], self.e + other.e, self.m)

    def __neg__(self) -> Form:
        return Form([-a for a in self.k], self.e, self.m)

    def scaled(self, c: Any) -> Form:
        return Form([a * c for a in self.k], self.e * abs(c), self.m)

    def plus(self, c: Any) -> Form:
        return Form([self.k[0] + c, *self.k[1:]], self.e, self.m)

    def __mul__(self, other: Form) -> Form:
        x0, x1, x2 = self.sizes
        y0, y1, y2 = other.sizes
        e = x1 * y2 + x2 * (y1 + y2) + (x0 + x1 + x2) * other.e + self.e * (y0 + y1 + y2 + other.e)
        return Form(product_of(self.k, other.k, self.m), e, self.m)

    def inverse(self) -> Form:
        """1/f = (1 − w + w² − w³/(1 + w))/k_0 with f = k_0 (1 + w)."""
        require(not self.k[0].contains(0), "a quantity may be infinite over a box")
        size = 1 / abs(self.k[0])
        p, q, eps = self.sizes[1] * size, self.sizes[2] * size, self.e * size
        y = p + q + eps
        require(y < 0.95, "a quantity may be infinite over a box")
        rest = size * (eps + (q + eps) * (2 * p + q + eps) + y**3 / (1 - y))
        return Form(inverse_of(self.k, self.m), rest, self.m)

    def exp(self) -> Form:
        """e^f: |e^w − 1 − w − w²/2| ≤ e^y y³/6 for |w| ≤ y; where y is large |e^f| ≤ e^{Re k_0 + y} says more."""
        _, p, q = self.sizes
        y = p + q + self.e
        if not y < 2:
            return Form(number(0, self.m).k, (self.k[0].real + y).exp(), self.m)
        rest = self.e + (q + self.e) * (2 * p + q + self.e) / 2 + y.exp() * y**3 / 6
        k = exponential_of(self.k, self.m)
        return Form(k, abs(self.k[0].exp()) * rest, self.m)

    def rested(self, more: Any) -> Form:
        """The same with more in the rest."""
        return Form(self.k, self.e + more, self.m)


ZERO, NONE = arb(0), acb(0)


def number(c: Any, m: int) -> Form:
    return Form([acb(c)] + [NONE] * (m + len(pairs(m))), ZERO, m)


def total(forms: Sequence[Form], m: int) -> Form:
    out = forms[0] if forms else number(0, m)
    for f in forms[1:]:
        out = out + f
    return out


class Place:
    """A box of (q, θ): the variables (σ, θ) as forms, and their monomials. first: of σ by q."""

    def __init__(self, middle: Sequence[Any], half: Sequence[Any], first: complex = 1j) -> None:
        self.m, self.middle, self.half, self.first = len(middle), middle, half, first
        self._known: dict[Exponents, Form] = {}
        self._powers: list[list[Form]] = []
        for i, (x, r) in enumerate(zip(middle, half, strict=True)):
            k = [NONE] * (1 + self.m + len(pairs(self.m)))
            unit = acb(first) if i == 0 else acb(1)
            k[0], k[1 + i] = unit * x, unit * r
            self._powers.append([number(1, self.m), Form(k, ZERO, self.m)])

    @classmethod
    def of(cls, box: Box, first: complex = 1j) -> Place:
        return cls([arb((a + b) / 2) for a, b in box], [arb((b - a) / 2) for a, b in box], first)

    def resized(self, factor: Any) -> Place:
        return Place(self.middle, [r * factor for r in self.half], self.first)

    def power(self, i: int, e: int) -> Form:
        if e < 0:
            return self.power(i, -e).inverse()
        row = self._powers[i]
        while len(row) <= e:
            row.append(row[-1] * row[1])
        return row[e]

    def monomial(self, e: Exponents) -> Form:
        """Of exponents of (σ, θ)."""
        found = self._known.get(e)
        if found is None:
            used = [(i, k) for i, k in enumerate(e) if k]
            found = self.power(*used[0]) if used else self._powers[0][0]
            for i, k in used[1:]:
                found = found * self.power(i, k)
            self._known[e] = found
        return found

    def value(self, f: Sequence[tuple[Exponents, Any]]) -> Form:
        """Σ c·monomial, coefficients in balls."""
        return total([self.monomial(e).scaled(c) for e, c in f], self.m)


def balls(f: Free) -> list[tuple[Exponents, Any]]:
    return [(e, arb(c)) for e, c in f.items()]


# --- the splitting over a box, p-roots and G --------------------------------------------------------------


class Wide(spectra.Refused):
    """A box is too wide for the forms; `weights` tell along which variable to halve it."""

    def __init__(self, why: str, weights: Sequence[float] = ()) -> None:
        super().__init__(why)
        self.weights = list(weights)


class Waves:
    """D and N in balls at the present precision, and the distances that G is needed for."""

    def __init__(self, track: spectra.Track, vehicle: spectra.Bodies) -> None:
        self.degree, ring = track.degree, track.ring
        self.D, self.N = ([balls(f) for f in by_power(part)] for part in (track.d, track.n))
        P, s, *x = ring.gens()
        W = spectra.absorption(ring, track.D, track.N)[0]  # at Ω = q − vp
        W = W.compose(P, s - spectra.speed(ring, track.velocity) * P, *x, ctx=ring)
        turn = [acb(1), acb(0, -1), acb(-1), acb(0, 1)]  # q = −iσ
        self.W = [[(e, turn[e[0] % 4] * c) for e, c in balls(f)] for f in by_power(spectra.terms(W))]
        places = [{(0, *e): c for e, c in place.items()} for place in vehicle.places]
        self.distances: list[tuple[bool, list[tuple[Exponents, Any]]]] = []
        kept: list[Free] = []
        self.index = []
        for a in places:
            row = []
            for b in places:
                gap = spectra.minus(a, b)
                if gap not in kept:
                    kept.append(gap)
                row.append(kept.index(gap))
            self.index.append(row)
        self._kept = kept

    def ordered(self, x: Sequence[Any]) -> list[tuple[bool, list[tuple[Exponents, Any]]]]:
        """(whether it is ≥ 0, in balls) of each distance; x: any parameters of the range."""
        if not self.distances:
            for gap in self._kept:
                value = spectra.at(gap, [fmpq(0), *x])
                self.distances.append((value >= 0, balls(gap)))
        return self.distances


class Split:
    """D = lead·U·L over a box: nodes z, the first `up` of U, |a_k| ≤ tight_k, and D about each node."""

    def __init__(self, waves: Waves, place: Place, throughout: bool) -> None:
        self.place, self.m = place, place.m
        self.D = [place.value(f) for f in waves.D]
        n = self.n = waves.degree
        thin = [f.k[0].mid() for f in self.D]
        try:
            z = [x.mid() for x in acb_poly(thin).roots()]
        except ValueError:
            raise Wide("p-roots meet in the middle of a box") from None
        for _ in range(max(flint.ctx.prec.bit_length() - 4, 0)):  # FLINT isolates; Newton sharpens
            D = acb_poly(thin)
            slope = D.derivative()
            z = [(x - D(x) / slope(x)).mid() for x in z]
        z.sort(key=lambda x: float(x.real))
        self.z, self.up = z, sum(bool(x.real < 0) for x in z)
        self.sides = [range(self.up), range(self.up, n)]
        self.gap = [[abs(z[i] - z[k]) if i != k else arb(1) for k in range(n)] for i in range(n)]
        apart = [1 / self.gap[k][i] if (i < self.up) != (k < self.up) else ZERO for k in range(n) for i in range(n)]
        self.inverse = arb_mat(n, n, apart)
        self.values = [self.about(z_, 0) for z_ in z]
        self.box, self.tight = self.contraction(throughout)

    def about(self, z: Any, i: int) -> Form:
        """E_i in D(z + h) = Σ E_i h^i."""
        power, out = acb(1), []
        for j in range(i, self.n + 1):
            out.append(self.D[j].scaled(power * comb(j, i)))
            power = power * z
        return total(out, self.m)

    def contraction(self, throughout: bool) -> tuple[list[Any], list[Any]]:
        """The pair of Lemma 1 over the box, proved to be (roots with Re P < 0, the others) at its middle.

        throughout: at every point of the box, inside the range or not.
        """
        n = self.n
        lead = self.D[n]
        low = abs(lead.k[0]) - lead.spread
        require(low > 0, "the highest coefficient of D may vanish")
        self.scale = []
        for k in range(n):
            size = low
            for x in self.gap[k]:
                size = size * x
            self.scale.append(size)
        wide = self.solved([f.size / size for f, size in zip(self.values, self.scale, strict=True)])
        if wide is None:
            raise Wide("the p-roots of both sides are not kept apart over a box", self.strain())
        if not self.apart(wide[1]):
            thin = self.solved([abs(f.k[0]) / size for f, size in zip(self.values, self.scale, strict=True)])
            fine = thin is not None and self.apart(thin[1]) and all(
                x < y for x, y in zip(thin[1], wide[0], strict=True)
            )  # fmt: skip
            if throughout or not fine:
                raise Wide("a p-root may be real in a box", self.strain())
        return wide

    def solved(self, w: list[Any]) -> tuple[list[Any], list[Any]] | None:
        """(β, τ) of Lemma 1 for |W_k| ≤ w_k."""
        return spectra.contraction(w, self.inverse, spectra.tiny(self.z))

    def apart(self, tau: list[Any]) -> bool:
        """Each root of U lies within (their number)·τ_k of some node: all have Re P < 0, those of L Re P > 0."""
        for side, sign in zip(self.sides, (-1, 1), strict=True):
            if not all(sign * self.z[k].real > len(side) * tau[k] for k in side):
                return False
        return True

    def strain(self) -> list[float]:
        """How far each variable moves p-roots, relative to the distance of the next one of the other side."""
        out = [0.0] * self.m
        for side, other in ((0, 1), (1, 0)):
            for k in self.sides[side]:
                near = min((float(self.gap[k][j]) for j in self.sides[other]), default=1.0)
                for i in range(self.m):
                    moved = float(abs(self.values[k].k[1 + i]))
                    out[i] = max(out[i], moved / (float(self.scale[k]) * near))
        return out

    def isolated(self, side: range) -> list[Any]:
        """Radii of disjoint discs round the nodes of one side, each with exactly one root of its factor."""
        try:
            return spectra.isolated(self.tight, self.gap, side)
        except Refused as error:
            raise Wide(str(error), self.strain()) from None

    def sharp(self, k: int, e: Any, N: list[Form]) -> tuple[Form, Form]:
        """The root in the disc of radius e round node k, and N/D_P there, as forms: with D(z + h) = Σ E_i h^i,
        h = −(E_0 + (E_1 − E_1(0))h + E_2h² + …)/E_1(0), put into itself twice."""
        E = [self.about(self.z[k], i) for i in range(self.n + 1)]
        require(not E[1].k[0].contains(0), "two p-roots of one side meet over a box")
        c = -1 / E[1].k[0]
        turn = Form([NONE, *E[1].k[1:]], E[1].e, self.m)
        h = number(0, self.m).rested(e)
        for _ in range(3):
            e = h.size
            more = sum((f.size * e**i for i, f in enumerate(E[3:], 3)), ZERO)
            above = E[0] + turn * h + (E[2] * (h * h) if self.n > 1 else number(0, self.m))
            h = above.rested(more).scaled(c)
        e = h.size
        slope = E[1]
        if self.n > 1:
            slope = slope + (E[2] * h).scaled(2)
        if self.n > 2:
            slope = slope + (E[3] * (h * h)).scaled(3)
        slope = slope.rested(sum((i * E[i].size * e ** (i - 1) for i in range(4, self.n + 1)), ZERO))
        point, value = h.plus(self.z[k]), N[-1]
        for f in reversed(N[:-1]):
            value = value * point + f
        try:
            return point, value * slope.inverse()
        except Refused as error:
            raise Wide(str(error), self.strain()) from None

    def circles(self, side: int) -> list[tuple[Any, Any, list[int]]]:
        """(middle, radius, nodes inside) of circles; roots that are close share one. Nothing rests on them."""
        own, z = list(self.sides[side]), [complex(x) for x in self.z]
        others = [k for k in range(self.n) if k not in own]
        far = {k: min((abs(z[k] - z[j]) for j in others), default=1e300) for k in own}
        groups: list[list[int]] = []
        for k in own:
            near = [g for g in groups if any(abs(z[k] - z[j]) <= TOGETHER * min(far[k], far[j]) for j in g)]
            groups = [g for g in groups if g not in near] + [[k, *(j for g in near for j in g)]]
        out = []
        for g in groups:
            middle = sum(z[k] for k in g) / len(g)
            size = max(abs(z[k] - middle) for k in g)
            outer = min([abs(z[k] - middle) for k in range(self.n) if k not in g] + [4 * (abs(middle) + size)])
            size += len(g) * max(float(self.tight[k]) for k in g)
            out.append((acb(middle), arb(max(0.4 * outer, (size * outer) ** 0.5)), g))
        return out

    def bounds(self, side: int, N: list[Form], distances: Sequence[Form]) -> list[Any]:
        """Bounds of |Σ N e^{Pξ}/D_P| over the p-roots of one side, at each distance: by one circle round each group.

        On a circle |D| ≥ |lead| Π|P − z_k| · Π(1 − Σ a_k/|P − z_k|) > 0, and as many zeros of D in it as nodes.
        """
        out = [ZERO] * len(distances)
        for middle, radius, inside in self.circles(side):
            gaps = [abs(middle - z) - radius for z in self.z]
            fine = all(gap < 0 if k in inside else gap > 0 for k, gap in enumerate(gaps))
            low, far = abs(self.D[-1].k[0]) - self.D[-1].spread, abs(middle) + radius
            for gap in gaps:
                low = low * abs(gap)
            for here in self.sides:
                share = 1 - sum((self.tight[k] / abs(gaps[k]) for k in here), ZERO)
                fine, low = fine and bool(share > 0), low * share
            if not (fine and low > 0):
                raise Wide("p-roots come too near to others over a box", self.strain())
            most = sum((f.size * far**i for i, f in enumerate(N)), ZERO) / low * radius
            for n, f in enumerate(distances):
                out[n] += most * ((middle * f.k[0]).real + radius * abs(f.k[0]) + far * f.spread).exp()
        return out


def receptances(waves: Waves, split: Split, x: Sequence[Any]) -> list[Form]:
    """G at each distance over the box: from its p-roots, each alone, or where some of one side meet."""
    try:
        isolated = [split.isolated(side) for side in split.sides]
    except Wide:
        if any(y > 0.5 / WIDER for y in (split.inverse * arb_mat(split.n, 1, split.tight)).entries()):
            raise  # it would not split over the wider box
        out = beside_meeting(waves, split, x)
    else:
        out = from_roots(waves, split, isolated, x)
    finite = all(f.e.is_finite() and all(y.is_finite() for y in f.k) for f in out)
    require(finite, "G is not bounded over a box")
    return out


def from_roots(waves: Waves, split: Split, isolated: Sequence[list[Any]], x: Sequence[Any]) -> list[Form]:
    """G as ± Σ N e^{Pξ}/D_P of forms: their rests fall with the box to any precision."""
    place, m = split.place, split.m
    N, distances = [place.value(f) for f in waves.N], waves.ordered(x)
    out = [number(0, m)] * len(distances)
    for side, here in enumerate(split.sides):
        chosen = [n for n, (ahead, _) in enumerate(distances) if ahead == (side == 0)]
        roots = [split.sharp(k, e, N) for k, e in zip(here, isolated[side], strict=True)] if chosen else []
        for n in chosen:
            gap = place.value(distances[n][1])
            one = total([w * (P * gap).exp() if distances[n][1] else w for P, w in roots], m)
            out[n] = -one if side else one
    return out


def beside_meeting(waves: Waves, split: Split, x: Sequence[Any]) -> list[Form]:
    """G where p-roots of one side may meet: its Taylor polynomial from a much smaller box, the rest by a bound of |G|
    over a wider one. It is analytic there, with or without the range: |g_k| ≤ M/w^k for its terms of order k."""
    small = Split(waves, split.place.resized(NARROWER), False)
    isolated = [small.isolated(side) for side in small.sides]
    wide = Split(waves, split.place.resized(WIDER), False)
    N, distances = [wide.place.value(f) for f in waves.N], waves.ordered(x)
    gaps = [wide.place.value(f) for _, f in distances]
    most, m = [wide.bounds(side, N, gaps) for side in (0, 1)], split.m
    out = []
    for n, f in enumerate(from_roots(waves, small, isolated, x)):
        k = [y + spectra.box(f.e) for y in f.k]  # the coefficients themselves, by Cauchy
        order = [0] + [1] * m + [2] * len(pairs(m))
        rest = most[0 if distances[n][0] else 1][n] / (WIDER**2 * (WIDER - 1))
        out.append(Form([y / NARROWER**i for y, i in zip(k, order, strict=True)], rest, m))
    return out


# --- the characteristic matrix over a box -----------------------------------------------------------------


class Matrix:
    """A with det A = Δ̂ up to a constant (section 4.6): direct contacts and their bodies eliminated."""

    def __init__(self, vehicle: spectra.Bodies, waves: Waves) -> None:
        nb, nc = vehicle.B.nrows(), len(vehicle.h)
        self.vehicle, self.waves, self.nc = vehicle, waves, nc
        contacts = spectra.direct_contacts(vehicle).items()
        self.direct = [(body, j, arb(-1 / vehicle.B[body, j])) for j, body in contacts]
        gone = [i for i, _, _ in self.direct]
        self.kept = [i for i in range(nb) if i not in gone]
        self.indirect = [j for j in range(nc) if j not in [k for _, k, _ in self.direct]]
        self.S = [[self.entry(i, j) for j in range(nb)] for i in range(nb)]
        self.h = [[((0, *e), arb(c)) for e, c in f.items()] for f in vehicle.h]

    def entry(self, i: int, j: int) -> list[tuple[Exponents, Any]]:
        """S_ij in (σ, θ); the rows of neutral coordinates divided by σ."""
        v = self.vehicle
        less = 1 if i >= v.B.nrows() - v.neutral else 0
        out = []
        for power, part in enumerate(reversed(v.parts)):
            for e, a in part.items():
                if a[i, j] != 0:
                    out.append(((power - less, *e), arb(a[i, j])))
        return out

    def __call__(self, place: Place, G: list[Form]) -> list[list[Form]]:
        B, index, m = self.vehicle.B, self.waves.index, place.m
        S = [[place.value(f) if f else None for f in row] for row in self.S]
        rows = []
        for i in range(B.nrows()):
            row = [S[i][j] or number(0, m) for j in self.kept]
            for j in range(self.nc):
                f = number(-arb(B[i, j]), m)
                for body, contact, factor in self.direct:
                    s = S[i][body]
                    if s is not None:
                        f = f + (s * G[index[contact][j]]).scaled(factor)
                row.append(f)
            rows.append(row)
        for k in self.indirect:
            row = [number(arb(B[i, k]), m) for i in self.kept]
            for j in range(self.nc):
                f = G[index[k][j]]
                row.append(f + place.value(self.h[k]) if j == k and self.h[k] else f)
            rows.append(row)
        return rows


def cleared(A: Any) -> tuple[Any, Any]:
    """X, Y with XAY = diag(1, …, 1, s) to the present precision, s about the least singular value. Nothing rests on
    them."""
    (columns, rows), (tall, wide), n = spectra.frame(A, 1), spectra.units(A), A.nrows() - 1
    before = [0j] * (n + 1)
    for _ in range(8):  # towards singular vectors
        R = spectra.near_inverse(acb_mat(spectra.framed(A, columns, rows)))
        one = reflection([complex(R[n + 1, i]).conjugate() * t for i, t in enumerate(tall)])
        two = reflection([complex(R[j, n + 1]) * w for j, w in enumerate(wide)])
        columns = [[row[n] * t] for row, t in zip(one, tall, strict=True)]
        rows = [[row[n].conjugate() * w for row, w in zip(two, wide, strict=True)]]
        if abs(sum(x.conjugate() * row[n] for x, row in zip(before, two, strict=True))) > 0.98:
            break
        before = [row[n] for row in two]
    left = acb_mat([[x / t for x, t in zip(row, tall, strict=True)] for row in one])
    right = acb_mat([[x / w for x in row] for row, w in zip(two, wide, strict=True)])
    B = (left * A * right).mid().tolist()
    inverse = spectra.near_inverse(acb_mat([row[:n] for row in B[:n]]))
    low, side = -acb_mat([B[n][:n]]) * inverse, -inverse * acb_mat([row[n:] for row in B[:n]])
    L = [[*row, 0] for row in inverse.tolist()] + [[*low.tolist()[0], 1]]
    Y = [[*row, *more] for row, more in zip(spectra.identity(n).tolist(), side.tolist(), strict=True)]
    return (acb_mat(L) * left).mid(), (right * acb_mat([*Y, [0] * n + [1]])).mid()


def reflection(v: list[complex]) -> list[list[complex]]:
    """A Hermitian unitary matrix whose last column is along v."""
    size = sum(abs(x) ** 2 for x in v) ** 0.5 or 1.0
    u = [x / size for x in v]
    u[-1] += u[-1] / (abs(u[-1]) or 1.0) or 1.0
    whole = sum(abs(x) ** 2 for x in u) / 2
    return [[(i == j) - x * y.conjugate() / whole for j, y in enumerate(u)] for i, x in enumerate(u)]


def scalar(A: list[list[Form]]) -> Form:
    """s with det A = 0 exactly where s = 0: XAY = [[1 + E, e], [f, g]], s = g − f(1 + E)⁻¹e."""
    n, m = len(A), A[0][0].m
    if n == 1:
        return A[0][0]
    left, right = cleared(acb_mat([[f.k[0] for f in row] for row in A]))
    parts = [(left * acb_mat([[f.k[p] for f in row] for row in A]) * right).tolist() for p in range(len(A[0][0].k))]
    rest = (spectra.moduli(left) * arb_mat([[f.e for f in row] for row in A]) * spectra.moduli(right)).tolist()
    last = n - 1
    E = []
    for i in range(last):
        row = []
        for j in range(last):
            x = abs(parts[0][i][j] - (1 if i == j else 0)) + rest[i][j]
            row.append(sum((abs(part[i][j]) for part in parts[1:]), x))
        E.append(row)
    x, eta = spectra.near_weights(arb_mat(E), 0.05)
    if not eta < 0.9:
        moved = [float(max(sum((abs(y) for y in row), ZERO) for row in parts[1 + i])) for i in range(m)]
        raise Wide("the matrix changes too much over a box", moved)
    column = [Form([part[i][last] for part in parts], rest[i][last], m) for i in range(last)]
    row_ = [Form([part[last][i] for part in parts], rest[last][i], m) for i in range(last)]
    s = Form([part[last][last] for part in parts], rest[last][last], m)
    for f, e in zip(row_, column, strict=True):
        s = s + -(f * e)
    size_row = sum((f.size * y for f, y in zip(row_, x, strict=True)), ZERO)
    size_column = ZERO
    for f, y in zip(column, x, strict=True):
        size_column = size_column.max((f.size / y).upper())
    return s.rested(size_row * size_column * eta / (1 - eta))


def check_nonzero(s: Form) -> None:
    """Re(d s) > 0 for one direction d and all real u, or Wide."""
    m = s.m
    b = s.k[1 : 1 + m]
    directions = [s.k[0].conjugate()] + [x.conjugate() * acb(0, 1) for x in b]
    if m > 1:
        directions.append(sum(b, NONE).conjugate() * acb(0, 1))
    best, found = -1e300, [0.0] * m
    for d in directions:
        near = complex(d)
        size = abs(near)
        if not 1e-300 < size < 1e300:
            continue
        d = acb(near / size)
        k = [(x * d).real for x in s.k]
        if k[0] < 0:
            k = [-x for x in k]
        low = k[0] - s.e * abs(d)
        taken = [float(abs(x)) for x in k[1 : 1 + m]]
        for n, i, j in pairs(m):
            if i != j:
                low -= abs(k[n])
                taken[i - 1] += float(abs(k[n]))
                taken[j - 1] += float(abs(k[n]))
                continue
            linear, bend = abs(k[i]), k[n]  # −l²/4b ≤ −l|u| + b u² for b > 0; −(l − b) is the least if 2b < l
            if bend > 0:
                low -= linear - bend if 2 * bend < linear else linear * linear / (4 * bend)
            else:
                low -= linear + abs(bend)
            taken[i - 1] += float(abs(bend))
        if low > 0:
            return
        share = float(low) / (abs(complex(s.k[0])) or 1e-300)
        if share > best:
            best, found = share, taken
    rest = float(s.e)
    moved = [float(abs(x)) for x in b]
    whole = sum(moved) or 1.0
    raise Wide(
        "the determinant may vanish in a box", [t + rest * x / whole for t, x in zip(found, moved, strict=True)]
    )


# --- passive boxes: cells of wavenumber (section 6.5) -----------------------------------------------------


@dataclass(frozen=True)
class Envelope:
    """|Φ| ≤ C p^−alpha for p ≥ p0 > 0, −vp ≤ Ω ≤ 0, for each (p0, C) and all parameters; fastest: a bound of v."""

    alpha: int
    bounds: list[tuple[Any, Any]]
    fastest: Any

    def given(self, end: Any, low: Any, sites: int) -> Any:
        """What is given beyond p = end at frequencies ≥ low, at most, for Σ|u|² = 1; None where that is not known."""
        turn = low / self.fastest
        p = turn if turn > end else end
        known = [C for p0, C in self.bounds if p >= p0]
        if not known:
            return None
        C = known[0]
        for other in known[1:]:
            C = spectra.min_bound(C, other)
        return sites * C * p ** (1 - self.alpha) / (self.alpha - 1)


@dataclass
class Cell:
    """Φ ≥ a + turn·ε_p + Σ b_k ε_k on p = middle ± half; lost: what is taken off, and which slopes of D cause it."""

    middle: Any
    half: Any
    a: Any
    b: list[Any]
    turn: Any
    lost: tuple[Any, list[Any]]

    def costs(self) -> list[float]:
        """In floats: how much each variable takes off."""
        moved = [float(abs(x)) for x in self.lost[1]]
        whole, lost = sum(moved) or 1.0, float(self.lost[0])
        return [lost * x / whole * 2 * float(self.half) for x in moved[:-1]]


def mesh(roots: Sequence[complex], turn: float, spread: float) -> list[float]:
    """Ends of cells of wavenumber, ascending: fine near the waves. Nothing rests on them."""
    size = sorted(abs(p) for p in roots)
    near = [x for x in size if x <= 100 * size[len(size) // 2]] or size
    reach = REACH * max(near[-1], 1e-9 * size[-1])
    ends = {-reach, reach, min(turn, reach)}
    for p in roots:
        width = max(abs(p.imag), (abs(p.real) * spread + 1e-6 * reach) / 2)
        steepest = asinh(2 * reach / width)
        for k in range(-SIDE, SIDE + 1):
            x = p.real + width * sinh(steepest * k / SIDE)
            ends.add(min(max(x, -reach), reach))
    out = sorted(ends)
    kept = [out[0]]
    for x in out[1:]:
        if x - kept[-1] > 1e-9 * reach:
            kept.append(x)
    return kept


def cells(waves: Waves, place: Place, low: Any, speed: Any, ends: Sequence[float]) -> list[Cell]:
    """Lower bounds of Φ = W/|D|²; low: the least q; speed: the greatest v. Ends before a cell without a bound."""
    m = place.m
    parts = [by_wavenumber([place.value(x) for x in terms_], m) for terms_ in (waves.D, waves.W)]
    out = []
    for p0, p1 in pairwise(ends):
        a, b = arb(p0), arb(p1)
        middle, half, far = (a + b) / 2, (b - a) / 2, arb(max(abs(p0), abs(p1)))
        (D, D1, lost), (W, W1, lost_W) = (
            at_cell(part, unit, middle, half, far) for part, unit in zip(parts, (acb(0, 1), acb(1)), strict=True)
        )
        W, W1 = W.real, [x.real for x in W1]
        size, first = abs(D), sum((abs(x) for x in D1), ZERO)
        takes = p1 <= 0 or low > speed * b
        under, over = size - first - lost, size + first + lost
        least_W = W - sum((abs(x) for x in W1), ZERO) - lost_W
        cell = None
        if under > 0:  # |D|² = B + B1 + …, Φ = f + Σ f_k ε_k + rest, rest·|D|² as in section 10.4
            B, B1 = size * size, [2 * (D.conjugate() * x).real for x in D1]
            lost_B = first * first + (2 * (size + first) + lost) * lost
            f = W / B
            moved = [(x - f * y) / B for x, y in zip(W1, B1, strict=True)]
            slope = sum((abs(x) for x in moved), ZERO)
            spread_B = sum((abs(x) for x in B1), ZERO) + lost_B
            rest = (lost_W + abs(f) * lost_B + slope * spread_B) / (under * under)
            cell = Cell(middle, half, f - rest, moved[:-1], moved[-1], (rest, D1))
            lower = f - rest - slope
        plain = None
        if takes:
            plain = least_W / (over * over) if least_W > 0 else ZERO
        elif under > 0:
            plain = ZERO if least_W >= 0 else -((-least_W).upper()) / (under * under)
        if cell is None or (plain is not None and not lower > plain):
            if plain is None:
                break
            about = abs(W) / (over * over) - plain  # what it would be without the box's size, to within its order
            cell = Cell(middle, half, plain, [ZERO] * m, ZERO, (about, D1))
        out.append(cell)
    return out


def by_wavenumber(f: Sequence[Form], m: int) -> tuple[Any, ...]:
    """Σ f_i P^i in parts: polynomials of its coefficients, the slope in P, and polynomials that bound the rest."""
    k = [acb_poly([g.k[i] for g in f]) for i in range(1 + m)]
    sizes = [g.sizes for g in f]
    second = arb_poly([s[2] + g.e for s, g in zip(sizes, f, strict=True)])
    mixed = arb_poly([i * s[1] for i, s in enumerate(sizes)][1:])
    bent = arb_poly([i * (i - 1) * s[0] / 2 for i, s in enumerate(sizes)][2:])
    return k, k[0].derivative(), second, mixed, bent


def at_cell(part: tuple[Any, ...], unit: Any, middle: Any, half: Any, far: Any) -> tuple[Any, list[Any], Any]:
    """(value, slopes in u and in ε_p, a bound of the rest) at P = unit·(middle + half·ε_p)."""
    k, slope, second, mixed, bent = part
    P = unit * middle
    linear = [f(P) for f in k[1:]]
    linear.append(slope(P) * unit * half)
    return k[0](P), linear, second(far) + half * mixed(far) + half * half * bent(far)


def bend(x: Any) -> Any:
    """(sin x − x cos x)/x², odd; for small x by its series, whose terms alternate and fall."""
    if abs(x) < 1:
        square, term, total_ = x * x, x / 3, ZERO
        for k in range(1, 14):
            total_ += term
            term = -term * square / (2 * k * (2 * k + 3))
        return total_ + arb(0, abs(term).upper())
    sin, cos = x.sin_cos()
    return (sin - x * cos) / (x * x)


def check_passive_box(problem: Family, box: Box) -> None:
    """−Im G(q; θ) is positive definite for all q > 0 and θ of the box, or Wide: by p-roots, or by cells."""
    place = Place.of(box)
    try:
        by_roots(problem, place)
    except Refused:
        by_cells(problem, box, place)


def by_roots(problem: Family, place: Place) -> None:
    """From G over the box."""
    G = receptances(problem.waves, Split(problem.waves, place, False), problem.middle)
    sites, index = problem.vehicle.sites, problem.waves.index
    first = [sites.index(k) for k in range(len(set(sites)))]
    rows = [[G[index[i][j]] for j in first] for i in first]
    n, half = len(first), acb(0, 0.5)
    H = []
    for k in range(len(rows[0][0].k)):
        a = acb_mat([[f.k[k] for f in row] for row in rows])
        H.append((a - a.conjugate().transpose()) * half)
    E = [[(rows[i][j].e + rows[j][i].e) / 2 for j in range(n)] for i in range(n)]
    require_definite(H, E)


def require_definite(H: Sequence[Any], E: Sequence[Sequence[Any]]) -> None:
    if not spectra.definite(H, E):
        raise Wide("the receptance is not proved passive on a box")


def by_cells(problem: Family, box: Box, place: Place) -> None:
    """From cells of wavenumber (section 6.5)."""
    low, high = box[0]
    waves, m = problem.waves, len(box)
    speed = place.value(problem.speed)
    fastest = speed.k[0].real + speed.spread
    middle = [place.value(f).k[0].mid() for f in waves.D]
    try:
        roots = [complex(x) * -1j for x in acb_poly(middle).roots()]
    except ValueError:
        raise Wide("p-roots meet in the middle of a box") from None
    spread = max(float((b - a) / (abs(b + a) or 1)) for a, b in box)
    slow = float(speed.k[0].real)
    ends = mesh(roots, float(arb((low + high) / 2)) / slow if slow > 0 else 1e300, spread)
    q = arb(low)
    found = cells(waves, place, q, fastest, ends)
    sites = len(problem.sites)
    # the cells up to one end: the end is chosen in floats
    best, chosen = None, 0
    sums, off = 0.0, [0.0] * m
    givens: dict[int, Any] = {}
    for k, cell in enumerate(found):
        length = 2 * float(cell.half)
        sums += float(cell.a) * length
        off = [x + float(y) * length for x, y in zip(off, cell.b, strict=True)]
        if ends[k + 1] <= 0:
            continue
        if k + 1 < len(found) and float(cell.a) >= 0 and k % 4:
            continue
        given = problem.envelope.given(arb(ends[k + 1]), q, sites)
        if given is None:
            continue
        left = sums - sum(map(abs, off)) - float(given)
        if best is None or left > best:
            best, chosen = left, k + 1
            givens[k + 1] = given
    if best is None:
        raise Wide("what short waves give is not bounded over a box")
    try:
        definite(problem, place, found[:chosen], givens[chosen])
    except Wide as error:
        error.weights = [abs(x) for x in off]
        for cell in found[:chosen]:
            error.weights = [x + y for x, y in zip(error.weights, cell.costs(), strict=True)]
        weight = sum(abs(float(cell.a) * float(cell.middle)) * 2 * float(cell.half) for cell in found[:chosen])
        for one, other in pairwise(problem.sites):
            gap = place.value([((0, *e), arb(c)) for e, c in spectra.minus(other, one).items()])
            steps = [weight * float(abs(x)) for x in gap.k[1 : 1 + m]]
            error.weights = [x + y for x, y in zip(error.weights, steps, strict=True)]
        raise


def definite(problem: Family, place: Place, found: Sequence[Cell], given: Any) -> None:
    """∫|U|²Φ is positive definite, or Wide."""
    m, n = place.m, len(problem.sites)
    length = [2 * c.half for c in found]
    rows = [[c.a for c in found], *([c.b[v] for c in found] for v in range(m))]
    whole = [sum((x * y for x, y in zip(row, length, strict=True)), ZERO) for row in rows]
    H = [[[acb(x - given if v == 0 else x) if i == j else NONE for j in range(n)] for i in range(n)]
         for v, x in enumerate(whole)]  # fmt: skip
    E = [[ZERO] * n for _ in range(n)]
    known: dict[Any, tuple[list[Any], Any]] = {}
    for i, j in combinations(range(n), 2):
        gap = spectra.minus(problem.sites[j], problem.sites[i])
        key = frozenset((e, str(c)) for e, c in gap.items())
        if key not in known:
            known[key] = integrals(place.value([((0, *e), arb(c)) for e, c in gap.items()]), found, m)
        values, rest = known[key]
        for v, x in enumerate(values):
            H[v][j][i], H[v][i][j] = x, x.conjugate()
        E[i][j] = E[j][i] = rest
    require_definite([acb_mat(a) for a in H], E)


def integrals(distance: Form, found: Sequence[Cell], m: int) -> tuple[list[Any], Any]:
    """∫Φ e^{ipΔ}dp: its middle and slopes, and a bound of what a Δ that moves with the parameters changes."""
    D, moves, second = distance.k[0].real, distance.spread, distance.sizes[2] + distance.e
    steps = [x.real for x in distance.k[1 : 1 + m]]
    out, rest = [NONE] * (1 + m), ZERO
    for c in found:
        x, twice = c.half * D, 2 * c.half
        phase = acb(0, c.middle * D).exp() * twice
        cell = phase * x.sinc()
        out[0] += cell * c.a + phase * acb(0, bend(x) * c.turn)
        for v in range(m):
            out[1 + v] += cell * c.b[v]
        if not moves.is_zero():  # e^{ipδ} = 1 + ipδ + R, |R| ≤ (pδ)²/2
            far, a = abs(c.middle) + c.half, abs(c.a)
            slope = abs(c.turn) + sum((abs(y) for y in c.b), ZERO)
            for v in range(m):
                out[1 + v] += cell * acb(0, steps[v] * c.a * c.middle)
            rest += twice * moves * (a * c.half + slope * far)
            rest += twice * ((a + slope) * (far * moves) ** 2 / 2 + a * far * second)
    return out, rest


# --- large q (section 6.2 over all parameters) ------------------------------------------------------------


def read_tail(content: Any, track: spectra.Track, sites: Sequence[Free], box: Box) -> tuple[Envelope, Any]:
    """The envelope, and Q with −Im G > 0 for all q ≥ Q and all parameters: both checked."""
    keys(content, "Q gamma blocks alpha omega bounds")
    Q = dyadic(content["Q"], "Q")
    bounds = [
        (dyadic(p, "a bound"), dyadic(C, "a bound"))
        for p, C in (items(one, 2, "a bound", 2) for one in items(content["bounds"], 20, ""))
    ]
    fastest = -spectra.least({e: -c for e, c in track.velocity.items()}, box)
    require(fastest > 0, "the velocity is 0 throughout")
    gap = min((spectra.least(spectra.minus(b, a), box) for a, b in pairwise(sites)), default=None)  # may be < 0
    seen = gap is None or gap > 0
    require(seen, "the theorem at large q: no least distance of two contacts is seen over the range")
    parts = spectra.absorption(track.ring, track.D, track.N)
    alpha = spectra.tail_alpha(content, 4, parts, track.velocity, fastest, Q, gap, bounds, box)
    return Envelope(alpha, [(arb(p0), arb(C)) for p0, C in bounds], arb(fastest)), Q


# --- boxes of (q, parameters) -----------------------------------------------------------------------------


@dataclass
class Family:
    """The problem over its ranges, in balls at 64 bits, and how many boxes have been looked at."""

    track: spectra.Track
    vehicle: spectra.Bodies
    box: Box
    envelope: Envelope
    waves: Waves
    matrix: Matrix
    sites: list[Free]
    left: int = 0
    pieces: int = 0
    one: int = 1 << 30  # boxes that one leaf may take

    @cached_property
    def speed(self) -> list[tuple[Exponents, Any]]:
        return [((0, *e), arb(c)) for e, c in self.track.velocity.items()]

    @cached_property
    def middle(self) -> list[Any]:
        return [(a + b) / 2 for a, b in self.box]

    def scalar(self, place: Place, throughout: bool = False) -> Form:
        """s over a box: 0 exactly where Δ̂ is. throughout: also outside the ranges."""
        split = Split(self.waves, place, throughout)
        return scalar(self.matrix(place, receptances(self.waves, split, self.middle)))

    def nonzero(self, place: Place) -> None:
        """Δ̂ ≠ 0 over a box, or Wide."""
        check_nonzero(self.scalar(place))

    def prove(self, kind: str, box: Box) -> None:
        """No real root over the box ("n": Δ̂ ≠ 0; "p": passive), which is halved where the forms are too wide."""
        stack, most = [(box, 0)], min(self.left, self.pieces + self.one)
        while stack:
            here, depth = stack.pop()
            self.pieces += 1
            require(self.pieces < most, "the certificate asks for more work than this verifier does")
            try:
                if kind == "n":
                    self.nonzero(Place.of(here))
                else:
                    check_passive_box(self, here)
            except Refused as error:
                where = ", ".join(f"{float(arb(a)):.6g}…{float(arb(b)):.6g}" for a, b in here)
                require(depth < DEPTH, f"the box of q and parameters {where}: {error}")
                stack += [(half, depth + 1) for half in spectra.halved(here, self.axis(here, error))]

    def axis(self, box: Box, error: Any) -> int:
        """Along which variable to halve: where most is to be won, or the longest."""
        whole = [float(box[0][1]) or 1.0, *(float(b - a) or 1.0 for a, b in self.box)]
        share = [float(b - a) / w for (a, b), w in zip(box, whole, strict=True)]
        got = getattr(error, "weights", [])
        if len(got) == len(box) and all(x == x and x < 1e300 for x in got) and max(got) > 0:
            got = [x if y > 0 else -1.0 for x, y in zip(got, share, strict=True)]
            return got.index(max(got))
        return share.index(max(share))


def walk(tree: Any, box: Box) -> Iterator[tuple[str, Box]]:
    """The leaves of a tree in text: a digit halves along an axis, a letter is a leaf; low halves come first."""
    require(isinstance(tree, str) and 0 < len(tree) <= MAX_NODES, "the tree is no text, or too long")
    stack = [(box, 0)]
    for mark in tree:
        require(stack, "the tree goes on beyond its last leaf")
        here, depth = stack.pop()
        if mark in "npz":
            yield mark, here
            continue
        require(mark in "0123456"[: len(box)] and depth < 200, "a mark of the tree is not known")
        low, high = spectra.halved(here, int(mark))
        stack += [(high, depth + 1), (low, depth + 1)]
    require(not stack, "the tree ends before its last leaf")


# --- crossings --------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Zero:
    """The one real root over a room: its ends, balls (middle, radius) of q and of the parameter, its direction."""

    room: Box
    q: tuple[Any, Any]
    x: tuple[Any, Any]
    gained: int


def read_zero(value: Any, family: Family) -> Zero:
    """A crossing: checked that its room holds one real root at most, and its balls one, which crosses."""
    keys(value, "room q x")
    room = tuple(tuple(dyadic(x, "room") for x in items(one, 2, "room", 2)) for one in items(value["room"], 2, "", 2))
    for name in "qx":
        keys(value[name], "middle exponent radius")
    ((q,), q_r, one), ((x,), x_r, two) = (spectra.read_ball(value[name], "middle", name) for name in "qx")
    q, x, bits = (q, q_r), (x, x_r), max(one, two)
    require(all(a < b for a, b in room), "a room is empty")
    for (middle, radius), (a, b) in zip((q, x), room, strict=True):
        require(a < middle - radius and middle + radius < b, "a crossing is not inside its room")
    at_zero = q[0] == 0
    require(not at_zero or room[0][0] == -room[0][1], "a room round q = 0 is not symmetric")
    require(at_zero or (q[0] > q[1] and room[0][0] >= 0), "a crossing may lie at q = 0")
    check_alone(family, room, (q[0], x[0]), (q[1], x[1]))
    family.pieces += bits // 100
    require(family.pieces < family.left, "the certificate asks for more work than this verifier does")
    with spectra.precision(bits + 128):
        waves = Waves(family.track, family.vehicle)
        sharp = replaced(family, waves)
        twice = [(m, 2 * r) for m, r in (q, x)]
        g, vary, s = slopes(sharp, twice)
        turn = (g[0].conjugate() * g[1]).imag
        rest = abs(s.k[0]) + sum((abs(y) for y in s.k[3:]), ZERO) / 4 + s.e
        require(not turn.contains(0), "a crossing is not proved transversal")
        for y in (g[1], g[0]):
            require(abs(y) * rest / abs(turn) < 0.5, "a crossing is not proved to lie in its balls")
        slope_q, slope_x = (y + spectra.box(r) for y, r in zip(g, vary, strict=True))
        drift = (-slope_x / slope_q).imag
        require(not drift.contains(0), "a root may touch the real axis without crossing it")
    return Zero((room[0], room[1]), q, x, (-1 if drift > 0 else 1) * (1 if at_zero else 2))


def check_alone(family: Family, room: Box, at_: Sequence[Any], radius: Sequence[Any]) -> None:
    """One real root at most over the room: over a core round the crossing, and none over the rest of the room."""
    core = room
    for _ in range(8):
        inside = all(a < m - r and m + r < b for m, r, (a, b) in zip(at_, radius, core, strict=True))
        require(inside, "a room may hold two crossings")
        try:
            g, vary, _ = slopes(family, [((a + b) / 2, b - a) for a, b in core])  # over a box of twice the size
            turn = abs((g[0].conjugate() * g[1]).imag)
            if abs(g[1]) * vary[0] + abs(g[0]) * vary[1] < turn:
                break
        except Refused:
            pass
        core = tuple(((a + m) / 2, (b + m) / 2) for m, (a, b) in zip(at_, core, strict=True))
    else:
        raise Refused("a room may hold two crossings")
    ends = [(a, c, d, b) for (a, b), (c, d) in zip(room, core, strict=True)]
    whole = ((fmpq(0), room[0][1]), *family.box)
    for i, j in product(range(3), repeat=2):
        sides = [(e[k], e[k + 1]) for e, k in zip(ends, (i, j), strict=True)]
        part = tuple((max(a, c), min(b, d)) for (a, b), (c, d) in zip(sides, whole, strict=True))
        if (i, j) != (1, 1) and all(a < b for a, b in part):
            family.prove("n", part)


def replaced(family: Family, waves: Waves) -> Family:
    matrix = Matrix(family.vehicle, waves)
    return Family(family.track, family.vehicle, family.box, family.envelope, waves, matrix, family.sites)


def slopes(family: Family, sides: Sequence[tuple[Any, Any]]) -> tuple[list[Any], list[Any], Form]:
    """Of s over boxes (middle, half): its slopes in u at 0, by how much they vary for |u_i| ≤ 1/2, and s."""
    place = Place([arb(m) for m, _ in sides], [arb(r) for _, r in sides])
    s = family.scalar(place, throughout=True)
    a, mixed, b = (abs(x) for x in s.k[3:])
    return s.k[1:3], [a + mixed / 2 + 2 * s.e, b + mixed / 2 + 2 * s.e], s


# --- the certificate --------------------------------------------------------------------------------------


def checked(content: dict[str, Any], most: int | None) -> str:
    """The claim in words, if every step of the certificate holds."""
    keys(content["equations"], "free track velocity vehicle")
    names = items(content["equations"]["free"], MAX_PARAMETERS, "free")
    known = all(isinstance(x, str) and re.fullmatch(r"[!-+\--~]{1,60}", x) for x in names)
    require(names and known, "free: no names, or a space or comma in one")
    count = len(names)
    require(len(set(names)) == count, "two free parameters have one name")
    box: Box = tuple(
        (rational(a, "range"), rational(b, "range"))
        for a, b in (items(one, 2, "range", 2) for one in items(content["range"], count, "range", count))
    )
    require(all(a < b for a, b in box), "a range is empty")
    crossing = content["kind"] == "crossings"
    require(not crossing or count == 1, "crossings are over one parameter")
    equations = content["equations"]
    track = spectra.read_track(equations["track"], equations["velocity"], box)
    vehicle = spectra.read_bodies(equations["vehicle"], content["basis"], box, MAX_BODIES, MAX_CONTACTS)
    sites = apart(vehicle, box)
    check_track(track, box)
    spectra.check_decay(track.ring, track.D, track.N, spectra.speed(track.ring, track.velocity))
    at_, unstable = check_base(content, count, box)
    envelope, Q = read_tail(content["tail"], track, sites, box)
    waves = Waves(track, vehicle)
    family = Family(track, vehicle, box, envelope, waves, Matrix(vehicle, waves), sites)
    values = items(content["zeros"], MAX_ZEROS, "zeros")
    require(crossing or not values, "a root is real in a range that is to be stable")
    X, ends = dyadic(content["X"], "X"), [dyadic(x, "beyond") for x in items(content["beyond"], MAX_CELLS, "beyond")]
    require(0 < X <= Q, "X is not between 0 and Q")
    ends = [X, *ends, Q]
    require(all(a <= b for a, b in pairwise(ends)), "the cells beyond X are not in order")
    require(isinstance(content["tree"], str), "the tree is no text")
    family.left = EXTRA * (len(content["tree"]) + len(ends)) + PIECES
    if most is not None:
        family.left, family.one = min(family.left, most), LEAF
    zeros = [read_zero(value, family) for value in values]
    for a, b in pairwise(ends):
        if a < b:
            family.prove("p", ((a, b), *box))
    leaves = 0
    for kind, here in walk(content["tree"], ((fmpq(0), X), *box)):
        leaves += 1
        if kind == "z":
            inside = any(
                all(a <= c and d <= b for (a, b), (c, d) in zip(zero.room, here, strict=True)) for zero in zeros
            )
            require(inside, "a leaf is not inside a room")
            continue
        require(kind == "n" or here[0][0] > 0, "a passive box begins at q = 0")
        family.prove(kind, here)
    said = crossings(content["claim"], zeros, box, at_, unstable) if crossing else stable(content["claim"], unstable)
    return words(content, said, box, leaves, family.pieces)


def check_base(content: Any, count: int, box: Box) -> tuple[list[Any], int]:
    """The point of the base, and the number of roots with Im q < 0 there, by its own certificate."""
    base = content["base"]
    keys(base, "at spectrum")
    x = [rational(y, "at") for y in items(base["at"], count, "at", count)]
    require(all(a <= y <= b for y, (a, b) in zip(x, box, strict=True)), "the base lies outside the ranges")
    raw = json.dumps(base["spectrum"], ensure_ascii=True).encode("ascii")
    verdict = spectra.verify_bytes(raw)
    require(verdict.valid, f"the spectrum at the base: {verdict.reason}")
    spectrum = base["spectrum"]
    require(spectrum["claim"]["region"]["kind"] in ("unstable", "below"), "the base does not count all of Im q < 0")
    require(spectrum["basis"] == content["basis"], "the base has another basis")
    ours, other = content["equations"], spectrum["equations"]
    require(at_point(ours, x) == at_point(other, ()), "the base is of other equations")
    return x, int(spectrum["claim"]["unstable"])


def at_point(equations: Any, x: Sequence[Any]) -> Any:
    """The equations at exact parameters: entry by entry."""

    def value(f: Any) -> Any:
        return spectra.at(spectra.free(f, len(x), "the base", -4), x)

    def entry(p: Any) -> dict[Any, Any]:
        out: dict[Any, Any] = {}
        for (i, j, *e), c in spectra.terms(p).items():
            out[i, j] = out.get((i, j), 0) + c * spectra.monomial(x, e)
        return {key: c for key, c in out.items() if c != 0}

    _, rows, loaded = spectra.read_rows(equations["track"], len(x))
    vehicle, track = equations["vehicle"], [[entry(p) for p in row] for row in rows]
    matrices = [[[value(f) for f in row] for row in vehicle[name]] for name in "MCKB"]
    lines = [[value(f) for f in vehicle[name]] for name in ("places", "compliances")]
    return loaded, track, value(equations["velocity"]), matrices, lines


def crossings(claim: Any, zeros: Sequence[Zero], box: Box, at_: Sequence[Any], unstable: int) -> list[str]:
    """The claimed numbers of roots between the crossings in the range follow from the base."""
    keys(claim, "counts directions")
    low, high = box[0]
    inside = []
    for zero in zeros:
        a, b = zero.x[0] - zero.x[1], zero.x[0] + zero.x[1]
        require(b < low or a > high or (low < a and b < high), "a crossing lies at an end of the range")
        if low < a and b < high:
            inside.append(zero)
    inside.sort(key=lambda zero: zero.x[0])
    for one, other in pairwise(inside):
        require(one.x[0] + one.x[1] < other.x[0] - other.x[1], "two crossings are not told apart")
    told = [integer(n, -2, 2, "directions") for n in items(claim["directions"], MAX_ZEROS, "", len(inside))]
    require([zero.gained for zero in inside] == told, "the crossings are not those of the claim")
    counts = [integer(n, 0, 10_000, "counts") for n in items(claim["counts"], MAX_ZEROS + 1, "", len(inside) + 1)]
    require(all(b - a == zero.gained for (a, b), zero in zip(pairwise(counts), inside, strict=True)),
            "the counts do not fit the crossings")  # fmt: skip
    before = 0
    for zero in inside:
        apart = zero.x[0] + zero.x[1] < at_[0] or at_[0] < zero.x[0] - zero.x[1]
        require(apart, "the base lies at a crossing")
        before += zero.x[0] < at_[0]
    require(counts[before] == unstable, "the counts do not fit the number at the base")
    said = [f"{len(inside)} crossing{'' if len(inside) == 1 else 's'} of the real axis; "
            f"roots with Im q < 0 before, between and behind: {', '.join(map(str, counts))}"]  # fmt: skip
    for zero in inside:
        x, q = float(arb(zero.x[0])), float(arb(zero.q[0]))
        said.append(f"  at {x:.15g} within {float(arb(zero.x[1])):.2g}, q = {q:.15g}"
                    + ("" if q else " exactly") + f", {zero.gained:+d}")  # fmt: skip
    return said


def stable(claim: Any, unstable: int) -> list[str]:
    keys(claim, "unstable")
    require(integer(claim["unstable"], 0, 10_000, "unstable") == unstable, "the number at the base is another one")
    return [f"{unstable} roots with Im q < 0 for all parameters in their ranges"]


def words(content: Any, said: list[str], box: Box, leaves: int, pieces: int) -> str:
    """What has been verified, of which equations."""
    names = content["equations"]["free"]
    ranges = ", ".join(f"{name} from {a} to {b}" for name, (a, b) in zip(names, box, strict=True))
    equations = content["equations"]
    said = [f"{said[0]}, for {ranges}", *said[1:]]
    said.append(
        f"proved in {leaves} boxes of frequency and parameters, {pieces} pieces looked at, of these equations"
    )
    said.append(f"  (terms [power of P = ∂/∂x, of s = ∂/∂t, coefficient]; powers of {', '.join(names)}):")
    for row in equations["track"]["matrix"]:
        said.append(f"  {listed(row)}")
    said.append(f"  row {equations['track']['loaded'] + 1}: contacts; velocity {listed(equations['velocity'])}")
    return "\n".join([*said, f"  {spectra.vehicle_words(equations['vehicle'])}"])


if __name__ == "__main__":
    sys.exit(spectra.main(sys.argv[1:], verify, "verify_ranges.py"))
