"""Counts the frequencies of a region: follows the paths of the file in pieces of its own, finer where needed."""

from __future__ import annotations

import itertools
from fractions import Fraction
from typing import Any

import balls as b
from balls import ONE, PI, ZERO, Ball, UnclearError, arg, ball
from reading import NotCheckedError, Path, Point, along, need, rational
from taylor import Line, constant, determinant, near_one, solve
from track import Track, Vehicle
from waves import THIN, WIDE, Thin, Waves, sigma

DEEPEST = 14
"""A piece is halved so often, then it stays unclear."""


class Walk:
    """Paths of one problem; knows the p-roots at the ends of those that were gone."""

    def __init__(self, track: Track, vehicle: Vehicle) -> None:
        self.track, self.vehicle, self.waves = track, vehicle, Waves(track)
        self.ends: dict[Point, Thin] = {}
        self.pieces = 0
        places = vehicle.places
        self.gaps = sorted({p - q for p in places for q in places})

    def bordered(self, s: Any, G: dict[Fraction, Any], const: Any) -> list[list[Any]]:
        """[[S, −B], [Bᵀ, G + h]] at s = σ, in balls or lines."""
        v = self.vehicle
        n, c, square = v.bodies, v.contacts, s * s
        rows = []
        for i in range(n):
            S = [const(v.K[i][j]) + const(v.C[i][j]) * s + const(v.M[i][j]) * square for j in range(n)]
            rows.append(S + [const(-v.B[i][j]) for j in range(c)])
        for i in range(c):
            gaps = [G[v.places[i] - v.places[j]] for j in range(c)]
            rows.append(
                [const(v.B[j][i]) for j in range(n)]
                + [g + const(v.h[i] if i == j else 0) for j, g in enumerate(gaps)]
            )
        return rows

    def value(self, thin: Thin) -> Ball:
        """Δ at a point."""
        return determinant(self.bordered(thin.at, self.waves.receptances(thin, self.gaps), ball))

    def enter(self, link: list[Point]) -> None:
        """The sides at the link's end: by the signs of Re P if none is 0 there, else along the link.

        No p-root is imaginary in H, so that signs last to its boundary.
        """
        at = sigma(link[-1])
        try:
            self.ends[link[-1]] = self.waves.start(at)
        except UnclearError:
            self.ends[link[0]] = self.waves.start(sigma(link[0]))
            self.go(link, "link")

    def go(self, points: list[Point], kind: str) -> int:
        """Along the points; the change of arg Δ for a turn (units of 2^−FIXED), its error added to self.error."""
        thin = self.ends.get(points[0])
        if thin is None:
            raise NotCheckedError("a path begins where none ended")
        self.turned, self.error = 0, 0
        value = self.value(thin) if kind == "turn" else ONE
        for here, q in itertools.pairwise(points):
            thin, value = self.step(thin, value, here, q, kind)
        self.ends[points[-1]] = thin
        return self.turned

    def step(self, thin: Thin, value: Ball, here: Point, end: Point, kind: str) -> tuple[Thin, Ball]:
        """One piece of the file, halved where it must be."""
        todo = [(end, 0)]
        while todo:
            q, depth = todo.pop()
            try:
                thin, value = self.piece(thin, value, here, q, kind)
                here = q
            except UnclearError as error:
                if depth >= DEEPEST:
                    raise NotCheckedError(
                        f"a piece of a {kind} near q = {float(q[0]):.6g} + {float(q[1]):.6g}i: {error}"
                    ) from None
                todo += [(q, depth + 1), (((here[0] + q[0]) / 2, (here[1] + q[1]) / 2), depth + 1)]
        return thin, value

    def piece(self, thin: Thin, value: Ball, begin: Point, end: Point, kind: str) -> tuple[Thin, Ball]:
        """One piece, or UnclearError."""
        self.pieces += 1
        last, lines, at, r = self.waves.follow(thin, end)
        if kind == "link":
            return last, value
        before = b.set_bits(WIDE)
        try:
            G = self.waves.receptance_lines(lines, sum(thin.upper), at, r, self.gaps)
            if kind == "turn":
                self.not_zero(G, at, r)
            else:
                self.passive(G, at, r, begin, end)
        finally:
            b.set_bits(before)
        if kind != "turn":
            return last, value
        new = self.value(last)
        angle, error = arg(new / value)
        self.turned, self.error = self.turned + angle, self.error + error
        return last, new

    def not_zero(self, G: dict[Fraction, Line], at: Ball, r: float) -> None:
        """|det RA − 1| < 1 on the disc: arg Δ turns by less than π between any two points, by the principal value."""
        s = Line(at, ONE, 0.0, r)
        A = self.bordered(s, G, lambda c: constant(ball(c), r))
        n = len(A)
        R = solve(
            [[e.a.mid() for e in row] for row in A], [[ONE if i == j else ZERO for j in range(n)] for i in range(n)]
        )
        RA = [[_sum([A[k][j].times(R[i][k]) for k in range(n)]) for j in range(n)] for i in range(n)]
        if not near_one(RA, r) < 1:
            raise UnclearError("the determinant may be 0")

    def passive(self, G: dict[Fraction, Line], at: Ball, r: float, begin: Point, end: Point) -> None:
        """The Hermitian part of σG over the places is positive definite on the segment: X·herm·X* is near 1."""
        sites = self.vehicle.sites
        n, s = len(sites), Line(at, ONE, 0.0, r)
        half = ball(Fraction(1, 2))
        step = ball(-(end[1] - begin[1]) / 2, (end[0] - begin[0]) / 2)  # t = τ·step, −1 ≤ τ ≤ 1
        middle = ball(-(end[1] + begin[1]) / 2, (end[0] + begin[0]) / 2) - at
        V = [[s * G[p - q] for q in sites] for p in sites]
        H0 = [[(_at(V[i][j], middle) + _at(V[j][i], middle).conj()) * half for j in range(n)] for i in range(n)]
        H1 = [[(V[i][j].b * step + (V[j][i].b * step).conj()) * half for j in range(n)] for i in range(n)]
        Q = [[(V[i][j].rest + V[j][i].rest) / 2 * (1 + 2.0**-40) for j in range(n)] for i in range(n)]
        X = _inverse_factor([[e.complex() for e in row] for row in H0])
        size = [[e.upper() for e in row] for row in X]
        for i in range(n):
            total = 0.0
            for j in range(n):
                pairs = [(k, m) for k in range(n) for m in range(n)]
                zero = _sum([X[i][k] * H0[k][m] * X[j][m].conj() for k, m in pairs]) - (ONE if i == j else ZERO)
                one = _sum([X[i][k] * H1[k][m] * X[j][m].conj() for k, m in pairs])
                total += (
                    zero.upper()
                    + one.upper()
                    + sum(size[i][k] * Q[k][m] * size[j][m] for k, m in pairs) * (1 + 2.0**-40)
                )
            if not b.up(total) < 1:
                raise UnclearError("the track may feed in")

    def accretive(self, thin: Thin) -> tuple[int, int]:
        """α of section 5 at a point: the sum of Arg of the pivots of [[S/σ, −B], [Bᵀ, σ(G + h)]], contacts first."""
        v, s = self.vehicle, thin.at
        A = self.bordered(s, self.waves.receptances(thin, self.gaps), ball)
        n, over = v.bodies, s.inverse()
        A = [[e * over for e in row[:n]] + row[n:] for row in A[:n]] + [
            row[:n] + [e * s for e in row[n:]] for row in A[n:]
        ]
        for order in (list(range(n, len(A))) + list(range(n)), list(range(len(A)))):
            try:
                return _pivot_args([[A[i][j] for j in order] for i in order])
            except UnclearError:
                continue
        raise NotCheckedError("pivots at the end of the turn may be 0")


