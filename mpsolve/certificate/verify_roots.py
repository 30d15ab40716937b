"""Checks certificates of zeros of analytic functions against certs/SPEC-ROOTS.md; shares no code with their maker.

Needs Python ≥ 3.11 and python-flint, and verify2.py beside it, which reads and judges. Runs as a plain script:
python verify_roots.py FILE [FILE …]
Exit status 0: every file is valid; 1: one is not, and its line says why.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Any

import flint
from flint import acb, acb_series, arb, fmpq

if __package__:
    from mpsolve.certificate import verify2 as spectra
else:
    import verify2 as spectra  # type: ignore[import-not-found,no-redef]

Refused, Verdict = spectra.Refused, spectra.Verdict
require, keys, items, integer = spectra.require, spectra.keys, spectra.items, spectra.integer

MAX_BYTES, MAX_STEPS, MAX_POWER, MAX_ROOTS, MAX_CORNERS, MAX_CUTS = 32_000_000, 5_000, 10_000, 5_000, 256, 16
MAX_PIECES, MAX_WORK, MAX_BITS, MAX_MULTIPLICITY = 400_000, 4e8, 140_000, 4_000
HALF = fmpq(1, 2)
MOST_TERMS = 15  # zeros of one factor that meet

Point = tuple[Any, Any]
LEAVES, OPERATIONS, CUT = ("z", "number", "i", "pi"), ("add", "sub", "mul", "div"), ("log", "sqrt")
FUNCTIONS = ("exp", "log", "sqrt", "sin", "cos", "sinh", "cosh", "atan", "rgamma", "erf", "airy_ai", "airy_bi")
SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


class Undecided(spectra.Refused):
    """Balls do not decide a step."""


KEYS = {
    "region": "function claim region counted cuts bits breaks trees roots",
    "interval": "function claim interval tiles",
}
precision = partial(spectra.precision, terms=MOST_TERMS + 2)
rational = partial(spectra.rational, digits=400)


def verify(path: Any) -> spectra.Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    return spectra.of_file(path, verify_bytes, MAX_BYTES)


def verify_bytes(raw: bytes) -> spectra.Verdict:
    """The verdict on a certificate's bytes. Never raises for what they hold."""
    return spectra.judged(raw, lambda: checked(spectra.opened(raw, KEYS, "mpsolve zeros", 1)), MAX_BYTES)


def checked(content: dict[str, Any]) -> str:
    with precision(64):
        return interval(content) if content["kind"] == "interval" else region(content)


def point(value: Any, name: str) -> Point:
    x, y = items(value, 2, name, 2)
    return rational(x, name), rational(y, name)


# --- the function -----------------------------------------------------------------------------------------


def read_steps(value: Any) -> list[tuple[Any, ...]]:
    """Steps, each of which takes earlier ones only."""
    steps: list[tuple[Any, ...]] = []
    for k, raw in enumerate(items(value, MAX_STEPS, "steps")):
        step = items(raw, 3, "a step")
        name, rest = step[0], step[1:]
        require(isinstance(name, str), "a step has no name")
        if name in LEAVES:
            rest = [rational(one, "a number") for one in rest]
            require(len(rest) == (name == "number"), "a leaf does not have the right parts")
        elif name in OPERATIONS:
            rest = [integer(one, 0, k - 1, "an earlier step") for one in items(rest, 2, name, 2)]
        elif name in FUNCTIONS:
            rest = [integer(one, 0, k - 1, "an earlier step") for one in items(rest, 1, name, 1)]
        else:
            require(name in ("pow", "bessel_j", "hyp0f1") and len(rest) == 2, f"the step {name[:40]} is not known")
            rest[0] = integer(rest[0], 0, k - 1, "an earlier step")
            if name == "pow":
                rest[1] = integer(rest[1], 1, MAX_POWER, "a power")
            elif name == "bessel_j":
                rest[1] = integer(rest[1], -1000, 1000, "an order")
            else:
                rest[1] = rational(rest[1], "a parameter")
                require(rest[1] > 0, "a parameter of hyp0f1 is not above 0")
        steps.append((name, *rest))
    return steps


def taken(step: tuple[Any, ...]) -> tuple[int, ...]:
    if step[0] in LEAVES:
        return ()
    return (step[1], step[2]) if step[0] in OPERATIONS else (step[1],)


def off_cut(w: Any) -> bool:
    """Whether a ball misses (−∞, 0]."""
    return bool(w.real > 0 or w.imag > 0 or w.imag < 0)


def first(value: Any) -> Any:
    return value[0] if isinstance(value, acb_series) else value


