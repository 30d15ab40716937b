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
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import combinations, pairwise, product
from math import asinh, comb, sinh
from operator import mul
from typing import Any

from flint import acb, acb_mat, acb_poly, arb, arb_mat, arb_poly, fmpq

if __package__:
    from mpsolve.certificate import verify2 as spectra
else:
    import verify2 as spectra  # type: ignore[import-not-found,no-redef]

Refused, Verdict = spectra.Refused, spectra.Verdict
Form = spectra.Form
Place = spectra.Place
Split = spectra.Split
Sums = spectra.Sums
by_power, ZERO, NONE = spectra.by_power, spectra.ZERO, spectra.NONE
require, keys, items, integer, rational, dyadic, listed = (
    spectra.require, spectra.keys, spectra.items, spectra.integer, spectra.rational, spectra.dyadic, spectra.listed,
)  # fmt: skip

KINDS = ("crossings", "stable", "chart")
KEYS = "equations basis range base tail X beyond tree zeros claim"
MAX_BYTES, MAX_PARAMETERS, MAX_NODES, MAX_ZEROS = 32_000_000, 6, 4_000_000, 100
MAX_BODIES, MAX_CONTACTS, MAX_CELLS = 24, 12, 400
DEPTH, EXTRA, PIECES = 24, 8, 4_000  # halvings of a leaf; boxes looked at: EXTRA a leaf, and PIECES
LEAF = 400
MARKS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"  # of the regions of a chart, in order
MAX_SIDE, TESTS, RENEWED = 512, 8, 16  # cells along each parameter; tests of a form that are one piece of work; when
BITS = 64
TERMS = 3  # of a series in the matrix over a box
TOGETHER = 0.3  # p-roots closer than this share of other distances share a circle
SAMPLES, GROWTH = 32, 7.5  # points of a circle; by which power of e waves from it grow at most
NARROWER = fmpq(1, 1 << 20)
SIDE, REACH = 20, 6.0  # cells of wavenumber on each side of a wave, and how far they go

Exponents = tuple[int, ...]
Free = dict[Exponents, Any]  # {exponents of the parameters: c}
Box = tuple[tuple[Any, Any], ...]  # exact ends of q and of the parameters, or of the parameters alone


def verify(path: Any) -> spectra.Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    return spectra.of_file(path, verify_bytes, MAX_BYTES)


def verify_bytes(raw: bytes, most: int | None = None) -> spectra.Verdict:
    """The verdict on a certificate's bytes. Never raises for what they hold. most: boxes that it
    may look at, and then LEAF of them for one leaf; by default it is bounded by the length of the file."""
    claim = lambda: checked(spectra.opened(raw, dict.fromkeys(KINDS, KEYS)), most)  # noqa: E731
    return spectra.judged(raw, claim, MAX_BYTES)


# --- the equations ----------------------------------------------------------------------------------------


def check_track(track: spectra.Track, box: Box) -> None:
    """For all parameters: passive at rest, no p-root real for Re σ ≥ 0, and none lost (section 10.2)."""
    require(track.velocity, "the velocity is 0 throughout: at rest nothing grows")
    lead = {e: c for e, c in track.d.items() if e[0] == track.degree}
    require(all(e[1] == 0 for e in lead), "the highest coefficient of D depends on the frequency")
    top = {e[2:]: c for e, c in lead.items()}
    if spectra.at(top, [(a + b) / 2 for a, b in box]) < 0:
        top = {e: -c for e, c in top.items()}
    spectra.everywhere([top], box, "a wave speed may lie in the range")
    for rows in spectra.hurwitz(track.ring, track.D, box):
        why = "the track is not proved stable and damped for all these parameters"
        spectra.everywhere(rows, box, why)
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
    spectra.everywhere([both], box, "the inertia of the track may vanish")


def apart(vehicle: spectra.Bodies, box: Box) -> list[Free]:
    """The different places, in order: they stay apart for all parameters."""
    kept = [place for k, place in enumerate(vehicle.places) if place not in vehicle.places[:k]]
    middle = [(a + b) / 2 for a, b in box]
    kept.sort(key=lambda f: spectra.at(f, middle))
    for one, other in pairwise(kept):
        spectra.everywhere([spectra.minus(other, one)], box, "two places may meet")
    return kept


# --- the splitting over a box, p-roots and G --------------------------------------------------------------


class Wide(spectra.Refused):
    """A box is too wide for the forms; `weights` tell along which variable to halve it."""

    def __init__(self, why: str, weights: Sequence[float] = ()) -> None:
        super().__init__(why)
        self.weights = list(weights)


class Waves(spectra.Waves):
    """What the track needs over boxes, and what it absorbs."""

    def __init__(self, track: spectra.Track, vehicle: spectra.Bodies, box: Box) -> None:
        super().__init__(track, vehicle.places, [(a + b) / 2 for a, b in box])
        P, s, *x = track.ring.gens()
        W = spectra.absorption(track.ring, track.D, track.N)[0]  # at Ω = q − vp
        W = W.compose(P, s - spectra.speed(track.ring, track.velocity) * P, *x, ctx=track.ring)
        turn = [acb(1), acb(0, -1), acb(-1), acb(0, 1)]  # q = −iσ
        self.W = Sums.of([{e: turn[e[0] % 4] * arb(c) for e, c in f.items()} for f in by_power(spectra.terms(W))])
        self.up: int | None = None  # n₊, once it is proved somewhere: the same in all of the range


def place_over(middle: Sequence[Any], half: Sequence[Any]) -> Place:
    """Where q and the parameters are middle ± half, σ = iq."""
    turn = [acb(0, 1), *[acb(1)] * (len(half) - 1)]
    x, r = ([t * y for t, y in zip(turn, row, strict=True)] for row in (middle, half))
    return Place(x, r, 2)


