"""The whole sheet of masses or vehicles on a beam whose cuts lie on one line: section 8 of SPEC2.md."""

from __future__ import annotations

import copy
from fractions import Fraction
from itertools import pairwise
from typing import Any

import balls as b
import exact as x
from balls import PI
from counting import Walk, whole_number
from far import check_far
from reading import NotCheckedError, Path, Point, dyadic, keys, listed, need, point
from track import Track, Vehicle
from waves import THIN, Thin, linked

ZERO = Fraction(0)


class Beam:
    """EI P⁴ + T P² + k' + m(τ − vP)², the cuts' height η, and the vehicles below and above that line."""

    def __init__(self, track: Track, vehicle: Vehicle) -> None:
        if len(track.A) != 1 or not set(track.D) <= {(4, 0), (2, 0), (0, 0), (0, 1), (0, 2)}:
            raise NotCheckedError("a sheet of a track that is no beam")
        get = track.D.get
        self.EI, self.T, self.m, self.v = get((4, 0), ZERO), get((2, 0), ZERO), get((0, 2), ZERO), track.v
        c, k = get((0, 1), ZERO), get((0, 0), ZERO)
        need(self.EI > 0 and self.m > 0 and c >= 0, "the beam's stiffness, mass or damping")
        self.eta, self.k = c / (2 * self.m), k - c * c / (4 * self.m)
        need(x.positive([self.k, -self.T, self.EI]), "the cuts do not lie on one line")
        terms = [[4, 0, str(self.EI)], [2, 0, str(self.T)], [0, 0, str(self.k)], [0, 2, str(self.m)]]
        self.track = Track({"matrix": [[terms]], "loaded": 0}, self.v)
        self.lower, self.upper = copy.copy(vehicle), copy.copy(vehicle)
        n, eta = vehicle.bodies, self.eta
        both = [(i, j) for i in range(n) for j in range(n)]
        C, K = [[ZERO] * n for _ in range(n)], [[ZERO] * n for _ in range(n)]
        for i, j in both:
            C[i][j] = vehicle.C[i][j] - 2 * eta * vehicle.M[i][j]
            K[i][j] = vehicle.K[i][j] - eta * vehicle.C[i][j] + eta * eta * vehicle.M[i][j]
        self.lower.C, self.lower.K, self.upper.K = C, K, K
        self.upper.C = [[-entry for entry in row] for row in C]
        need(x.semidefinite(self.upper.C) and x.semidefinite(K), "the vehicle is not passive above the cuts")

    def passive_beyond(self, e: Fraction) -> bool:
        """8.2: the bracket at |τ| = e."""
        return x.nonnegative([self.k + self.m * e * e, -self.T - self.m * self.v**2, self.EI])

    def in_gap(self, z: Fraction) -> bool:
        """D̃(ip, iz) > 0 for all real p: on both halves p ≥ 0 and p ≤ 0."""
        m, v = self.m, self.v
        rows = [[self.k - m * z * z, s * 2 * m * z * v, -self.T - m * v * v, ZERO, self.EI] for s in (1, -1)]
        return all(x.positive([Fraction(c) for c in row]) for row in rows)

    def discriminant(self) -> x.Poly:
        """That of D̃/EI in P, a polynomial of w = z² = −τ²."""
        p: x.Poly = [(self.T + self.m * self.v**2) / self.EI]
        qq: x.Poly = [ZERO, -4 * (self.m * self.v / self.EI) ** 2]
        r: x.Poly = [self.k / self.EI, -self.m / self.EI]
        out = [ZERO] * 4
        parts = [
            (16, [p, p, p, p, r]),
            (-4, [p, p, p, qq]),
            (-128, [p, p, r, r]),
            (144, [p, qq, r]),
            (-27, [qq, qq]),
            (256, [r, r, r]),
        ]
        for factor, rows in parts:
            term: x.Poly = [Fraction(factor)]
            for row in rows:
                term = x.product(term, row)
            for i, c in enumerate(term):
                out[i] += c
        return x.trimmed(out)


