"""The balls of the roots: disjoint, inside the region, with exactly the roots that they claim (section 7)."""

from __future__ import annotations

import re
from fractions import Fraction
from typing import Any

import balls as b
from balls import ONE, Ball, UnclearError, ball
from counting import Walk
from reading import NotCheckedError, keys, listed, need, rational, whole
from taylor import Line, constant
from waves import Thin

HEX = re.compile(r"-?0x[0-9a-f]{1,18000}", re.ASCII)


class Root:
    """|q − (x + iy)| ≤ r holds `multiplicity` roots; a pair has a mirror −q̄ too."""

    def __init__(self, value: Any) -> None:
        keys(value, {"re", "im", "exponent", "radius", "multiplicity", "pair"}, "a root")
        unit = Fraction(2) ** whole(value["exponent"], -70000, 1100)
        for k in ("re", "im"):
            need(isinstance(value[k], str) and HEX.fullmatch(value[k]) is not None, "a root's mantissa")
        self.x, self.y = int(value["re"], 16) * unit, int(value["im"], 16) * unit
        radius = listed(value["radius"], 2, "a radius")
        need(len(radius) == 2, "a radius is [m, e]")
        self.r = whole(radius[0], 1, 2**64) * Fraction(2) ** whole(radius[1], -70000, 1100)
        self.multiplicity = whole(value["multiplicity"], 1, 1000)
        need(type(value["pair"]) is bool, "pair is true or false")
        self.pair = value["pair"]
        need(self.r > 0, "a radius is not positive")
        need(self.x > self.r if self.pair else True, "a pair's ball reaches its mirror")


def check_places(roots: list[Root], region: dict[str, Any], undamped: bool = False) -> tuple[int, int]:
    """The numbers of roots, all and unstable, of balls that are disjoint and inside."""
    seen: list[tuple[Fraction, Fraction, Fraction]] = []
    total = unstable = 0
    for root in roots:
        times = root.multiplicity * (2 if root.pair else 1)
        total += times
        below, above = root.y + root.r < 0, root.y - root.r > 0
        real = undamped and root.y == 0 and root.multiplicity == 1
        need(below or above or real, "a ball meets the real axis")
        unstable += times if below else 0
        if region["kind"] == "rectangle":
            (x0, x1), (y0, y1) = ([rational(c) for c in region[k]] for k in ("re", "im"))
            fits = x0 < root.x - root.r and root.x + root.r < x1 and y0 < root.y - root.r and root.y + root.r < y1
            need(fits and not root.pair, "a ball is not inside the rectangle")
        else:
            need(root.pair or root.x == 0, "a ball without mirror is not on the imaginary axis")
            need(below or region["kind"] in ("below", "below disc", "sheet"), "a ball is not inside the region")
            if above and region["kind"] == "below":
                height, reach = rational(region["height"]), rational(region["reach"])
                need(root.y + root.r < height and root.x + root.r < reach, "a ball is not inside the region")
        for x in (root.x, -root.x) if root.pair else (root.x,):
            for u, w, r in seen:
                need((x - u) ** 2 + (root.y - w) ** 2 > (root.r + r) ** 2, "two balls meet")
            seen.append((x, root.y, root.r))
    return total, unstable


def check_root(walk: Walk, root: Root) -> None:
    """One simple root in its ball: δ = det of RA, one line a + bt + e of it, |a| + rest < |b|·r (Rouché)."""
    if root.multiplicity != 1:
        raise NotCheckedError("a multiple root")
    digits = max(0, root.r.denominator.bit_length() - root.r.numerator.bit_length())
    if digits > 400:
        raise NotCheckedError("a root of more than a hundred digits")
    before = b.set_bits(min(470, digits + 160))
    try:
        _one(walk, root)
    except UnclearError as error:
        raise NotCheckedError(f"a root near q = {float(root.x):.6g} + {float(root.y):.6g}i: {error}") from None
    finally:
        b.set_bits(before)


def _one(walk: Walk, root: Root) -> None:
    at, r = ball(-root.y, root.x), float(root.r) * (1 + 2.0**-40)
    waves = walk.waves
    roots = waves.thin(at, waves.guesses(at.complex(), None))
    lines = waves.enclosed(at, r, [y.mid() for y in roots], [_slope(walk, at, y) for y in roots])
    upper = [sign < 0 for sign in waves.signs([line.a.wide(line.spread()) for line in lines])]
    order = sorted(range(len(lines)), key=lambda k: not upper[k])
    G = waves.receptance_lines([lines[k] for k in order], sum(upper), at, r, walk.gaps)
    A = walk.bordered(Line(at, ONE, 0.0, r), G, lambda c: constant(ball(c), r))
    delta = eliminated(A)
    thin = Thin(at, roots, [sign < 0 for sign in waves.signs(roots)])
    for gap, exact in waves.receptances(thin, walk.gaps).items():
        need(not (exact - G[gap].a.wide(G[gap].rest)).lower() > 0, "two ways to the receptance differ")
    low = delta.b.lower() * float(root.r) * (1 - 2.0**-40)
    if not b.up(delta.a.upper() + delta.rest) < low:
        raise UnclearError("the ball does not show exactly one root")


def _slope(walk: Walk, at: Ball, y: Ball) -> Ball:
    from waves import horner

    D, _ = walk.waves.balls()
    zero = ball(0)
    along = horner([horner([c * ball(j) for j, c in enumerate(row)][1:], at, zero) for row in D], y, zero)
    across = horner([horner(row, at, zero) * ball(i) for i, row in enumerate(D)][1:], y, zero)
    slope: Ball = -(along / across).mid()
    return slope


def eliminated(A: list[list[Line]]) -> Line:
    """Δ over a constant ≠ 0 and over pivots that are not 0 on the disc: full pivoting, the last entry is left."""
    A = [list(row) for row in A]
    n = len(A)
    for k in range(n - 1):
        scale = [max(e.a.upper() for e in row[k:]) or 1.0 for row in A]
        i, j = max(
            ((i, j) for i in range(k, n) for j in range(k, n)), key=lambda c: A[c[0]][c[1]].lower() / scale[c[0]]
        )
        A[k], A[i] = A[i], A[k]
        for row in A:
            row[k], row[j] = row[j], row[k]
        over = A[k][k].inverse()
        for m in range(k + 1, n):
            factor = A[m][k] * over
            A[m] = [x - factor * y if c > k else x for c, (x, y) in enumerate(zip(A[m], A[k], strict=True))]
    return A[-1][-1]