def place_of(box: Box, slope: Any = 0) -> Place:
    """slope: the box is one of (t, θ), q = t + slope·θ_1."""
    place = place_over([arb((a + b) / 2) for a, b in box], [arb((b - a) / 2) for a, b in box])
    return Sloped(place.middle, place.half, place.order, slope) if slope else place


class Sloped(Place):
    """The first variable is τ, σ = τ + i·slope·θ_1."""

    def __init__(self, middle: Sequence[Any], half: Sequence[Any], order: int, slope: Any) -> None:
        super().__init__(middle, half, order)
        self.slope = slope

    @cached_property
    def powers(self) -> list[list[Form]]:
        out = super().powers
        tau, x = out[0][1], out[1][1]
        out[0][1] = tau + x.scaled([acb(0, self.slope)])
        return out

    def taylor(self, polynomials: Sums) -> Any:
        exponents, turn = turned(polynomials.exponents, self.slope)
        return super().taylor(Sums(exponents, polynomials.matrix * turn))


@lru_cache(maxsize=64)
def turned(exponents: tuple[Exponents, ...], slope: Any) -> tuple[tuple[Exponents, ...], Any]:
    """(exponents of τ and θ, a matrix whose rows are the monomials of σ = τ + i·slope·θ_1 and θ in these)."""
    rows = [
        {(e[0] - k, e[1] + k, *e[2:]): comb(e[0], k) * acb(0, slope) ** k for k in range(e[0] + 1)}
        if e
        else {e: acb(1)}
        for e in exponents
    ]
    new = tuple(sorted({e for row in rows for e in row}))
    return new, acb_mat(len(rows), len(new), [row.get(e, NONE) for row in rows for e in new])


def laid(box: Box, slope: Any, more: Any) -> Box:
    """A box of (t, θ) with q = t + more·θ_1 that holds all (q, θ) of one with another slope."""
    (low, high), (a, b) = box[:2]
    ends = [(slope - more) * a, (slope - more) * b]
    return ((low + min(ends), high + max(ends)), *box[1:])


def resized(place: Place, factor: Any) -> Place:
    """About the same middle, along the same slope."""
    half = [r * factor for r in place.half]
    if isinstance(place, Sloped):
        return Sloped(place.middle, half, place.order, place.slope)
    return Place(place.middle, half, place.order)


def nodes_over(waves: spectra.Waves, place: Place) -> spectra.Nodes:
    """Those of the middle of the box."""
    try:
        return spectra.nodes_near(waves.near(place))
    except ValueError:
        raise Wide("p-roots meet in the middle of a box") from None


def split_over(waves: spectra.Waves, place: Place, throughout: bool, nodes: spectra.Nodes | None = None) -> Split:
    """The pair of Lemma 1 over the box, proved to be (roots with Re P < 0, the others) at its middle.

    throughout: at every point of the box, inside the range or not. nodes: those of its middle, where they are known.
    """
    nodes = nodes or nodes_over(waves, place)
    try:
        split = nodes.split()
    except Refused as error:
        raise Wide(str(error), strain(nodes)) from None
    if not spectra.sided(split):
        thin = nodes.split(thin=True)
        fine = spectra.sided(thin) and all(x < y for x, y in zip(thin.tight, split.box, strict=True))
        if throughout or not fine:
            raise Wide("a p-root may be real in a box", strain(nodes))
    return split


def strain(nodes: spectra.Nodes) -> list[float]:
    """How far each variable moves p-roots, relative to the distance of the next one of the other side."""
    out, lead = [0.0] * nodes.values.m, float(abs(nodes.local.D[nodes.local.degree, 0]))
    for side, other in (nodes.side, reversed(nodes.side)):
        for k in side:
            near = min((float(nodes.distance[k][j]) for j in other), default=1.0)
            for i, row in enumerate(nodes.values.k[1 : 1 + len(out)]):
                out[i] = max(out[i], float(abs(row[k])) / (lead * float(abs(nodes.all[k])) * near))
    return out


def alone(nodes: spectra.Nodes, used: Sequence[int], throughout: bool) -> tuple[Form, Form] | None:
    """These p-roots over the box, each alone in a disc that follows it, and N/D_P there; None if that is not proved.

    δ(u): any quadratics near the roots less the nodes, exact. With D(z + δ + h) = Σ c_j h^j there is exactly one root
    in |h| < ε, for all complex |u_i| ≤ 1, where |c_0| + Σ_{j ≥ 2} |c_j| ε^j < |c_1| ε (Rouché), and there |h| is at
    most the left side over |c_1|. throughout: as in `split_over`.
    """
    local, z = nodes.local, [nodes.z[k] for k in used]
    D, sizes = local.about(z, local.D)
    if any(x.contains(0) for x in D[1].k[0]):
        return None
    delta = followed(D)
    most = delta.size
    if not nodes_apart(nodes, used, most):
        return None
    value, slope = (spectra.along(D, sizes, delta, most, way) for way in (False, True))
    eps, lost = [], []
    for k, (first, moved) in enumerate(zip(value.size, slope.spread, strict=True)):
        c = arb_poly([0, 0, *(size[k] for size in sizes[2:])])(arb_poly([most[k], 1])).coeffs()[2:]  # bounds of |c_j|
        low = slope.k[0][k].abs_lower() - moved
        eps.append(spectra.alone([first, ZERO, *c], low))
        lost.append(arb_poly([0, 0, *c]).derivative()(eps[k]))
    off = [x + y for x, y in zip(most, eps, strict=True)]
    own = off if throughout else [abs(x) + y for x, y in zip(delta.k[0], eps, strict=True)]
    sided = all((-x.real if k < nodes.up else x.real) > y for k, x, y in zip(used, z, own, strict=True))
    if not (sided and nodes_apart(nodes, used, off)):
        return None
    h, (N, above) = Form(delta.k, eps, delta.m), local.about(z, local.N)
    return h.plus(z), spectra.along(N, above, h, off) * slope.rested(lost).inverse()