def check_passive(track: Track, vehicle: Vehicle, paths: list[Path]) -> None:
    """8.8: an undamped beam that is passive at all frequencies lets no passive vehicle grow."""
    bare = copy.copy(vehicle)  # dampers of the vehicle do no harm here
    bare.C = [[ZERO] * vehicle.bodies for _ in range(vehicle.bodies)]
    beam = Beam(track, bare)
    need(not paths and beam.eta == 0 and beam.passive_beyond(ZERO), "the beam is not passive at all frequencies")


class Loop:
    """A polygon round one branch point."""

    def __init__(self, value: Any, beam: Beam) -> None:
        keys(value, {"centre", "radius", "points"}, "a loop")
        self.centre, self.radius = dyadic(value["centre"]), dyadic(value["radius"])
        self.points = [point(p) for p in listed(value["points"], 2000, "a loop's points")]
        need(0 < self.radius < self.centre and len(self.points) > 4, "a loop's disc")
        inside = all((u - self.centre) ** 2 + w * w <= self.radius**2 for u, w in self.points)
        need(inside and self.points[0] == self.points[-1], "a loop leaves its disc, or is open")
        self.back = next((k for k, p in enumerate(self.points) if k and p[1] == 0), 0)
        below = all(w < 0 for _, w in self.points[1 : self.back])
        need(self.points[0][1] == 0 and self.back > 1 and below, "a loop does not begin below the axis")
        self.multiplicity = self._branch_point(beam)

    def _branch_point(self, beam: Beam) -> int:
        w = beam.discriminant()
        z = [c for pair in zip(w, [ZERO] * len(w), strict=True) for c in pair]
        moved = x.replaced({(k, 0): c for k, c in enumerate(z) if c}, {(1, 0): Fraction(1), (0, 0): self.centre}, {})
        sizes = [abs(moved.get((k, 0), ZERO)) * self.radius**k for k in range(len(z))]
        k = max(range(len(sizes)), key=lambda i: sizes[i])
        need(2 * sizes[k] > sum(sizes), "the roots of the discriminant in a loop's disc cannot be counted")  # Pellet
        fourfold = k == 3 and beam.v == 0 == beam.T  # the discriminant is 256 r³
        if k != 1 and not fourfold:
            raise NotCheckedError(f"a loop round a branch point of multiplicity {k}")
        self.rounds = 4 if fourfold else 2
        low, high = self.centre - self.radius, self.centre + self.radius
        sign = x.value(z, low) > 0
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if (x.value(z, middle) > 0) == sign else (low, middle)
        turned = 0
        for p, q in pairwise(self.points):
            for at in (low, high):
                cross = (p[0] - at) * (q[1] - p[1]) - p[1] * (q[0] - p[0])
                need(cross > 0, "a loop does not turn counterclockwise")
            ahead = q[0] > high and p[1] < 0 <= q[1]  # each round passes the axis once to the right
            turned += ahead
        need(turned == self.rounds, "a loop does not go round as often as it should")
        one = (len(self.points) - 1) // self.rounds
        each = [self.points[i * one : (i + 1) * one + 1] for i in range(self.rounds)]
        need(len(self.points) == one * self.rounds + 1 and all(r == each[0] for r in each), "rounds of a loop differ")
        return k


def _round(walk: Walk, loop: Loop) -> tuple[int, int]:
    """Follow the loop; the change of arg up to where it is back on the axis, and its error."""
    first = walk.ends[loop.points[0]]
    turned, error = walk.go(loop.points[: loop.back + 1], "turn"), walk.error
    back = walk.ends[loop.points[loop.back]]
    rest = walk.go(loop.points[loop.back :], "turn")
    last: Thin = walk.ends[loop.points[0]]
    need(linked(first.roots, first.upper, last.roots) == last.upper, "the waves do not come back after a loop")
    times = whole_number(turned + rest, error + walk.error, 2 * PI)
    sites = len(walk.vehicle.sites)
    kappa = 1 if loop.multiplicity == 1 else 3 if sites == 1 else 4
    need(times == -kappa, "the argument turns otherwise round a loop")
    walk.ends[loop.points[loop.back]] = back
    return turned, error