def _at(line: Line, t: Ball) -> Ball:
    return line.a + line.b * t


def _sum(values: list[Any]) -> Any:
    out = values[0]
    for value in values[1:]:
        out = out + value
    return out


def _pivot_args(A: list[list[Ball]]) -> tuple[int, int]:
    total, error = 0, 0
    for k in range(len(A)):
        angle, wrong = arg(A[k][k])
        if not abs(angle) <= PI // 2 + wrong + 4:
            raise UnclearError("a pivot of an accretive matrix is not in the right half-plane")
        total, error = total + angle, error + wrong
        over = A[k][k].inverse()
        for i in range(k + 1, len(A)):
            factor = A[i][k] * over
            A[i] = [x - factor * y if j > k else x for j, (x, y) in enumerate(zip(A[i], A[k], strict=True))]
    return total, error


def _inverse_factor(H: list[list[complex]]) -> list[list[Ball]]:
    """X with X·H·X* near 1, from a float Cholesky factor."""
    n = len(H)
    L = [[0j] * n for _ in range(n)]
    for i in range(n):
        for j in range(i + 1):
            rest = H[i][j] - sum(L[i][k] * L[j][k].conjugate() for k in range(j))
            if i == j:
                if not rest.real > 0:
                    raise UnclearError("the track may feed in")
                L[i][i] = complex(rest.real**0.5)
            else:
                L[i][j] = rest / L[j][j]
    X = [[0j] * n for _ in range(n)]
    for j in range(n):
        for i in range(j, n):
            X[i][j] = ((1 if i == j else 0) - sum(L[i][k] * X[k][j] for k in range(j, i))) / L[i][i]
    return [[b.from_complex(e) for e in row] for row in X]