class Function:
    """One output of the steps, with the factors that its outermost steps make it of."""

    def __init__(self, steps: Sequence[tuple[Any, ...]], output: int) -> None:
        needed = {output}
        for k in range(output, -1, -1):
            needed |= set(taken(steps[k])) if k in needed else set()
        self.steps, self.output, self.needed = steps, output, sorted(needed)
        self.depends: dict[int, bool] = {}
        for k in self.needed:
            self.depends[k] = steps[k][0] == "z" or any(self.depends[j] for j in taken(steps[k]))
        self.guarded = any(self.is_guard(k) for k in self.needed)
        self.factors: dict[int, int] = {}
        self.constants: dict[int, dict[int, Any]] = {}
        self.split(output)

    def is_guard(self, k: int) -> bool:
        name = self.steps[k][0]
        return self.depends[k] and (name in (*CUT, "atan") or (name == "div" and self.depends[self.steps[k][2]]))

    def split(self, output: int) -> None:
        """f is a constant times the product of these factors; no constant factor or divisor may be 0."""
        stack, opened = [(output, 1)], 0
        while stack:
            (k, power), opened = stack.pop(), opened + 1
            step = self.steps[k]
            if not self.depends[k]:
                self.require_constant(k)
            elif step[0] == "mul":
                stack += [(step[2], power), (step[1], power)]
            elif step[0] == "pow":
                stack.append((step[1], power * step[2]))
            elif step[0] == "sub" and self.steps[step[1]] == ("number", fmpq(0)):
                stack.append((step[2], power))
            elif step[0] == "div" and not self.depends[step[2]]:
                self.require_constant(step[2])
                stack.append((step[1], power))
            else:
                self.factors[k] = self.factors.get(k, 0) + power
            require(opened <= 10 * MAX_STEPS and power <= MAX_POWER**2, "the function has too many factors")

    def require_constant(self, k: int) -> None:
        with precision(1024):
            value = self.ready()[k]
        require(value.is_finite() and value.abs_lower() > 0, "a constant factor of the function may be 0 or infinite")

    def ready(self) -> dict[int, Any]:
        bits = flint.ctx.prec
        if bits not in self.constants:
            values: dict[int, Any] = {}
            for k in self.needed:
                if not self.depends[k]:
                    values[k] = applied(self.steps[k], values, None, 1)
            self.constants[bits] = values
        return dict(self.constants[bits])

    def is_real(self) -> bool:
        """All steps are real for real z where they pass: a root or logarithm of a negative constant is complex."""
        own, values = [(k, self.steps[k]) for k in self.needed], self.ready()
        cut = [values[step[1]] for k, step in own if step[0] in CUT and not self.depends[k]]
        return all(step[0] != "i" for _, step in own) and all(w.real > 0 or w == 0 for w in cut)

    def run(self, z: Any, n: int) -> dict[int, Any]:
        """All steps over the ball z, as series of n terms in the offset from it."""
        values = self.ready()
        for k in self.needed:
            if self.depends[k]:
                values[k] = applied(self.steps[k], values, z, n)
        return values

    def sided(self, z: Any, line: Any, normal: Any, beyond: tuple[Any, Any] | None = None) -> dict[int, Any]:
        """All steps with slopes over z, a box beside the line, continued to it from the side of the normal."""
        values, on_line, tip = self.ready(), self.ready(), self.ready()
        for k in self.needed:
            step = self.steps[k]
            if not self.depends[k]:
                continue
            if step[0] in CUT:
                w, w_line = values[step[1]], on_line[step[1]]
                if beyond is not None:
                    require_beyond(w, tip[step[1]], beyond[1])
                    tip[k] = at_tip(step[0], tip[step[1]])
                values[k], on_line[k] = beside(step[0], w, w_line, normal, beyond is not None)
            else:
                values[k], on_line[k] = applied(step, values, z, 2), applied(step, on_line, line, 1)
                if beyond is not None:
                    tip[k] = applied(step, tip, beyond[0], 1)
        return values

    def parts(self, values: dict[int, Any], n: int) -> list[list[Any]]:
        """The first n Taylor coefficients of each factor; finite in the first."""
        out = [
            [values[k][j] for j in range(n)] if isinstance(values[k], acb_series) else [values[k]]
            for k in self.factors
        ]
        for row in out:
            decide(row[0].is_finite(), "the function is not finite on a ball")
        return out

    @property
    def shown(self) -> str:
        texts: dict[int, str] = {}
        for k in self.needed:
            name, *rest = self.steps[k]
            if name in LEAVES:
                text = str(rest[0]) if rest else name
                text = f"({text})" if "/" in text or "-" in text else text
            elif name in OPERATIONS:
                text = f"({texts[rest[0]]} {SIGN[name]} {texts[rest[1]]})"
            elif name == "pow":
                text = f"{texts[rest[0]]}**{rest[1]}"
            else:
                text = f"{name}({', '.join([texts[rest[0]], *map(str, rest[1:])])})"
            texts[k] = text if len(text) <= 400 else f"[step {k}]"
        return texts[self.output]


def decide(condition: Any, message: str) -> None:
    if not condition:
        raise Undecided(message)


def applied(step: tuple[Any, ...], values: dict[int, Any], z: Any, n: int) -> Any:
    name = step[0]
    if name == "z":
        return z if n == 1 else acb_series([z, 1], prec=n)
    if name in LEAVES:
        return acb(arb(step[1])) if name == "number" else acb(0, 1) if name == "i" else acb(arb.pi())
    a = values[step[1]]
    if name == "add":
        return a + values[step[2]]
    if name == "sub":
        return a - values[step[2]]
    if name == "mul":
        return a * values[step[2]]
    if name == "div":
        decide(first(values[step[2]]).abs_lower() > 0, "a denominator may vanish")
        return a / values[step[2]]
    if name == "pow":
        return a ** step[2]
    if name in CUT and z is not None:  # of a constant the principal value is meant, and nothing is to be analytic
        decide(off_cut(first(a)), f"{name} may meet its branch cut")
    if name == "atan" and z is not None:  # cuts on the imaginary axis, from ±i outwards
        w = first(a)
        decide(w.real > 0 or w.real < 0 or (w.imag < 1 and w.imag > -1), "atan may meet its branch cut")
    if name in ("sinh", "cosh") and isinstance(a, acb_series):
        b = acb(0, 1) * a
        return b.cos() if name == "cosh" else acb(0, -1) * b.sin()
    if name in FUNCTIONS:
        return getattr(a, name)()
    return by_root(step[2], a) if name == "hyp0f1" and step[2] in (HALF, 3 * HALF) else composed(name, step[2], a)