def nodes_apart(nodes: spectra.Nodes, used: Sequence[int], off: Sequence[Any]) -> bool:
    """Whether the discs of radii `off` round these nodes are disjoint."""
    return all(nodes.distance[i][k] > x + y for (i, x), (k, y) in combinations(zip(used, off, strict=True), 2))


def followed(D: Sequence[Form]) -> Form:
    """δ with E_0 + E_1δ + E_2δ² = 0 up to the second order, exact numbers near it. Nothing rests on them."""
    zero, one = D[0].k, D[1].k
    over = [-1 / x for x in one[0]]
    k = [[x * c for x, c in zip(row, over, strict=True)] for row in zero[: 1 + D[0].m]]
    for n, i, j in D[0].second:
        bent = [x * y * (1 if i == j else 2) for x, y in zip(k[i], k[j], strict=True)]
        term = [x + y * z for x, y, z in zip(zero[n], one[i], k[j], strict=True)]
        if i != j:
            term = [x + y * z for x, y, z in zip(term, one[j], k[i], strict=True)]
        if len(D) > 2:
            term = [x + y * z for x, y, z in zip(term, D[2].k[0], bent, strict=True)]
        k.append([x * c for x, c in zip(term, over, strict=True)])
    return Form([[x.mid() for x in row] for row in k], [ZERO] * len(over), D[0].m)


def kernels_over(waves: Waves, place: Place, throughout: bool) -> Form:
    """G at each distance over the box. throughout: as in `split_over`."""
    nodes = nodes_over(waves, place)
    sides = [0, 1] if throughout or len(waves.gaps) > 1 else [0]
    used = [k for side in sides for k in nodes.side[side]]
    if waves.up is None and not throughout:
        waves.up = split_over(waves, resized(place, NARROWER), False).nodes.up
    try:
        found = alone(nodes, used, throughout) if throughout or nodes.up == waves.up else None
        if found is not None:
            return spectra.summed(waves, [place], *found, [[k for k in side if k in used] for side in nodes.side])[0][
                0
            ]
    except Refused:
        pass
    return receptances(waves, split_over(waves, place, throughout, nodes))


def circles(split: Split, side: int, reach: float) -> list[tuple[Any, list[Any], list[int]]]:
    """(middle, three radii, nodes inside) of circles; roots that are close share one. Nothing rests on them.

    reach: the greatest distance, over which waves from a circle may grow by so much only.
    """
    own, z = list(split.nodes.side[side]), [complex(x) for x in split.nodes.z]
    others = [k for k in range(len(z)) if k not in own]
    far = {k: min((abs(z[k] - z[j]) for j in others), default=1e300) for k in own}
    groups: list[list[int]] = []
    for k in own:
        near = [g for g in groups if any(abs(z[k] - z[j]) <= TOGETHER * min(far[k], far[j]) for j in g)]
        groups = [g for g in groups if g not in near] + [[k, *(j for g in near for j in g)]]
    out = []
    for g in groups:
        middle = sum(z[k] for k in g) / len(g)
        size = max(abs(z[k] - middle) for k in g)
        outer = min([abs(z[k] - middle) for k in range(len(z)) if k not in g] + [4 * (abs(middle) + size)])
        size += len(g) * max(float(split.tight[k]) for k in g)
        outer = min(outer, max(GROWTH / (reach or 1e-300), 3 * size))
        radius = max(0.4 * outer, (size * outer) ** 0.5)
        out.append((acb(middle), [arb(x) for x in (size + 0.05 * (radius - size), radius, 0.85 * outer)], g))
    return out


def on_circle(split: Split, N: Form, distances: Form, middle: Any, radius: Any, inside: Sequence[int]) -> list[Any]:
    """Bounds of |N e^{Pξ}/D| times the radius on a circle, at each distance; in it are as many zeros of D as nodes.

    |D| ≥ |lead| Π|P − z_k| · Π(1 − Σ a_k/|P − z_k|) > 0 there.
    """
    nodes = split.nodes
    gaps = [abs(middle - z) - radius for z in nodes.z]
    fine = all(gap < 0 if k in inside else gap > 0 for k, gap in enumerate(gaps))
    low, far = nodes.local.lead, abs(middle) + radius
    for gap in gaps:
        low = low * abs(gap)
    for here in nodes.side:
        share = 1 - sum((split.tight[k] / abs(gaps[k]) for k in here), ZERO)
        fine, low = fine and bool(share > 0), low * share
    require(fine and low > 0, "p-roots come too near to others over a box")
    most = sum((x * far**i for i, x in enumerate(N.size)), ZERO) / low * radius
    moved = zip(distances.k[0], distances.spread, strict=True)
    return [most * ((middle * x).real + radius * abs(x) + far * change).exp() for x, change in moved]


def receptances(waves: spectra.Waves, split: Split) -> Form:
    """G at each distance over the box, by the trapezoidal rule on circles; p-roots of one side may meet."""
    local, order, parts = split.nodes.local, list[int](), list[Form]()
    N, xi = local.place.form(local.N), local.place.value(waves.xi)
    try:
        for side in (0, 1):
            mine = [g for g, ahead in enumerate(waves.ahead) if ahead == (side == 0)]
            distances, total = xi.take(mine), local.place.number(0).take([0] * len(mine))
            reach = max((float(x) for x in distances.size), default=0.0)
            for middle, radii, inside in circles(split, side, reach) if mine else ():
                part = on_points(waves, local, mine, distances, middle, radii[1], 1 - 2 * side)
                for other in (radii[0], radii[2]):
                    seen = on_circle(split, N, distances, middle, other, inside)
                    ratio = (other / radii[1] if other is radii[0] else radii[1] / other) ** SAMPLES
                    require(ratio < 1, "circles are not in order")
                    part = part.rested([x * ratio / (1 - ratio) for x in seen])
                total = total + part
            order, parts = order + mine, [*parts, total]
    except Refused as error:
        raise Wide(str(error), strain(split.nodes)) from None
    return spectra.joined(parts).take([order.index(g) for g in range(len(order))])