def _chain(walk: Walk, paths: list[Path], loops: list[Loop], begin: Point, start: Fraction) -> tuple[int, int]:
    """Link, turns and loops; the change of arg along them and its error. The last turn is what the caller checks."""
    need([p.kind for p in paths] == ["link"] + ["turn"] * (len(loops) + 1), "the paths of a chain")
    link = paths[0].points
    need(link[0] == (ZERO, -start) and link[-1] == begin and all(w <= 0 for _, w in link), "a link")
    walk.enter(link)
    turned = error = 0
    at = begin
    for k, path in enumerate(paths[1:]):
        need(path.points[0] == at, "a turn begins elsewhere")
        turned, error = turned + walk.go(path.points, "turn"), error + walk.error
        if k < len(loops):
            need(path.points[-1] == loops[k].points[0] and all(w == 0 for _, w in path.points), "a turn's end")
            more, lost = _round(walk, loops[k])
            turned, error, at = turned + more, error + lost, loops[k].points[loops[k].back]
    return turned, error


def count_sheet(track: Track, vehicle: Vehicle, paths: list[Path], theorem: Any, start: Fraction) -> tuple[int, int]:
    """The number of frequencies on the sheet, and of pieces."""
    b.set_bits(THIN)
    if "rest" in theorem:
        raise NotCheckedError("the count on the whole sheet, as its way past the branch points is that at rest")
    keys(theorem, {"begin", "end", "lower", "upper"}, "the theorem")
    beam = Beam(track, vehicle)
    s, e = dyadic(theorem["begin"]), dyadic(theorem["end"])
    lower, upper = ([Loop(v, beam) for v in listed(theorem[k], 20, "loops")] for k in ("lower", "upper"))
    need(0 <= s <= e and (s == 0 or beam.in_gap(s)), "the count does not begin in the gap")
    need(beam.passive_beyond(e) and start > 0, "the sheet is not passive where the count closes")
    damped, begin, end = beam.eta > 0, (s, ZERO), (e, ZERO)
    walks = [Walk(beam.track, beam.lower), Walk(beam.track, beam.upper)]
    two = damped and e > s
    one = len(paths) - (len(upper) + 2 if two else 0)
    need(two or not upper, "loops without a path")
    turned, error = _chain(walks[0], paths[:one], lower, begin, start)
    last = paths[one - 1].points
    need(all(w == 0 for _, w in last), "a turn leaves the edge")
    if damped:
        more, lost = check_far(beam, last[-1][0], walks[0].waves, walks[0].ends[last[-1]])
        turned, error = turned + more, error + lost
    else:
        need(not any(map(any, vehicle.C)), "an undamped sheet has no dampers")
        need(last[-1] == end and not beam.in_gap(e), "the turn's end")
    if two:
        more, lost = _chain(walks[1], paths[one:], upper, begin, start)
        turned, error = turned + more, error + lost
        edge = paths[-1].points
        need(edge[-1] == end and all(w == 0 for _, w in edge), "the upper turn's end")
    elif damped:
        walks[1].ends[end] = walks[0].ends[begin]
    else:
        walks[1] = walks[0]
    A, wrong = walks[1].accretive(walks[1].ends[end])
    whole = A + (vehicle.bodies - vehicle.contacts) * PI // 2 - turned
    number = whole_number(whole, error + wrong + 100, PI) * (1 if damped else 2)
    return number, walks[0].pieces + (walks[1].pieces if walks[1] is not walks[0] else 0)
