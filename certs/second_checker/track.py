"""The track and the vehicle of a certificate, and what must hold of them: sections 2, 3, 6 of SPEC2.md, exactly."""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import Any

import exact as x
from exact import Poly, Terms
from reading import NotCheckedError, keys, listed, matrix, need, rational, whole


class Track:
    """A(P, s), D, N and d(P, σ), N(P, σ)."""

    def __init__(self, value: Any, v: Fraction) -> None:
        keys(value, {"matrix", "loaded"}, "the track")
        rows = listed(value["matrix"], 8, "the track's matrix")
        n = len(rows)
        need(n >= 1 and all(len(listed(row, 8, "a row")) == n for row in rows), "the track's matrix is not square")
        self.A = [[_terms(entry) for entry in row] for row in rows]
        load = self.loaded = whole(value["loaded"], 0, n - 1)
        self.v = v
        self.D = x.determinant(self.A)
        self.N = x.determinant(
            [[entry for j, entry in enumerate(row) if j != load] for i, row in enumerate(self.A) if i != load]
        )
        need(bool(self.D) and bool(self.N), "the track's determinant or its cofactor is 0")
        need(all(i % 2 == 0 for i, _ in (*self.D, *self.N)), "the track's determinant is not even in P")
        moving: Terms = {(0, 1): Fraction(1)}
        if v:
            moving[1, 0] = -v
        self.d = x.replaced(self.D, {(1, 0): Fraction(1)}, moving)
        self.moving_n = x.replaced(self.N, {(1, 0): Fraction(1)}, moving)
        self.degree = max(i for i, _ in self.d)
        need(max(i for i, _ in self.moving_n) + 2 <= self.degree, "the receptance's degrees")

    def lead(self) -> Poly:
        """lead(σ)."""
        top = {j: c for (i, j), c in self.d.items() if i == self.degree}
        return [top.get(j, Fraction(0)) for j in range(max(top) + 1)]

    def check_premise(self, height: Fraction) -> None:
        """Section 3: no p-root is real in the region."""
        a = x.in_y(x.replaced(self.D, {(1, 0): Fraction(1)}, {(0, 1): Fraction(1), (0, 0): -height}))
        m = len(a) - 1
        need(m >= 1, "the track has no inertia")
        if a[m] and a[m][-1] < 0:
            a = [[-c for c in row] for row in a]
        need(x.positive(a[m]), "the track's highest coefficient may vanish")
        test = x.positive if height > 0 else x.nonnegative
        need(all(test(H) for H in x.hurwitz(a)), "a p-root may be real in the region (Hurwitz)")
        lead = x.trimmed([Fraction(c) for c in _shift(self.lead(), -height)])
        if lead[-1] < 0:
            lead = [-c for c in lead]
        need(
            all(H and H[0] > 0 for H in x.hurwitz([[c] if c else [] for c in lead])), "lead has a root in the region"
        )

    def check_passive_at_rest(self) -> None:
        """Section 6.1; W and |D|² are kept."""
        top = max((j for row in self.A for entry in row for _, j in entry), default=0)
        for j in range(top + 1):
            part = [[{i: c for (i, k), c in entry.items() if k == j} for entry in row] for row in self.A]
            n = len(part)
            kept: list[list[Poly]] = []
            for a in range(n):
                kept.append([])
                for b in range(n):
                    mirrored = {i: (-1) ** i * c for i, c in part[b][a].items()}
                    if j % 2 == 0:
                        need(part[a][b] == mirrored, "the track's stiffness or inertia is not symmetric")
                    both = {i: part[a][b].get(i, 0) + mirrored.get(i, 0) for i in {*part[a][b], *mirrored}}
                    kept[-1].append(
                        [Fraction((-1) ** (j // 2) * both.get(i, 0)) / 2 for i in range(max(both, default=-1) + 1)]
                    )
            if j % 2 == 0:
                continue
            for minor in x.minors([[x.trimmed(e) for e in row] for row in kept]):
                need(not any(minor[1::2]), "a minor of the track's damping is not even in P")
                y = x.trimmed([(-1) ** k * c for k, c in enumerate(minor[::2])])
                need(not y or x.nonnegative(y), "the track's damping may feed in")
        self.W, self.DD = self._power()
        need(bool(self.W), "the track does not damp at all")
        need(
            max(j for _, j in self.N) < max(j for _, j in self.D), "the track's receptance is not bounded by inertia"
        )

    def _power(self) -> tuple[Terms, Terms]:
        """W = −Im(N conj D) and |D|² at P = ip, s = iΩ, in p and Ω."""

        def parts(p: Terms) -> tuple[Terms, Terms]:
            real: Terms = {}
            imaginary: Terms = {}
            for (i, j), c in p.items():
                turned = (i + j) % 4
                (imaginary if turned % 2 else real)[i, j] = -c if turned in (2, 3) else c
            return real, imaginary

        a, b = parts(self.N)
        c, d = parts(self.D)
        return x.add(x.multiply(a, d), x.multiply(b, c), -1), x.add(x.multiply(c, c), x.multiply(d, d))

    def check_far(self, theorem: Any, X: Fraction, gap: Fraction | None) -> None:
        """Section 6.2: for all real q ≥ X the track takes more than it gives."""
        keys(theorem, {"gamma", "blocks", "alpha", "omega", "envelope"}, "the theorem")
        from reading import dyadic

        k, m = (whole(c, 0, 64) for c in listed(theorem["gamma"], 2, "gamma"))
        need(m >= 1 and k <= m, "gamma is not in [0, 1]")
        blocks = [[dyadic(c) for c in listed(b, 3, "a block")] for b in listed(theorem["blocks"], 64, "blocks")]
        need(all(len(b) == 3 for b in blocks), "a block has three numbers")
        alpha, omega, C = whole(theorem["alpha"], 2, 64), dyadic(theorem["omega"]), dyadic(theorem["envelope"])
        v, W, DD = self.v, self.W, self.DD
        need(v > 0 and X > 0 and omega > 0 and C > 0 and bool(blocks), "the theorem's numbers")
        moving = {(0, 1): Fraction(1), (1, 0): -v}  # p and q
        w, a = _scaled(x.replaced(W, {(1, 0): Fraction(1)}, moving), k, m)
        d, b = _scaled(x.replaced(DD, {(1, 0): Fraction(1)}, moving), k, m)
        tau = root_bounds(1 / X, 1, m)[1]
        low, high = root_bounds(X, k, m)
        sieve = Fraction(0) if gap is None else 2 * PI_ABOVE / gap
        takes, last = Fraction(0), None
        for z1, z2, kappa in blocks:
            need(z1 < z2 and (last is None or last <= z1) and kappa > 0, "the blocks are not in order")
            last = z2
            need(v * z2 * (high if z2 > 0 else low) < X, "a block is too far")
            need(
                x.positive_on_box(x.add(w, d, -kappa), (z1, z2, Fraction(0), tau)), "a block takes less than it says"
            )
            takes += ((z2 - z1) * low - sieve) * kappa
        takes *= root_bounds(1 / X, b - a, m)[0]
        wide, deep, Iw, Id = (max(i for i, _ in p) for p in (W, DD, W, DD))
        nw, nd = max(i + j for i, j in W), max(i + j for i, j in DD)
        need(alpha <= min(Id - Iw, nd - nw) and wide + alpha <= deep, "alpha is too large")
        both = x.add({key: C * c for key, c in DD.items()}, {(i + alpha, j): c for (i, j), c in W.items()})
        chart = {(Id - i, j): (-1) ** j * c for (i, j), c in both.items()}
        fine = x.positive_on_box(chart, (Fraction(0), v / X, Fraction(0), omega), v)  # −Ω ≤ vp
        own = any(i >= 2 and j == 1 for i, j in self.A[self.loaded][self.loaded])
        if own and not fine:
            raise NotCheckedError(
                "the envelope at low frequencies, which the rail's own damping may give (section 6.2)"
            )
        need(fine, "the envelope fails at low frequencies")
        chart = {(Id - i, nd - i - j): (-1) ** j * c for (i, j), c in both.items()}
        fine = x.positive_on_box(chart, (Fraction(0), v, Fraction(0), 1 / omega), v / X)
        if own and not fine:
            raise NotCheckedError("the envelope at high frequencies, which the rail's own damping may give")
        need(fine, "the envelope fails at high frequencies")
        gives = C * ((X / v) ** (1 - alpha) / (alpha - 1) + sieve * (X / v) ** -alpha)
        need(takes > gives, "the track may give more than it takes")
        need((alpha - 1) * m >= b - a - k, "what the track gives may grow faster")

    def check_decay(self) -> None:
        """Section 6.3: G → 0 at infinity."""
        _edges(self.d, self.moving_n, self.v, False)


PI_ABOVE = Fraction(355, 113)  # greater than π


def _shift(p: Poly, by: Fraction) -> Poly:
    moved = x.replaced(
        {(0, j): c for j, c in enumerate(p) if c}, {(1, 0): Fraction(1)}, {(0, 1): Fraction(1), (0, 0): by}
    )
    return [moved.get((0, j), Fraction(0)) for j in range(len(p))]


def _terms(value: Any) -> Terms:
    out: Terms = {}
    for term in listed(value, 200, "an entry"):
        need(len(listed(term, 3, "a term")) == 3, "a term is [i, j, c]")
        key = whole(term[0], 0, 32), whole(term[1], 0, 32)
        need(key not in out, "a term is there twice")
        out[key] = rational(term[2])
    return {k: c for k, c in out.items() if c}


def _scaled(p: Terms, k: int, m: int) -> tuple[Terms, int]:
    """p(zq^γ, q) = q^{a/m}·Σ z^i τ^…, τ = q^{−1/m}: the sum and a. Terms are of p and q."""
    a = max(k * i + m * j for i, j in p)
    return {(i, a - k * i - m * j): c for (i, j), c in p.items()}, a


def root_bounds(X: Fraction, k: int, m: int) -> tuple[Fraction, Fraction]:
    """Bounds of X^{k/m}, X > 0."""
    target, unit = X**k, 1 << 80
    while target * unit**m < 1 << 80 * m:
        unit <<= 80
    scaled = target * unit**m
    low, high = 0, 1 << (int(scaled).bit_length() // m + 2)
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**m <= scaled else (low, middle)
    return Fraction(low, unit), Fraction(high, unit)


def _edges(d: Terms, n: Terms, v: Fraction, slow: bool) -> None:
    """The test on each edge of Newton's polygon of d(·, σ), σ → ∞; slow: in s and σ, slopes below 1 only."""
    need(any(i == 0 for i, _ in d), "a p-root is 0 for all σ")
    top = {i: max(j for k, j in d if k == i) for i, _ in d}
    at, last = 0, max(top)
    while at < last:
        steepest = max(Fraction(top[i] - top[at], i - at) for i in top if i > at)
        end = max(i for i in top if i > at and Fraction(top[i] - top[at], i - at) == steepest)
        theta = -steepest
        value = top[at] + theta * at
        if not (slow and theta >= 1):
            edge = [
                d.get((i, int(value - theta * i)), Fraction(0))
                if (value - theta * i).denominator == 1
                else Fraction(0)
                for i in range(at, end + 1)
            ]
            if theta == 1 and v and not slow:
                times = 0
                while len(edge) > 1 and x.value(edge, 1 / v) == 0:
                    edge, times = x.divide(edge, [Fraction(1), -v])[0], times + 1
                if times:
                    chart: Terms = {(1, 0): -1 / v, (0, 1): 1 / v}
                    back: Terms = {(1, 0): Fraction(1)}
                    original = {(0, 1): Fraction(1), (1, 0): v}  # σ = s + vP, written in P and s
                    D, N = (x.replaced(p, {(1, 0): Fraction(1)}, original) for p in (d, n))
                    _edges(x.replaced(D, chart, back), x.replaced(N, chart, back), v, True)
            edge = x.trimmed(edge)
            if len(edge) > 1:
                need(len(x.gcd(edge, x.derivative(edge))) == 1, "p-roots are alike at infinity")
                if max(theta * i + j for i, j in n) - (value - theta) >= 0:
                    raise NotCheckedError("the receptance is not shown to fall at infinity")
        at = end


class Vehicle:
    """M, C, K, B, places, compliances; and that they are a passive vehicle."""

    def __init__(self, value: Any) -> None:
        keys(value, {"M", "C", "K", "B", "places", "compliances"}, "the vehicle")
        n = self.bodies = len(listed(value["M"], 64, "M"))
        self.places = [rational(p) for p in listed(value["places"], 64, "places")]
        c = self.contacts = len(self.places)
        need(n >= 1 and c >= 1, "no body or no contact")
        self.M, self.C, self.K = (matrix(value[k], n, n, k) for k in "MCK")
        self.B = matrix(value["B"], n, c, "B")
        self.h = [rational(p) for p in listed(value["compliances"], 64, "compliances")]
        need(len(self.h) == c and all(h >= 0 for h in self.h), "compliances")
        need(all(x.semidefinite(A) for A in (self.M, self.C, self.K)), "M, C or K is not positive semidefinite")
        both = [[self.M[i][j] + self.C[i][j] + self.K[i][j] for j in range(n)] for i in range(n)]
        need(x.rank(both) == n, "a body has neither mass, damper nor spring")
        sites = sorted(set(self.places))
        rows = [
            *self.B,
            *([self.h[i] if i == j else Fraction(0) for j in range(c)] for i in range(c)),
            *([Fraction(p == site) for p in self.places] for site in sites),
        ]
        need(x.rank([list(row) for row in rows]) == c, "two rigid contacts at one place share a force")
        self.sites = sites
        gaps = [q - p for p, q in itertools.pairwise(sites)]
        self.gap = min(gaps) if gaps else None