def count(walk: Walk, region: dict[str, Any], paths: list[Path], theorem: Any, start: Fraction) -> int:
    """The number of frequencies that the paths prove (section 5)."""
    kind, zero = region["kind"], Fraction(0)
    kinds = [p.kind for p in paths]
    b.set_bits(THIN)
    begin = (zero, -start)
    need(start > 0, "the start")
    if kind in ("unstable", "below"):
        return _half_plane(walk, region, paths, kinds, theorem, begin)
    if kind != "rectangle":
        raise NotCheckedError(f"the region {kind!r}")
    (x0, x1), (y0, y1) = ([rational(c) for c in region[k]] for k in ("re", "im"))
    corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]
    if theorem is not None:
        raise NotCheckedError("a rectangle beside the cuts (section 8.6)")
    need(kinds == ["link", "turn"] and along(paths[1].points, corners), "the turn is not round the rectangle")
    need(paths[0].points[0] == begin and paths[0].points[-1] == corners[0], "the link")
    need(all(q[1] <= max(y1, zero) for q in paths[0].points), "the link leaves the region of the premise")
    walk.enter(paths[0].points)
    return whole_number(walk.go(paths[1].points, "turn"), walk.error, 2 * PI)


def _half_plane(
    walk: Walk, region: dict[str, Any], paths: list[Path], kinds: list[str], theorem: Any, begin: Point
) -> int:
    zero, vehicle = Fraction(0), walk.vehicle
    if walk.track.v == 0:
        raise NotCheckedError("a load at rest")
    need(kinds == ["link", "turn", "passive", "passive"], "the paths are not those of the region")
    link, turn, walls, axis = (p.points for p in paths)
    rho = turn[-1][0]
    if region["kind"] == "unstable":
        corners, h = [(zero, zero), (rho, zero)], zero
    else:
        h = rational(region["height"])
        need(h > 0 and rho == rational(region["reach"]), "the reach is not where the turn ends")
        corners = [(zero, h), (rho, h), (rho, zero)]
    need(rho > 0 and along(turn, corners), "the turn is not along its polygon")
    need(link[0] == begin and link[-1] == corners[0] and all(q[1] <= h for q in link), "the link")
    depth = -walls[-1][1]
    need(depth > 0 and along(walls, [(rho, zero), (rho, -depth), (zero, -depth)]), "the walls")
    X = axis[-1][0]
    need(axis == [(rho, zero)] or (rho < X and along(axis, [(rho, zero), (X, zero)])), "the axis beyond the turn")
    walk.track.check_passive_at_rest()
    walk.track.check_decay()
    walk.track.check_far(theorem, X, vehicle.gap)
    walk.enter(link)
    T = walk.go(turn, "turn")
    error = walk.error
    A, wrong = walk.accretive(walk.ends[turn[-1]])
    walk.go(walls, "passive")
    if len(axis) > 1:
        walk.go(axis, "passive")
    whole = A + (vehicle.bodies - vehicle.contacts) * PI // 2 - T
    return whole_number(whole, error + wrong + 100, PI)


def whole_number(turned: int, error: int, unit: int) -> int:
    """The one integer in turned/unit ± error/unit, or NotCheckedError."""
    error += (abs(turned) // unit + 2) * 2**16
    low, high = -((error - turned) // unit), (turned + error) // unit
    if low > high:
        raise NotCheckedError("no whole number is in the angle")
    if low < high:
        raise NotCheckedError("the angle does not tell the number")
    return low