def on_points(
    waves: spectra.Waves,
    local: spectra.Local,
    gaps: Sequence[int],
    distances: Form,
    middle: Any,
    radius: Any,
    sign: int,
) -> Form:
    """± the mean of N e^{Pξ}/D times P − middle over points of a circle, at each distance."""
    arms = [radius * acb(fmpq(2 * k, SAMPLES)).exp_pi_i() for k in range(SAMPLES)]
    points = [middle + x for x in arms]
    D, N = (local.place.form(acb_mat([spectra.powers(p, t.nrows() - 1) for p in points]) * t)
            for t in (local.D, local.N))  # fmt: skip
    f = (N * D.inverse()).scaled([x * fmpq(sign, SAMPLES) for x in arms])
    if waves.fixed:
        wave = acb_mat([[(p * waves.distances[g]).exp() for g in gaps] for p in points])
        k = [(acb_mat([row]) * wave).entries() for row in f.k]
        return Form(k, (arb_mat([f.e]) * spectra.moduli(wave)).entries(), f.m)
    n = len(gaps)
    phase = distances.take([*range(n)] * SAMPLES).scaled([p for p in points for _ in gaps])
    return spectra.folded(phase.exp() * f.take([k for k in range(SAMPLES) for _ in gaps]), n)


# --- the characteristic matrix over a box -----------------------------------------------------------------


def cleared(A: Any, units: Sequence[Sequence[float]]) -> tuple[Any, Any]:
    """X, Y with XAY = diag(1, …, 1, s) to the present precision, s about the least singular value in these units of
    rows and columns. Nothing rests on them."""
    (tall, wide), n = units, A.nrows() - 1
    a = acb_mat([[complex(x) / t / w for x, w in zip(row, wide, strict=True)]
                 for row, t in zip(A.tolist(), tall, strict=True)])  # fmt: skip
    inverse = spectra.near_inverse(a + spectra.identity(n + 1) * acb(2.0**-50)).tolist()
    forth = [[complex(x) for x in row] for row in inverse]
    back, one = [[x.conjugate() for x in column] for column in zip(*forth, strict=True)], [1 + 0j] * (n + 1)
    for _ in range(3):
        two = [sum(map(mul, row, one)) for row in forth]
        one = [sum(map(mul, row, two)) for row in back]
    left = acb_mat([[x / t for x, t in zip(row, tall, strict=True)] for row in reflection(one)])
    right = acb_mat([[x / w for x in row] for row, w in zip(reflection(two), wide, strict=True)])
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


def scalar(matrix: spectra.Forms, m: int, units: Sequence[Sequence[float]]) -> Form:
    """s with det A = 0 exactly where s = 0: XAY = [[1 + E, e], [f, g]], s = g − f(1 + E)⁻¹e."""
    A, lost = matrix
    n, last = lost.nrows(), lost.nrows() - 1
    if n == 1:
        return Form([[a[0, 0]] for a in A], [lost[0, 0]], m)
    left, right = cleared(A[0], units)
    parts = [left * a * right for a in A]
    rest = spectra.moduli(left) * lost * spectra.moduli(right)
    near = spectra.moduli(parts[0] - spectra.identity(n)) + rest
    sizes = sum(map(spectra.moduli, parts[1:]), near).tolist()
    E = arb_mat([row[:last] for row in sizes[:last]])
    x, eta = spectra.near_weights(E, 0.05)
    if not eta < 0.9:
        moved = [float(max(sum((abs(y) for y in row), ZERO) for row in a.tolist())) for a in parts[1 : 1 + m]]
        raise Wide("the matrix changes too much over a box", moved)

    def picked(where: Sequence[tuple[int, int]]) -> Form:
        return Form([[a[i, j] for i, j in where] for a in parts], [rest[i, j] for i, j in where], m)

    column, row = picked([(i, last) for i in range(last)]), picked([(last, i) for i in range(last)])
    s = picked([(last, last)]) + -spectra.folded(row * column, 1)
    e, total = arb_mat(last, 1, column.size), arb_mat(last, 1)
    for _ in range(TERMS):
        e = E * e
        total += e
    beyond = spectra.max_bound(*(f / y for f, y in zip(e.entries(), x, strict=True))) * eta / (1 - eta)
    return s.rested((arb_mat(1, last, row.size) * (total + arb_mat(last, 1, x) * beyond)).entries())