def by_root(parameter: Any, u: Any) -> Any:
    """₀F₁(1/2; u) = cosh 2√u = cos 2√(−u), ₀F₁(3/2; u) = sinh 2√u/2√u = sin 2√(−u)/2√(−u): any root will do."""
    if not (off_cut(first(u)) or off_cut(-first(u))):
        return composed("hyp0f1", parameter, u)
    if off_cut(-first(u)):
        s = 2 * (-u).sqrt()
        top = s.cos() if parameter == HALF else s.sin()
    else:
        s = 2 * u.sqrt()
        t = acb(0, 1) * s
        top = t.cos() if parameter == HALF else acb(0, -1) * t.sin()
    if parameter == HALF:
        return top
    return top / s if first(s).abs_lower() > 0 else composed("hyp0f1", parameter, u)


def composed(name: str, parameter: Any, x: Any) -> Any:
    """₀F₁(a; x) or J_m(x) for a ball or a series, by Taylor coefficients about its constant term."""
    n, w = (x.prec, x[0]) if isinstance(x, acb_series) else (1, x)
    row = []
    if name == "hyp0f1":  # d/dw ₀F₁(a; w) = ₀F₁(a + 1; w)/a
        factor = arb(1)
        for k in range(n):
            row.append(w.hypgeom_0f1(acb(arb(parameter + k))) / factor)
            factor = factor * arb(parameter + k) * (k + 1)
    else:  # 2 J_m′ = J_{m−1} − J_{m+1}
        rest, fact = [w.bessel_j(acb(parameter + m)) for m in range(-(n - 1), n)], 1
        for k in range(n):
            row.append(rest[len(rest) // 2] / fact)
            rest = [(rest[j] - rest[j + 2]) / 2 for j in range(len(rest) - 2)]
            fact *= k + 1
    if not isinstance(x, acb_series):
        return row[0]
    offset, out = acb_series([0, *(x[k] for k in range(1, n))], prec=n), acb_series([row[-1]], prec=n)
    for c in reversed(row[:-1]):
        out = out * offset + c
    return out


# --- beside a branch cut (SPEC-ROOTS, 4) ------------------------------------------------------------------


def root_box(w: Any) -> Any:
    """Both square roots of every number in the ball."""
    side = arb(0, w.abs_upper().sqrt().upper())
    return acb(side, side)


def beside(name: str, w: Any, w_line: Any, normal: Any, beyond: bool) -> tuple[Any, Any]:
    w0 = first(w)
    if off_cut(w0):
        return getattr(w, name)(), getattr(w_line, name)()
    decide(isinstance(w, acb_series) and w_line.imag == 0, f"{name} may meet its branch cut off the declared line")
    turn = (w[1] * normal).imag
    decide(turn > 0 or turn < 0, f"the side from which {name} comes to its cut is not told")
    up = acb(0, 1) if turn > 0 else acb(0, -1)
    if off_cut(-w0) and not beyond:
        return continued(name, w, up), continued(name, w_line, up)
    decide(name == "sqrt" and w0.is_finite(), f"{name} may meet its branch point")
    return acb_series([root_box(w0), acb("nan")], prec=w.prec), root_box(w_line)


def continued(name: str, w: Any, up: Any) -> Any:
    return up * (-w).sqrt() if name == "sqrt" else (-w).log() + up * arb.pi()


def require_beyond(w: Any, w_tip: Any, away: Any) -> None:
    """On the line w is real, ≥ 0 at the tip, and grows away from the cut."""
    if off_cut(first(w)):
        return
    grows = isinstance(w, acb_series) and (w[1] * away).real > 0
    decide(grows and w_tip.imag == 0 and w_tip.real >= 0, "a branch cut may be longer than it is declared")


def at_tip(name: str, w: Any) -> Any:
    if off_cut(w):
        return getattr(w, name)()
    decide(name == "sqrt" and w.is_finite(), f"{name} may meet its branch point")
    return root_box(w)


# --- exact geometry ---------------------------------------------------------------------------------------


def cross(o: Point, a: Point, b: Point) -> Any:
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def edges(vertices: Sequence[Point]) -> list[tuple[Point, Point]]:
    return list(zip(vertices, [*vertices[1:], vertices[0]], strict=True))


def is_inside(vertices: Sequence[Point], p: Point) -> bool:
    inside = False
    for a, b in edges(vertices):
        if (a[1] > p[1]) != (b[1] > p[1]):
            inside ^= (cross(a, b, p) > 0) == (b[1] > a[1])
    return inside


def place_of_box(vertices: Sequence[Point], low: Point, high: Point) -> bool | None:
    """True inside the polygon, False outside, None where an edge may pass."""
    corners = (low, (high[0], low[1]), high, (low[0], high[1]))
    for p, q in edges(vertices):
        apart = any(max(p[k], q[k]) < low[k] or min(p[k], q[k]) > high[k] for k in (0, 1))
        sides = [cross(p, q, corner) for corner in corners]
        if not (apart or all(x > 0 for x in sides) or all(x < 0 for x in sides)):
            return None
    return is_inside(vertices, ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2))


def on_segment(p: Point, a: Point, b: Point) -> bool:
    return cross(a, b, p) == 0 and all(min(a[k], b[k]) <= p[k] <= max(a[k], b[k]) for k in (0, 1))


def require_simple(vertices: Sequence[Point]) -> None:
    """A simple polygon that turns left: edges meet in their common corners only."""
    sides = edges(vertices)
    n = len(sides)
    require(n >= 3 and all(a != b for a, b in sides), "the polygon has too few corners")
    area = sum((a[0] * b[1] - a[1] * b[0] for a, b in sides), fmpq(0))
    require(area > 0, "the polygon does not turn left")
    for j in range(n):
        for k in range(j):
            (a, b), (c, d) = sides[j], sides[k]
            if (j - k) in (1, n - 1):  # neighbours: the far corner of neither lies on the other
                shared = a if a in (c, d) else b
                p, q = (b if shared == a else a), (d if shared == c else c)
                require(not on_segment(p, c, d) and not on_segment(q, a, b), "two edges of the polygon overlap")
                continue
            p, q, r, s = cross(a, b, c), cross(a, b, d), cross(c, d, a), cross(c, d, b)
            proper = ((p > 0) != (q > 0)) and ((r > 0) != (s > 0)) and p != 0 and q != 0 and r != 0 and s != 0
            touch = on_segment(c, a, b) or on_segment(d, a, b) or on_segment(a, c, d) or on_segment(b, c, d)
            require(not proper and not touch, "two edges of the polygon meet")


@dataclass(frozen=True)
class Cut:
    """origin + t direction, 0 ≤ t (≤ length)."""

    origin: Point
    direction: Point
    length: Any

    def place_of(self, p: Point) -> Any:
        x, y = p[0] - self.origin[0], p[1] - self.origin[1]
        if x * self.direction[1] != y * self.direction[0]:
            return None
        return x * self.direction[0] + y * self.direction[1]

    def holds(self, p: Point) -> bool:
        t = self.place_of(p)
        return t is not None and t >= 0 and (self.length is None or t <= self.length)

    def on_line(self, p: Point) -> bool:
        return self.place_of(p) is not None

    @property
    def tips(self) -> list[Point]:
        (x, y), (u, v) = self.origin, self.direction
        return [self.origin] if self.length is None else [self.origin, (x + self.length * u, y + self.length * v)]


def read_cut(value: Any) -> Cut:
    keys(value, "origin direction length")
    u, v = point(value["direction"], "a cut")
    require(u * v == 0 and u * u + v * v == 1, "a cut is not parallel to an axis")
    length = None if value["length"] is None else rational(value["length"], "a cut")
    require(length is None or length > 0, "a cut has no length")
    return Cut(point(value["origin"], "a cut"), (u, v), length)


def require_apart(cuts: Sequence[Cut]) -> None:
    """No two cuts have a point in common: no tip of one lies on another, and none cross."""
    for k, one in enumerate(cuts):
        for other in cuts[:k]:
            tips = any(one.holds(tip) for tip in other.tips) or any(other.holds(tip) for tip in one.tips)
            level, upright = (one, other) if one.direction[1] == 0 else (other, one)
            corner = (upright.origin[0], level.origin[1])
            require(not tips and not (one.holds(corner) and other.holds(corner)), "two cuts meet")


def is_convex(vertices: Sequence[Point]) -> bool:
    """Of a simple polygon that turns left."""
    return all(cross(vertices[k - 2], vertices[k - 1], vertices[k]) >= 0 for k in range(len(vertices)))


def legs_round(vertices: Sequence[Point], cuts: Sequence[Cut]) -> list[tuple[Point, Point]]:
    """The path with the region to its left: edges, with cuts from outside gone in and out; then cuts gone round."""
    require_apart(cuts)
    inner: dict[int, list[tuple[Any, Point]]] = {}
    loops = []
    for cut in cuts:
        if any(cut.on_line(a) and cut.on_line(b) for a, b in edges(vertices)):
            require(is_convex(vertices), "a cut lies along an edge of a region that is not convex")
            continue
        met = []
        for k, (a, b) in enumerate(edges(vertices)):
            far = (cut.origin[0] + cut.direction[0], cut.origin[1] + cut.direction[1])
            p, q = cross(cut.origin, far, a), cross(cut.origin, far, b)
            if p == q or (p > 0 and q > 0) or (p < 0 and q < 0):
                continue
            t = p / (p - q)
            crossing = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
            if cut.holds(crossing):
                require(0 < t < 1, "a cut passes through a corner of the region")
                met.append((k, t))
        for tip in cut.tips:
            require(not any(on_segment(tip, a, b) for a, b in edges(vertices)), "a cut ends on the boundary")
        inside = [tip for tip in cut.tips if is_inside(vertices, tip)]
        if len(inside) == 2 and not met:
            loops.append((inside[0], inside[1]))
        elif len(inside) == 1 and len(met) == 1:
            inner.setdefault(met[0][0], []).append((met[0][1], inside[0]))
        else:
            require(not met and not inside, "a cut divides the region")
    legs = []
    for k, (a, b) in enumerate(edges(vertices)):
        here = a
        for t, tip in sorted(inner.get(k, []), key=lambda one: one[0]):
            there = (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
            legs += [(here, there), (there, tip), (tip, there)]
            here = there
        legs.append((here, b))
    return legs + [leg for a, b in loops for leg in ((a, b), (b, a))]


def hull(*points: Point) -> Any:
    """The ball of a box or segment given by corners."""
    return acb(*(spread([p[k] for p in points]) for k in (0, 1)))


def spread(xs: Sequence[Any]) -> Any:
    low, high = min(xs), max(xs)
    return arb(low) if low == high else arb((low + high) / 2) + arb(0, arb((high - low) / 2).upper())


# --- analytic in the region (SPEC-ROOTS, 5) ---------------------------------------------------------------

Box = tuple[Any, Any, Any, Any]


def cells(vertices: Sequence[Point], cuts: Sequence[Cut]) -> list[Box]:
    xs, ys = ({min(p[k] for p in vertices), max(p[k] for p in vertices)} for k in (0, 1))
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    for cut in cuts:
        for x, y in cut.tips:
            xs |= {x} if left < x < right else set()
            ys |= {y} if low < y < high else set()
    return [(a, b, c, d) for a, b in pairwise(sorted(xs)) for c, d in pairwise(sorted(ys))]


def halves(box: Box) -> tuple[Box, Box]:
    a, b, c, d = box
    if b - a >= d - c:
        return (a, (a + b) / 2, c, d), ((a + b) / 2, b, c, d)
    return (a, b, c, (c + d) / 2), (a, b, (c + d) / 2, d)


def check_analytic(f: Function, vertices: Sequence[Point], cuts: Sequence[Cut], trees: Any) -> None:
    """Every box of the trees passes or lies outside, and together they are the cells."""
    if not f.guarded:
        require(trees == [], "an entire function needs no boxes")
        return
    start = cells(vertices, cuts)
    work = sum(len(tree) for tree in trees if isinstance(tree, str)) if isinstance(trees, list) else 0
    require(work * len(f.needed) * 4 <= MAX_WORK, "there are too many boxes")
    for cell, tree in zip(start, items(trees, 10_000, "trees", len(start)), strict=True):
        require(isinstance(tree, str) and len(tree) <= MAX_PIECES, "a tree is no text, or too long")
        stack = [cell]
        for mark in tree:
            require(stack and mark in "|.o", "a tree does not fit its cell")
            box = stack.pop()
            if mark == "|":
                one, other = halves(box)
                stack += [other, one]
            elif mark == "o":
                outside = place_of_box(vertices, (box[0], box[2]), (box[1], box[3])) is False
                require(outside, "a box that is left out is not outside the region")
            else:
                check_box(f, box, cuts)
        require(not stack, "a tree ends before its cell is covered")


def check_box(f: Function, box: Box, cuts: Sequence[Cut]) -> None:
    a, b, c, d = box
    whole = hull((a, c), (b, d))
    try:
        f.run(whole, 1)
        return
    except Undecided as error:
        why = error
    one, zero = fmpq(1), fmpq(0)
    sides = [((a, c), (b, c), (zero, one)), ((a, d), (b, d), (zero, -one))]
    sides += [((a, c), (a, d), (one, zero)), ((b, c), (b, d), (-one, zero))]
    for start, end, normal in sides:
        for cut in cuts:
            for beyond in ways_beside(cut, start, end):
                try:
                    f.sided(whole, hull(start, end), hull(normal), beyond)
                    return
                except Undecided:
                    continue
    raise Refused(f"the function is not proved to be analytic near {complex(whole):.6g}: {why}")


def ways_beside(cut: Cut, start: Point, end: Point) -> list[Any]:
    """None for an edge on the cut; the tip and the direction away from the cut for one that begins at it."""
    if cut.holds(start) and cut.holds(end):
        return [None]
    if not (cut.on_line(start) and cut.on_line(end)):
        return []
    u, v = cut.direction
    ways = zip(cut.tips, ((-u, -v), (u, v)), strict=False)
    return [(hull(tip), hull(away)) for tip, away in ways if tip in (start, end)]


# --- the turn (SPEC-ROOTS, 6) -----------------------------------------------------------------------------


class Walk:
    """f along one leg."""

    def __init__(self, f: Function, a: Point, b: Point) -> None:
        self.f, self.a, self.b = f, hull(a), hull(b)
        x, y = b[0] - a[0], b[1] - a[1]
        self.step, self.left = hull((x, y)), hull((-y, x))
        self.seen: dict[tuple[Any, int], list[Any]] = {}

    def at(self, m: int, e: int) -> Any:
        return self.a if m == 0 else self.b if m == 1 << e else self.a + self.step * arb((m, -e))

    def end(self, m: int, e: int, mode: int) -> list[Any]:
        if (m, mode) not in self.seen:
            z = self.at(m, e)
            try:
                values = self.f.run(z, 1)
            except Undecided:
                if not mode:
                    raise
                values = self.f.sided(z, z, (self.left, self.step, -self.step)[mode - 1])
            self.seen[m, mode] = [row[0] for row in self.f.parts(values, 1)]
        return self.seen[m, mode]

    def turn(self, m: int, n: int, e: int) -> list[Any]:
        """The turn of each factor from place m to n, in units of 2^−e of the leg."""
        tried = (True, self.f.guarded, self.f.guarded and m == 0, self.f.guarded and n == 1 << e)
        for mode in [k for k in range(4) if tried[k]]:
            try:
                return self.turn_in(m, n, e, mode)
            except Undecided as error:
                why = error
        near = complex(self.at(m, e))
        raise Refused(f"a piece of the path near {near:.6g} is not proved: {why}")

    def turn_in(self, m: int, n: int, e: int, mode: int) -> list[Any]:
        piece = self.a + self.step * arb((m + n, -e - 1), (n - m, -e - 1))
        if mode == 0:
            values = self.f.run(piece, 2)
        else:
            line = (piece, self.at(m, e), self.at(n, e))[mode - 1]
            values = self.f.sided(piece, line, (self.left, self.step, -self.step)[mode - 1])
        starts = self.end(m, e, mode if mode != 3 else 0)
        ends = self.end(n, e, mode if mode != 2 else 0)
        step = self.step * arb((n - m, -e))
        out = []
        for (value, slope), start, end in zip(self.f.parts(values, 2), starts, ends, strict=True):
            decide(start.abs_lower() > 0, "the function may vanish there")
            E = step * slope / start
            little = E.real > -1 or E.imag > 0 or E.imag < 0 or value.abs_lower() > 0
            decide(little, "the function may turn by a half, or vanish")
            out.append((end / start).log().imag)
        return out


def count(f: Function, legs: Sequence[tuple[Point, Point]], breaks: Any) -> list[int]:
    """The number of zeros of each factor."""
    total, pieces = [arb(0)] * len(f.factors), 0
    for (a, b), row in zip(legs, items(breaks, 10_000, "breaks", len(legs)), strict=True):
        keys(row, "exponent places")
        e = integer(row["exponent"], 0, 200, "an exponent")
        places = [integer(m, 0, 1 << e, "a place") for m in items(row["places"], MAX_PIECES, "places")]
        require(
            places[:1] == [0] and places[-1:] == [1 << e] and len(places) > 1, "a leg is not gone from end to end"
        )
        require(all(m < n for m, n in pairwise(places)), "places on a leg are not in order")
        pieces += len(places)
        require(pieces <= MAX_PIECES and pieces * len(f.needed) * 4 <= MAX_WORK, "there are too many pieces")
        walk = Walk(f, a, b)
        for m, n in pairwise(places):
            total = [x + y for x, y in zip(total, walk.turn(m, n, e), strict=True)]
    numbers = [(x / (2 * arb.pi())).unique_fmpz() for x in total]
    known = [int(n) for n in numbers if n is not None and n >= 0]
    require(len(known) == len(numbers), "the turn is not one number of zeros")
    return known


# --- discs of zeros (SPEC-ROOTS, 7) -----------------------------------------------------------------------


@dataclass(frozen=True)
class Root:
    """The disc |z − (x + iy)| ≤ r with its number of zeros."""

    x: Any
    y: Any
    r: Any
    multiplicity: int

    @property
    def corners(self) -> tuple[Point, Point]:
        return (self.x - self.r, self.y - self.r), (self.x + self.r, self.y + self.r)


def read_root(value: Any) -> Root:
    keys(value, "re im exponent radius multiplicity")
    (x, y), r, _ = spectra.read_ball(value, "re im", "a root", 80_000, 5_000)
    return Root(x, y, r, integer(value["multiplicity"], 1, MAX_MULTIPLICITY, "a multiplicity"))


def check_root(f: Function, below: Function | None, root: Root) -> list[int]:
    """How many zeros each factor has in the disc: Pellet's test; the denominator has none."""
    ratio = max(abs(root.x), abs(root.y), fmpq(1)) / root.r
    size = int(ratio.numerator).bit_length() - int(ratio.denominator).bit_length() + 1
    why = ""
    for bits in [size + 64, 2 * size + 128, (min(root.multiplicity, MOST_TERMS) + 1) * size + 256]:
        require(bits <= MAX_BITS and bits * len(f.needed) <= MAX_WORK, "a root has too many digits")
        with precision(bits):
            try:
                return zeros_in(f, below, root)
            except Undecided as error:
                why = str(error)
    raise Refused(f"the disc near {float(root.x):.6g}{float(root.y):+.6g}i is not proved: {why}")


def zeros_in(f: Function, below: Function | None, root: Root) -> list[int]:
    centre, box = hull((root.x, root.y)), hull(*root.corners)
    over = f.run(box, 1)
    if below is not None:
        bottom = below.run(box, 1)[below.output]
        decide(first(bottom).abs_lower() > 0, "the denominator may vanish there too")
    unsure = [k for k in f.factors if not over[k].abs_lower() > 0]
    most = min(root.multiplicity, MOST_TERMS)
    thin, wide = f.run(centre, most + 1), f.run(box, most + 2)
    r = arb(root.r)
    found = dict.fromkeys(f.factors, 0)
    for k in unsure:
        a, b = thin[k], wide[k]
        for m in range(1, most + 1):
            rest = abs(b[m + 1]) * r ** (m + 1)
            if abs(a[m]) * r**m > sum((abs(a[j]) * r**j for j in range(m)), rest):
                found[k] = m
                break
        decide(found[k], "Pellet's test does not hold")
    total = sum(found[k] * power for k, power in f.factors.items())
    decide(total == root.multiplicity, f"it holds {total} zeros in place of {root.multiplicity}")
    return list(found.values())


# --- the claim --------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Region:
    """What is claimed of: its polygon, or a disc; words for it, and what it rests on."""

    polygon: list[Point]
    disc: tuple[Point, Any] | None
    words: str

    def place(self, root: Root) -> bool | None:
        if self.disc is None:
            return place_of_box(self.polygon, *root.corners)
        (x, y), reach = self.disc
        d = (root.x - x) ** 2 + (root.y - y) ** 2
        if reach > root.r and d < (reach - root.r) ** 2:
            return True
        return False if d > (reach + root.r) ** 2 else None


def short(x: Any) -> str:
    return str(x) if len(str(x)) < 16 else f"{float(x.numerator) / float(x.denominator):.8g}"


def read_region(value: Any) -> Region:
    require(isinstance(value, dict), "the region is no object")
    kind = value.get("kind")
    if kind == "rectangle":
        keys(value, "kind re im")
        a, b = (rational(x, "a side") for x in items(value["re"], 2, "re", 2))
        c, d = (rational(x, "a side") for x in items(value["im"], 2, "im", 2))
        require(a < b and c < d, "the rectangle is empty")
        words = f"the rectangle {short(a)} < Re z < {short(b)}, {short(c)} < Im z < {short(d)}"
        return Region([(a, c), (b, c), (b, d), (a, d)], None, words)
    if kind == "half-plane":
        keys(value, "kind side at bound")
        r, t = rational(value["bound"], "a bound"), rational(value["at"], "a side")
        sides = {"upper": (-r, r, t, r), "lower": (-r, r, -r, t), "right": (t, r, -r, r), "left": (-r, t, -r, r)}
        require(value["side"] in sides and r > abs(t), "the half-plane is not known, or its bound too small")
        a, b, c, d = sides[value["side"]]
        line = (
            "Im z" if value["side"] in ("upper", "lower") else "Re z",
            ">" if value["side"] in ("upper", "right") else "<",
        )
        words = f"the part {line[0]} {line[1]} {short(t)} of the square max(|Re z|, |Im z|) < {short(r)}"
        return Region([(a, c), (b, c), (b, d), (a, d)], None, words)
    if kind == "disc":
        keys(value, "kind centre radius")
        centre, r = point(value["centre"], "a centre"), rational(value["radius"], "a radius")
        require(r > 0, "the disc is empty")
        return Region([], (centre, r), f"the disc |z - ({short(centre[0])} + {short(centre[1])}i)| < {short(r)}")
    require(kind == "polygon", "the region's kind is not known")
    keys(value, "kind vertices")
    vertices = [point(p, "a corner") for p in items(value["vertices"], MAX_CORNERS, "vertices")]
    require_simple(vertices)
    near = ", ".join(f"{short(x)} + {short(y)}i" for x, y in vertices[:4])
    return Region(vertices, None, f"the polygon with the {len(vertices)} corners {near}{', …' * (len(vertices) > 4)}")


def check_holds(counted: Sequence[Point], asked: Region) -> None:
    """What is counted is the region itself, or convex and holds it."""
    if asked.disc is None and list(counted) == asked.polygon:
        return
    require(is_convex(counted), "what is counted is neither the region nor convex")
    for a, b in edges(counted):
        if asked.disc is None:
            require(all(cross(a, b, p) >= 0 for p in asked.polygon), "the counted polygon does not hold the region")
        else:
            centre, r = asked.disc
            area = cross(a, b, centre)
            length = (b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2
            require(area > 0 and area**2 >= r**2 * length, "the counted polygon does not hold the disc")


def read_function(value: Any) -> tuple[Function, Function | None]:
    keys(value, "steps numerator denominator")
    steps = read_steps(value["steps"])
    top = Function(steps, integer(value["numerator"], 0, len(steps) - 1, "the numerator"))
    bottom = value["denominator"]
    return top, None if bottom is None else Function(steps, integer(bottom, 0, len(steps) - 1, "the denominator"))


def region(content: dict[str, Any]) -> str:
    """Checks a certificate of kind "region"; what it proves, in words."""
    f, below = read_function(content["function"])
    asked = read_region(content["region"])
    counted = [point(p, "a corner") for p in items(content["counted"], MAX_CORNERS, "counted")]
    require_simple(counted)
    check_holds(counted, asked)
    cuts = [read_cut(one) for one in items(content["cuts"], MAX_CUTS, "cuts")]
    legs = legs_round(counted, cuts)
    with precision(integer(content["bits"], 53, 4096, "bits")):
        check_analytic(f, counted, cuts, content["trees"])
        numbers = count(f, legs, content["breaks"])
    roots = [read_root(one) for one in items(content["roots"], MAX_ROOTS, "roots")]
    spectra.require_apart([((root.x, root.y), root.r) for root in roots], "two discs overlap")
    held = [0] * len(numbers)
    for root in roots:
        require(place_of_box(counted, *root.corners) is True, "a disc is not inside the polygon that was counted")
        held = [x + y for x, y in zip(held, check_root(f, below, root), strict=True)]
    require(held == numbers, f"{sum(numbers)} zeros of factors are counted, but the discs hold {sum(held)}")
    places = [asked.place(root) for root in roots]
    require(None not in places, "a disc meets the boundary of the region")
    keys(content["claim"], "count")
    inside = sum(root.multiplicity for root, place in zip(roots, places, strict=True) if place)
    require(
        inside == integer(content["claim"]["count"], 0, 10**9, "count"), "the claimed count is not the proved one"
    )
    return words(f, below, asked, cuts, inside, sum(bool(p) for p in places))


def words(f: Function, below: Function | None, asked: Region, cuts: Sequence[Cut], total: int, discs: int) -> str:
    without = f", without the branch cuts {'; '.join(map(cut_words, cuts))}," if cuts else ""
    zeros = "zero" if total == 1 else "zeros"
    where = f" in {discs} disjoint discs" if total else ""
    holds = f"holds exactly {total} {zeros} of f, counted with multiplicity{where}"
    return f"f(z) = {shown(f, below)}\n{asked.words}{without} {holds}"


def shown(f: Function, below: Function | None) -> str:
    return f.shown if below is None else f"({f.shown})/({below.shown})"


def cut_words(cut: Cut) -> str:
    ends = [f"{short(x)} + {short(y)}i" for x, y in (*cut.tips, cut.direction)]
    return f"from {ends[0]} along {ends[1]}" if cut.length is None else f"from {ends[0]} to {ends[1]}"


def interval(content: dict[str, Any]) -> str:
    """Checks a certificate of kind "interval": the real zeros of f on [a, b]."""
    f, below = read_function(content["function"])
    with precision(128):
        require(f.is_real(), "the function is not known to be real on the real line")
    a, b = (rational(x, "an end") for x in items(content["interval"], 2, "interval", 2))
    require(a < b, "the interval is empty")
    found: list[tuple[Any, Any, int]] = []
    tiles = items(content["tiles"], MAX_STEPS, "tiles", len(f.factors))
    for (factor, power), row in zip(f.factors.items(), tiles, strict=True):
        found += tiles_of(Function(f.steps, factor), power, a, b, row, f)
    found.sort(key=lambda one: one[0])
    merged = [x for x, y in pairwise(found) if x[1] >= y[0]]
    require(not merged, "zeros of two factors are not told apart")
    for low, high, _ in found:
        if below is not None:
            bottom = first(below.run(acb(spread([low, high])), 1)[below.output])
            require(bottom.abs_lower() > 0, "the denominator may vanish where the numerator does")
    keys(content["claim"], "zeros multiplicities")
    times = [
        integer(m, 1, MAX_MULTIPLICITY, "a multiplicity")
        for m in items(content["claim"]["multiplicities"], MAX_ROOTS, "m")
    ]
    require(times == [m for _, _, m in found], "the claimed multiplicities are not the proved ones")
    require(
        integer(content["claim"]["zeros"], 0, MAX_ROOTS, "zeros") == len(found),
        "the claimed number is not the proved one",
    )
    zeros = "zero" if len(found) == 1 else "zeros"
    claim = f"holds exactly {len(found)} real {zeros} of f, with multiplicities {times}"
    return f"f(z) = {shown(f, below)}\n[{short(a)}, {short(b)}] {claim}"


def tiles_of(g: Function, power: int, a: Any, b: Any, row: Any, f: Function) -> list[tuple[Any, Any, int]]:
    """The zeros of one factor, bracketed: tiles from a to b without a zero, or with one and a slope that is not 0."""
    keys(row, "bits places kinds sharp brackets")
    places = [rational(x, "a place") for x in items(row["places"], MAX_PIECES, "places")]
    kinds = row["kinds"]
    require(isinstance(kinds, str) and len(kinds) == len(places) - 1, "tiles and their kinds do not fit")
    require(places[0] == a and places[-1] == b and all(x < y for x, y in pairwise(places)), "tiles do not cover")
    require(len(places) * len(f.needed) <= MAX_WORK, "there are too many tiles")
    out = []
    with precision(integer(row["bits"], 53, MAX_BITS, "bits")):
        for (low, high), kind in zip(pairwise(places), kinds, strict=True):
            value = tile_value(g, acb(spread([low, high])), 2)
            if kind == ".":
                start = tile_value(g, acb(arb((low + high) / 2)), 1)[0]
                mean = start + value[1] * acb(arb(0, arb((high - low) / 2).upper()))
                require(value[0].abs_lower() > 0 or mean.abs_lower() > 0, "a tile may hold a zero")
                continue
            require(kind == "1", "the kind of a tile is not known")
            slope, ends = value[1].real, [tile_value(g, acb(arb(x)), 1)[0].real for x in (low, high)]
            require(slope > 0 or slope < 0, "the slope may vanish on a tile with a zero")
            at_end = (low == a and ends[0] == 0) or (high == b and ends[1] == 0)
            crosses = (ends[0] < 0 and ends[1] > 0) or (ends[0] > 0 and ends[1] < 0)
            require(crosses or at_end, "a tile is not proved to hold a zero")
            out.append((low, high, power))
    brackets = [point(pair, "a bracket") for pair in items(row["brackets"], len(out), "brackets", len(out))]
    with precision(integer(row["sharp"], 53, MAX_BITS, "bits")):
        return [(*narrow(g, u, v, low, high), power) for (u, v), (low, high, _) in zip(brackets, out, strict=True)]


def narrow(g: Function, u: Any, v: Any, low: Any, high: Any) -> tuple[Any, Any]:
    """The bracket: g is monotone on the tile and has two signs at u < v, or is exactly 0 at u = v."""
    require(low <= u <= v <= high, "a bracket is not in its tile")
    signs = [tile_value(g, acb(arb(x)), 1)[0].real for x in (u, v)]
    crosses = (signs[0] < 0 and signs[1] > 0) or (signs[0] > 0 and signs[1] < 0)
    require(crosses or (u == v and signs[0] == 0) or (u, v) == (low, high), "a bracket is not proved to hold a zero")
    return u, v


def tile_value(g: Function, z: Any, n: int) -> list[Any]:
    values = g.run(z, n)[g.output]
    row = [values[k] for k in range(n)] if isinstance(values, acb_series) else [values, acb(0)][:n]
    require(all(x.is_finite() for x in row), "the function is not finite on a tile")
    return row


if __name__ == "__main__":
    sys.exit(spectra.main(sys.argv[1:], verify, "verify_roots.py"))