def check_nonzero(s: Form) -> None:
    """Re(d s) > 0 for one direction d and all real u, or Wide."""
    m, rest, coefficients = s.m, s.e[0], [row[0] for row in s.k]
    b = coefficients[1 : 1 + m]
    directions = [coefficients[0].conjugate()] + [x.conjugate() * acb(0, 1) for x in b]
    if m > 1:
        directions.append(sum(b, NONE).conjugate() * acb(0, 1))
    best, found = -1e300, [0.0] * m
    for d in directions:
        near = complex(d)
        size = abs(near)
        if not 1e-300 < size < 1e300:
            continue
        d = acb(near / size)
        k = [(x * d).real for x in coefficients]
        if k[0] < 0:
            k = [-x for x in k]
        low = k[0] - rest * abs(d)
        taken = [float(abs(x)) for x in k[1 : 1 + m]]
        for n, i, j in s.second:
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
        share = float(low) / (abs(complex(coefficients[0])) or 1e-300)
        if share > best:
            best, found = share, taken
    moved = [float(abs(x)) for x in b]
    whole = sum(moved) or 1.0
    raise Wide(
        "the determinant may vanish in a box",
        [t + float(rest) * x / whole for t, x in zip(found, moved, strict=True)],
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
    parts = [by_wavenumber(place.value(x), m) for x in (waves.d, waves.W)]
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


def by_wavenumber(f: Form, m: int) -> tuple[Any, ...]:
    """Σ f_i P^i in parts: polynomials of its coefficients, the slope in P, and polynomials that bound the rest."""
    k = [acb_poly(row) for row in f.k[: 1 + m]]
    second = arb_poly([x + e for x, e in zip(f.sizes(2), f.e, strict=True)])
    mixed = arb_poly([i * x for i, x in enumerate(f.sizes(1))][1:])
    bent = arb_poly([i * (i - 1) * x / 2 for i, x in enumerate(f.sizes(0))][2:])
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
        square = x * x
        return x / 3 * (1 - square / 10 * (1 - square / 28 * (1 - square / 54 + arb(0, 0.0003) * square * square)))
    sin, cos = x.sin_cos()
    return (sin - x * cos) / (x * x)


def check_passive_box(problem: Family, box: Box) -> None:
    """−Im G(q; θ) is positive definite for all q > 0 and θ of the box, or Wide: by cells, or by p-roots."""
    place = place_of(box)
    try:
        by_cells(problem, box, place)
    except Wide as error:
        try:
            by_roots(problem, place)
        except Refused:
            raise error from None


def by_roots(problem: Family, place: Place) -> None:
    """−Im G(q; θ) is positive definite for all q > 0 and θ of the box, from G over it, or Wide."""
    G = kernels_over(problem.waves, place, False)
    require_definite(spectra.definite(*spectra.hermitian(G, problem.waves.between, [acb(0, 1)] * len(G.k))))


def require_definite(seen: bool) -> None:
    if not seen:
        raise Wide("the receptance is not proved passive on a box")


def by_cells(problem: Family, box: Box, place: Place) -> None:
    """The same from cells of wavenumber (section 6.5)."""
    low, high = box[0]
    waves, m = problem.waves, len(box)
    speed, D = place.value(problem.speed), waves.near(place).D
    fastest, slow = speed.k[0][0].real + speed.spread[0], float(speed.k[0][0].real)
    try:
        roots = [complex(x) * -1j for x in acb_poly([D[i, 0].mid() for i in range(D.nrows())]).roots()]
    except ValueError:
        raise Wide("p-roots meet in the middle of a box") from None
    spread = max(float((b - a) / (abs(b + a) or 1)) for a, b in box)
    ends = mesh(roots, float(arb((low + high) / 2)) / slow if slow > 0 else 1e300, spread)
    q = arb(low)
    found = cells(waves, place, q, fastest, ends)
    sites = len(waves.between)
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
        require_definite(best > 0)
        definite(problem, place, found[:chosen], givens[chosen])
    except Wide as error:
        error.weights = [abs(x) for x in off]
        for cell in found[:chosen]:
            error.weights = [x + y for x, y in zip(error.weights, cell.costs(), strict=True)]
        weight = sum(abs(float(cell.a) * float(cell.middle)) * 2 * float(cell.half) for cell in found[:chosen])
        xi = place.value(waves.xi)
        for i in range(1, sites):
            steps = [weight * float(abs(x[waves.between[i][i - 1]])) for x in xi.k[1 : 1 + m]]
            error.weights = [x + y for x, y in zip(error.weights, steps, strict=True)]
        raise


def definite(problem: Family, place: Place, found: Sequence[Cell], given: Any) -> None:
    """∫|U|²Φ is positive definite, or Wide."""
    m, between, xi = place.m, problem.waves.between, place.value(problem.waves.xi)
    n = len(between)
    length = [2 * c.half for c in found]
    rows = [[c.a for c in found], *([c.b[v] for c in found] for v in range(m))]
    whole = [sum((x * y for x, y in zip(row, length, strict=True)), ZERO) for row in rows]
    H = [[[acb(x - given if v == 0 else x) if i == j else NONE for j in range(n)] for i in range(n)]
         for v, x in enumerate(whole)]  # fmt: skip
    E = [[ZERO] * n for _ in range(n)]
    known: dict[int, tuple[list[Any], Any]] = {}
    for i, j in combinations(range(n), 2):
        gap = between[j][i]
        if gap not in known:
            known[gap] = integrals(xi.take([gap]), found, m)
        values, rest = known[gap]
        for v, x in enumerate(values):
            H[v][j][i], H[v][i][j] = x, x.conjugate()
        E[i][j] = E[j][i] = rest
    require_definite(spectra.definite([acb_mat(a) for a in H], arb_mat(E)))


def integrals(distance: Form, found: Sequence[Cell], m: int) -> tuple[list[Any], Any]:
    """∫Φ e^{ipΔ}dp: its middle and slopes, and a bound of what a Δ that moves with the parameters changes."""
    D, moves, second = distance.k[0][0].real, distance.spread[0], distance.sizes(2)[0] + distance.e[0]
    steps = [x[0].real for x in distance.k[1 : 1 + m]]
    width, moving = [2 * c.half for c in found], not moves.is_zero()
    phase = [acb(0, c.middle * D).exp() * w for c, w in zip(found, width, strict=True)]
    plain = [y * (c.half * D).sinc() for c, y in zip(found, phase, strict=True)]
    turned = [y * acb(0, bend(c.half * D)) for c, y in zip(found, phase, strict=True)]
    table = acb_mat([[acb(x) for x in (c.a, *c.b, c.a * c.middle if moving else 0)] for c in found])
    *out, bent = (acb_mat([plain]) * table).entries()
    out[0] += (acb_mat([turned]) * acb_mat([[acb(c.turn)] for c in found]))[0, 0]
    rest = ZERO
    if moving:  # e^{ipδ} = 1 + ipδ + R, |R| ≤ (pδ)²/2
        out[1:] = [x + bent * acb(0, step) for x, step in zip(out[1:], steps, strict=True)]
        for c, w in zip(found, width, strict=True):
            far, a = abs(c.middle) + c.half, abs(c.a)
            slope = abs(c.turn) + sum((abs(y) for y in c.b), ZERO)
            rest += w * moves * (a * c.half + slope * far)
            rest += w * ((a + slope) * (far * moves) ** 2 / 2 + a * far * second)
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
    matrix: spectra.Bordered
    left: int = 0
    pieces: int = 0
    one: int = 1 << 30  # boxes that one leaf may take

    @cached_property
    def speed(self) -> Sums:
        return Sums.of([{(0, *e): c for e, c in self.track.velocity.items()}])

    def scalar(self, place: Place, throughout: bool = False) -> Form:
        """s over a box: 0 exactly where Δ̂ is. throughout: also outside the ranges."""
        G, b = kernels_over(self.waves, place, throughout), self.matrix
        g = max(float(abs(x)) for x in G.k[0])  # the rail gives so much: what of forces is one of displacement
        units = [1 / g] * b.nb + [1.0] * (b.size - b.nb), [1.0] * (b.size - b.nc) + [g] * b.nc
        return scalar(b(place, G), place.m, units)

    def nonzero(self, place: Place) -> None:
        """Δ̂ ≠ 0 over a box, or Wide."""
        check_nonzero(self.scalar(place))

    def prove(self, kind: str, box: Box, slope: Any = 0) -> None:
        """No real root over the box ("n": Δ̂ ≠ 0; passive by "g": G, "p": cells), halved where forms are too wide."""
        stack, most = [(box, 0)], min(self.left, self.pieces + self.one)
        while stack:
            here, depth = stack.pop()
            self.pieces += 1
            require(self.pieces < most, "the certificate asks for more work than this verifier does")
            try:
                if kind == "n":
                    self.nonzero(place_of(here, slope))
                elif kind == "g":
                    by_roots(self, place_of(here))
                else:
                    check_passive_box(self, here)
            except Refused as error:
                where = ", ".join(f"{float(arb(a)):.6g}…{float(arb(b)):.6g}" for a, b in here)
                require(depth < DEPTH, f"the box of q and parameters {where}: {error}")
                stack += [(half, depth + 1) for half in spectra.halved(here, self.axis(here, error))]

    def axis(self, box: Box, error: Any) -> int:
        """Along which variable to halve: where most is to be won, or the longest."""
        whole = [float(abs(box[0][1])) or 1.0, *(float(b - a) or 1.0 for a, b in self.box)]
        share = [float(b - a) / w for (a, b), w in zip(box, whole, strict=True)]
        got = getattr(error, "weights", [])
        if len(got) == len(box) and all(x == x and x < 1e300 for x in got) and max(got) > 0:
            got = [x if y > 0 else -1.0 for x, y in zip(got, share, strict=True)]
            return got.index(max(got))
        return share.index(max(share))


def walk(tree: Any, box: Box) -> Iterator[tuple[str, Box, Any]]:
    """The leaves of a tree in text: a digit halves along an axis, a letter is a leaf; low halves come first.

    sMeE; halves along the first parameter, and lays both halves along the slope M·2^E.
    """
    require(isinstance(tree, str) and 0 < len(tree) <= MAX_NODES, "the tree is no text, or too long")
    stack: list[tuple[Box, Any, int]] = [(box, fmpq(0), 0)]
    for mark in re.finditer(r"s(-?[0-9]{1,30})e(-?[0-9]{1,4});|(.)", tree, re.ASCII | re.DOTALL):
        require(stack, "the tree goes on beyond its last leaf")
        here, slope, depth = stack.pop()
        m, e, letter = mark.groups()
        if letter and letter in "npgzob":
            yield letter, here, slope
            continue
        known = letter is None or letter in "0123456"[: len(box)]
        require(known and depth < 200, "a mark of the tree is not known")
        low, high = spectra.halved(here, int(letter or 1))
        if letter is None:
            new = dyadic([int(m), int(e)], "a slope")
            low, high, slope = laid(low, slope, new), laid(high, slope, new), new
        stack += [(high, slope, depth + 1), (low, slope, depth + 1)]
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
    for (middle, radius), (a, b) in zip((q, x), room, strict=True):
        require(a < middle - radius and middle + radius < b, "a crossing is not inside its room")
    at_zero = q[0] == 0
    require(not at_zero or room[0][0] == -room[0][1], "a room round q = 0 is not symmetric")
    require(at_zero or (q[0] > q[1] and room[0][0] >= 0), "a crossing may lie at q = 0")
    check_alone(family, room, (q[0], x[0]), (q[1], x[1]))
    family.pieces += bits // 100
    require(family.pieces < family.left, "the certificate asks for more work than this verifier does")
    with spectra.precision(bits + 128):
        waves = Waves(family.track, family.vehicle, family.box)
        sharp = replace(family, waves=waves, matrix=spectra.Bordered(family.vehicle, waves))
        twice = [(m, 2 * r) for m, r in (q, x)]
        g, vary, (first, *_, a, mixed, b), e = slopes(sharp, twice)
        turn = (g[0].conjugate() * g[1]).imag
        rest = abs(first) + (abs(a) + abs(mixed) + abs(b)) / 4 + e
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
            g, vary, *_ = slopes(family, [((a + b) / 2, b - a) for a, b in core])  # over a box of twice the size
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


def slopes(family: Family, sides: Sequence[tuple[Any, Any]]) -> tuple[list[Any], list[Any], list[Any], Any]:
    """Of s over boxes (middle, half): its slopes in u at 0, by how much they vary for |u_i| ≤ 1/2, and its form."""
    inside = all(a <= m - r and m + r <= b for (m, r), (a, b) in zip(sides[1:], family.box, strict=True))
    s = family.scalar(place_over([arb(m) for m, _ in sides], [arb(r) for _, r in sides]), throughout=not inside)
    (k, e), (a, mixed, b) = ([row[0] for row in s.k], s.e[0]), (abs(row[0]) for row in s.k[3:])
    return k[1:3], [a + mixed / 2 + 2 * e, b + mixed / 2 + 2 * e], k, e


# --- charts (section 10.8) --------------------------------------------------------------------------------

Part = tuple[int, int, int, int]  # cells from … to before …, along each parameter


class Regions:
    """Cells of a chart with the mark of their region; of the others nothing is claimed."""

    def __init__(self, rows: list[str], box: Box) -> None:
        self.rows, self.box, self.shape = rows, box, (len(rows), len(rows[0]))
        self.sums = [[0] * (1 + self.shape[1])]  # of marked cells before each corner
        for row in rows:
            total, last = 0, self.sums[-1]
            here = [0]
            for mark, above in zip(row, last[1:], strict=True):
                total += mark != "."
                here.append(above + total)
            self.sums.append(here)

    def at(self, x: Sequence[Any]) -> tuple[int, int]:
        """A cell that holds a point of the chart."""
        i, j = (
            min(int(floor((y - a) / (b - a) * n)), n - 1)
            for y, (a, b), n in zip(x, self.box, self.shape, strict=True)
        )
        return i, j

    def under(self, box: Box) -> Part:
        """The cells of which a box holds more than their edges."""
        out: list[int] = []
        for (p, q), (a, b), n in zip(box[1:], self.box, self.shape, strict=True):
            out += [max(floor((p - a) / (b - a) * n), 0), min(-floor((a - q) / (b - a) * n), n)]
        return out[0], out[1], out[2], out[3]

    def marked(self, i: int, k: int, j: int, m: int) -> int:
        return self.sums[k][m] - self.sums[i][m] - self.sums[k][j] + self.sums[i][j]

    def shrunk(self, part: Part) -> Part | None:
        """The least part that holds the same marked cells."""
        i, k, j, m = part
        if not self.marked(i, k, j, m):
            return None
        while not self.marked(i, i + 1, j, m):
            i += 1
        while not self.marked(k - 1, k, j, m):
            k -= 1
        while not self.marked(i, k, j, j + 1):
            j += 1
        while not self.marked(i, k, m - 1, m):
            m -= 1
        return i, k, j, m

    def over(self, part: Part, box: Box) -> Box:
        """What of a box lies over the cells."""
        out = [box[0]]
        for (p, q), (a, b), n, first, last in zip(box[1:], self.box, self.shape, part[::2], part[1::2], strict=True):
            out.append((max(p, a + (b - a) * first / n), min(q, a + (b - a) * last / n)))
        return tuple(out)

    def words(self, counts: Sequence[int]) -> list[str]:
        high, wide = self.shape
        whole = high * wide
        said = [f"roots with Im q < 0 in {len(counts)} regions of a chart of {high} by {wide} cells"]
        for mark, count in zip(MARKS, counts, strict=False):
            cells_ = sum(row.count(mark) for row in self.rows)
            said.append(f"  {mark}: {count} in {cells_} cells, {100 * cells_ / whole:.4g} %")
        return said


def floor(x: Any) -> int:
    return int(x.p // x.q)


def read_regions(claim: Any, box: Box, bases: Sequence[Sequence[Any]]) -> Regions:
    """The regions, each of cells that hang together by their sides, with its base in one of them."""
    keys(claim, "cells")
    rows = items(claim["cells"], MAX_SIDE, "cells")
    fits = all(isinstance(row, str) and 0 < len(row) <= MAX_SIDE for row in rows)
    require(rows and fits and len({len(row) for row in rows}) == 1, "the cells are no rows of one length")
    marks = MARKS[: len(bases)]
    require(set().union(*rows) <= {".", *marks}, "a cell has an unknown mark")
    regions = Regions(rows, box)
    for mark, x in zip(marks, bases, strict=True):
        start = regions.at(x)
        require(rows[start[0]][start[1]] == mark, "a base lies outside of its region")
        seen, stack = {start}, [start]
        while stack:
            i, j = stack.pop()
            for k, m in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                inside = 0 <= k < len(rows) and 0 <= m < len(rows[0])
                if inside and rows[k][m] == mark and (k, m) not in seen:
                    seen.add((k, m))
                    stack.append((k, m))
        require(len(seen) == sum(row.count(mark) for row in rows), "a region does not hang together")
    return regions


def check_regions(family: Family, regions: Regions, box: Box) -> None:
    """No real root over a box at any parameters in marked cells: by forms over it and over its parts."""
    stack: list[tuple[Any, Part, Form | None, Box]] = [(box[0], regions.under(box), None, box)]
    tests, most = 0, min(family.left, family.pieces + family.one)
    while stack:
        q, around, s, whole = stack.pop()
        part = regions.shrunk(around)
        if part is None:
            continue
        here = regions.over(part, (q, *box[1:]))
        tests += 1
        family.pieces += tests % TESTS == 0
        error: spectra.Refused | None = None
        if s is not None:
            error = vanishing(over_part(s, whole, here))
        if s is None or (error and smaller(here, whole)):
            family.pieces += 1
            try:
                s, whole = family.scalar(place_of(here)), here
                error = vanishing(s)
            except Refused as why:
                s, error = None, why
        require(family.pieces < most, "the certificate asks for more work than this verifier does")
        if error is None:
            continue
        i, k, j, m = part
        axis = family.axis(here, error)
        if (k - i, m - j) == (1, 1) and (axis or s is None):
            family.prove("n", here)
        elif axis == 0:
            stack += [(half[0], part, s, whole) for half in spectra.halved(here, 0)]
        elif (axis == 1 and k - i > 1) or m - j == 1:
            stack += [(q, (i, (i + k) // 2, j, m), s, whole), (q, ((i + k) // 2, k, j, m), s, whole)]
        else:
            stack += [(q, (i, k, j, (j + m) // 2), s, whole), (q, (i, k, (j + m) // 2, m), s, whole)]


def vanishing(s: Form) -> spectra.Refused | None:
    """Why a form may vanish, None where it does not."""
    try:
        check_nonzero(s)
    except Refused as error:
        return error
    return None


def smaller(part: Box, whole: Box) -> bool:
    """Whether a form over the part alone may tell more than that over the whole."""
    times = fmpq(1)
    for (p, q), (a, b) in zip(part, whole, strict=True):
        times *= (b - a) / (q - p)
    return bool(times >= RENEWED)


def over_part(s: Form, whole: Box, part: Box) -> Form:
    """The same function over a part of its box: u = c + h t with new variables t."""
    c, h, k = [], [], [row[0] for row in s.k]
    for (a, b), (p, q) in zip(whole, part, strict=True):
        c.append(arb((p + q - a - b) / (b - a)))
        h.append(arb((q - p) / (b - a)))
    here, slopes_, second = k[0], list(k[1 : 1 + s.m]), []
    for x, y in zip(c, k[1:], strict=False):
        here += x * y
    for n, i, j in s.second:
        here += k[n] * c[i - 1] * c[j - 1]
        slopes_[i - 1] += k[n] * c[j - 1]
        slopes_[j - 1] += k[n] * c[i - 1]
        second.append([k[n] * h[i - 1] * h[j - 1]])
    return Form([[here], *([x * y] for x, y in zip(slopes_, h, strict=True)), *second], s.e, s.m)


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
    crossing, chart = (content["kind"] == kind for kind in ("crossings", "chart"))
    require(not crossing or count == 1, "crossings are over one parameter")
    require(not chart or count == 2, "a chart is over two parameters")
    equations = content["equations"]
    track = spectra.read_track(equations["track"], equations["velocity"], box)
    vehicle = spectra.read_bodies(equations["vehicle"], content["basis"], box, MAX_BODIES, MAX_CONTACTS)
    sites = apart(vehicle, box)
    check_track(track, box)
    spectra.check_decay(track.ring, track.D, track.N, spectra.speed(track.ring, track.velocity))
    bases = items(content["base"], len(MARKS), "base") if chart else [content["base"]]
    require(bases, "a chart without a base")
    counted = [check_base(content, base, count, box) for base in bases]
    regions = read_regions(content["claim"], box, [x for x, _ in counted]) if chart else None
    envelope, Q = read_tail(content["tail"], track, sites, box)
    waves = Waves(track, vehicle, box)
    family = Family(track, vehicle, box, envelope, waves, spectra.Bordered(vehicle, waves))
    values = items(content["zeros"], MAX_ZEROS, "zeros")
    require(crossing or not values, "a root is real in a range that is to be stable")
    X, ends = dyadic(content["X"], "X"), [dyadic(x, "beyond") for x in items(content["beyond"], MAX_CELLS, "beyond")]
    require(0 < X <= Q, "X is not between 0 and Q")
    ends = [X, *ends, Q]
    require(all(a <= b for a, b in pairwise(ends)), "the cells beyond X are not in order")
    family.left = EXTRA * (len(content["tree"]) + len(ends)) + PIECES
    if most is not None:
        family.left, family.one = min(family.left, most), LEAF
    zeros = [read_zero(value, family) for value in values]
    for a, b in pairwise(ends):
        if a < b:
            family.prove("p", ((a, b), *box))
    leaves = 0
    for kind, here, slope in walk(content["tree"], ((fmpq(0), X), *box)):
        leaves += 1
        whole = laid(here, slope, 0)
        if kind == "z":
            inside = any(
                all(a <= c and d <= b for (a, b), (c, d) in zip(zero.room, whole, strict=True)) for zero in zeros
            )
            require(inside, "a leaf is not inside a room")
            continue
        if kind == "o":
            if regions is None:
                raise Refused("a leaf is open")
            check_regions(family, regions, whole)
        elif kind == "b":
            require(whole[0][1] < 0 or whole[0][0] > X, "a leaf does not lie beside the frequencies in question")
        else:
            require(kind == "n" or (here[0][0] > 0 and slope == 0), "a passive box begins at q = 0, or has a slope")
            family.prove(kind, here, slope)
    if regions:
        said = regions.words([unstable for _, unstable in counted])
    elif crossing:
        said = crossings(content["claim"], zeros, box, *counted[0])
    else:
        said = stable(content["claim"], counted[0][1])
    return words(content, said, box, leaves, family.pieces)


def check_base(content: Any, base: Any, count: int, box: Box) -> tuple[list[Any], int]:
    """The point of a base, and the number of roots with Im q < 0 there, by its own certificate."""
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
        root = f"q ≈ {q:.15g}" if zero.q[0] else "q = 0 exactly"
        said.append(f"  at ≈ {x:.15g}, in a ball of radius {spectra.two_digits(zero.x[1])}, {root}, {zero.gained:+d}")
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
