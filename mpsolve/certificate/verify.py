"""Checks a certificate of induced frequencies, or of crossings, against certs/SPEC.md; shares nothing with its maker.

Needs Python ≥ 3.11 and python-flint only, and runs as a plain script:  python verify.py FILE [FILE …]
Exit status 0: every file is valid; 1: one is not, and its line says why. Of a spectrum every step is given in the
file or fixed by the specification; that there are no crossings besides those listed is found by bisection. The work
that a file asks for is bounded, and added up before any of it is done. Δ is evaluated by the residue sums over the
p-roots of the quartic D(p, q).
"""

from __future__ import annotations

import hashlib
import json
import math
import re
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

import flint
from flint import acb, acb_mat, acb_poly, arb, fmpq

MAX_BYTES, MAX_PIECES, MAX_ROOTS, MAX_MASSES = 64_000_000, 300_000, 300, 24
MAX_BITS, MAX_ALL_BITS, MAX_CONTOUR_BITS = 120_000, 1_500_000, 512  # of one root, of all roots, of a contour
MAX_CROSSINGS, MAX_BOXES, MAX_FAR_PARTS = 1_000, 400_000, 4_096
MAX_WORK = 200_000_000  # of a whole file, about microseconds: see `work`
I = acb(0, 1)  # noqa: E741

KINDS = {
    "induced frequencies": {"case", "claim", "contour", "roots", "identity"},
    "crossings": {"case", "claim", "family", "height", "radius", "crossings", "base"},
}


class Refused(Exception):  # noqa: N818
    """The certificate does not prove its claim; the message says where it fails."""


@dataclass(frozen=True)
class Verdict:
    """valid: every step was checked. reason: why not. claim: what is proved if valid."""

    valid: bool
    reason: str = ""
    claim: str = ""

    def __bool__(self) -> bool:
        raise TypeError("a verdict has no truth value: ask for .valid")


def verify(path: Any) -> Verdict:
    """The verdict on the certificate in the file `path`. Never raises for what the file holds."""
    try:
        with open(path, "rb") as file:
            raw = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        return Verdict(False, f"the file cannot be read: {getattr(error, 'strerror', None) or error}")
    return judge(raw)


def judge(raw: bytes) -> Verdict:
    """The verdict on what a file holds. Never raises."""
    try:
        require(len(raw) <= MAX_BYTES, f"the file is larger than {MAX_BYTES} bytes")
        return Verdict(True, "", check(read(raw)))
    except Refused as error:
        return Verdict(False, str(error))
    except (UnicodeDecodeError, json.JSONDecodeError) as error:
        return Verdict(
            False, f"no certificate, which is JSON in ASCII, as `mpsolve certify` writes it ({error})"[:200]
        )
    except (ValueError, TypeError, KeyError, IndexError, ArithmeticError, RecursionError, MemoryError) as error:
        return Verdict(False, f"malformed: {type(error).__name__}: {str(error)[:200]}")


def work(masses: int, bits: int) -> int:
    """What one value of Δ with its slope costs, in about microseconds: places of masses, and bits of precision."""
    return int((150 + 30 * masses**2 + masses**4 // 4) * (1 + (bits / 600) ** 1.5))


def require(condition: Any, message: str) -> None:
    if not condition:
        raise Refused(message)


# flint has one precision for the whole process: whoever changes it keeps other threads waiting, by one lock for all
LOCK = vars(flint).setdefault("_precision_lock", threading.RLock())


@contextmanager
def precision(bits: int) -> Iterator[None]:
    with LOCK:
        before = flint.ctx.prec
        flint.ctx.prec = bits
        try:
            yield
        finally:
            flint.ctx.prec = before


# --- reading ----------------------------------------------------------------------------------------------


def read(raw: bytes) -> dict[str, Any]:
    """The content of a file, with its digest, version and keys checked."""

    def no_constant(name: str) -> Any:
        raise Refused(f"the number {name} is not allowed")

    def no_float(text: str) -> Any:
        raise Refused(f"{text[:40]} is not an integer: numbers are exact integers, or text")

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        require(len({k for k, _ in pairs}) == len(pairs), "a key stands twice in one object")
        return dict(pairs)

    text = raw.decode("ascii")
    content: Any = json.loads(text, parse_constant=no_constant, parse_float=no_float, object_pairs_hook=unique)
    return opened(content)


def opened(content: Any) -> dict[str, Any]:
    """The object without its digest, which fits, and with its version, kind and keys checked."""
    require(isinstance(content, dict), "the file holds no JSON object")
    require(content.get("format") == "mpsolve certificate", "the format is not 'mpsolve certificate'")
    version = content.get("version")
    require(version == 1 and type(version) is int, f"version {str(version)[:20]} is not known to this verifier")
    kind = content.get("kind")
    require(isinstance(kind, str) and kind in KINDS, "the kind is not known to this verifier")
    keys(content, {"format", "version", "kind", "sha256"} | KINDS[kind])
    rest = {key: value for key, value in content.items() if key != "sha256"}
    canonical = json.dumps(rest, sort_keys=True, separators=(",", ":"), ensure_ascii=True)
    digest = hashlib.sha256(canonical.encode("ascii")).hexdigest()
    require(digest == content["sha256"], "the digest does not fit the content")
    return rest


def keys(value: Any, names: set[str], optional: frozenset[str] = frozenset()) -> None:
    require(isinstance(value, dict), "an object is missing")
    missing, unknown = sorted(names - value.keys()), sorted(value.keys() - names - optional)
    require(not missing and not unknown, f"keys missing: {missing[:5]}, unknown: {[u[:40] for u in unknown[:5]]}")


def integer(value: Any, low: int, high: int, name: str) -> int:
    require(type(value) is int and low <= value <= high, f"{name} is not an integer from {low} to {high}")
    return int(value)


def mantissa(value: Any) -> int:
    require(isinstance(value, str) and re.fullmatch(r"-?0x[0-9a-f]{1,40000}", value), "a mantissa is not hexadecimal")
    return int(value, 16)


def dyadic(value: Any) -> Fraction:
    """m·2^e from ["0x…", e]; kept small, since it is a point of a contour."""
    require(isinstance(value, list) and len(value) == 2, "a dyadic number is not a pair")
    e = integer(value[1], -3000, 3000, "an exponent")
    require(len(value[0]) < 1000, "a breakpoint has too many digits")
    return Fraction(mantissa(value[0])) * Fraction(2) ** e


@dataclass(frozen=True)
class Real:
    """sign · radicand^(1/4) or a rational, with order and balls; x|x|³ is kept, which orders as x does."""

    quartic: Fraction
    rational: Fraction | None

    def ball(self) -> Any:
        if self.rational is not None:
            return ball(self.rational)
        root = ball(abs(self.quartic)).sqrt().sqrt()
        return -root if self.quartic < 0 else root


def real(text: Any, name: str) -> Real:
    """Reads "p", "p/q", "root4(p/q)" or "-root4(p/q)"."""
    require(isinstance(text, str), f"{name} is not text")
    match = re.fullmatch(r"(-?)(root4\()?([0-9]{1,4300})(?:/([0-9]{1,4300}))?(\))?", text)
    if match is None or bool(match[2]) != bool(match[5]):
        raise Refused(f"{name} is not an exact number")
    value = Fraction(int(match[3]), int(match[4] or 1)) * (-1 if match[1] else 1)
    return Real(value, None) if match[2] else rational_real(value)


def rational_real(value: Fraction) -> Real:
    return Real(value * abs(value) ** 3, value)


def ball(x: Fraction) -> Any:
    return arb(fmpq(x.numerator, x.denominator))


# --- the problem ------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Problem:
    """The case in exact numbers, masses at one place not yet merged."""

    alpha: Real
    eta_b: Real
    eta_n: Real
    eta_s: Real
    masses: tuple[tuple[Real, ...], ...]  # those at one place together
    places: tuple[Real, ...]

    @property
    def at_rest(self) -> bool:
        """α = 0 and N = 0, exactly."""
        return not self.alpha.quartic and self.eta_n.quartic == self.eta_s.quartic


def problem(case: Any) -> Problem:
    keys(case, {"alpha", "eta_b", "eta_m", "positions", "eta_n", "eta_s"})
    lists = [case["eta_m"], case["positions"]]
    require(all(isinstance(x, list) and 0 < len(x) <= MAX_MASSES for x in lists), "no list of masses, or too many")
    require(len(lists[0]) == len(lists[1]), "masses and positions differ in number")
    alpha, eta_b, eta_n, eta_s = (real(case[k], k) for k in ("alpha", "eta_b", "eta_n", "eta_s"))
    require(min(alpha.quartic, eta_b.quartic, eta_s.quartic) >= 0, "alpha, eta_b or eta_s is negative")
    grouped: dict[Fraction, tuple[Real, list[Real]]] = {}
    last = None
    for text, place in zip(*lists, strict=True):
        eta, x = real(text, "eta_m"), real(place, "positions")
        require(eta.quartic > 0, "a mass is not positive")
        require(last is None or last <= x.quartic, "positions are not in order")
        last = x.quartic
        grouped.setdefault(x.quartic, (x, []))[1].append(eta)
    masses = tuple(tuple(etas) for _, etas in grouped.values())
    return Problem(alpha, eta_b, eta_n, eta_s, masses, tuple(x for x, _ in grouped.values()))


@dataclass(frozen=True)
class Numbers:
    """The case in balls at the present precision; r = q − iη_b, A = N + α², β² = 1 − η_b²."""

    alpha: Any
    axial: Any
    eta_b: Any
    eta: tuple[Any, ...]
    x: tuple[Any, ...]

    @cached_property
    def A(self) -> Any:
        return self.axial + self.alpha**2

    @cached_property
    def beta2(self) -> Any:
        return 1 - self.eta_b**2

    @property
    def single_at_rest(self) -> bool:
        return bool(self.alpha.is_zero()) and len(self.eta) == 1


def numbers(p: Problem) -> Numbers:
    eta = tuple(sum((m.ball() for m in group), arb(0)) for group in p.masses)
    axial = arb(0) if p.at_rest else p.eta_n.ball() - p.eta_s.ball()
    return Numbers(p.alpha.ball(), axial, p.eta_b.ball(), eta, tuple(x.ball() for x in p.places))


# --- p-roots of D = p⁴ − 4A p² + 8αr p + 4β² − 4r², eq. (18) ----------------------------------------------


def D_p(n: Numbers, p: Any, r: Any) -> Any:
    return 4 * p**3 - 8 * n.A * p + 8 * n.alpha * r


def quartic(n: Numbers, p: Any, r: Any) -> Any:
    return ((p * p - 4 * n.A) * p + 8 * n.alpha * r) * p + 4 * n.beta2 - 4 * r * r


def seeds(n: Numbers, r: Any) -> list[Any]:
    """Approximate p-roots at the middle of the ball r."""
    r = acb(r.mid())
    polynomial = acb_poly([acb(c).mid() for c in (4 * n.beta2 - 4 * r * r, 8 * n.alpha * r, -4 * n.A, 0, 1)])
    first = min(flint.ctx.prec, 512)  # roots that are apart at this precision are polished to the full one
    for bits in sorted({first, 4 * first, 16 * first, max(16 * first, flint.ctx.prec)}):
        try:
            with precision(bits):
                found = polynomial.roots()
            return [polished(n, r, z.mid()) for z in found]
        except ValueError:  # roots too close for this precision
            continue
    raise Refused("two p-roots are too close to tell apart")


def polished(n: Numbers, middle: Any, p: Any) -> Any:
    """p after Newton's method on D(·, middle), until it stands still: an approximation, not a proof."""
    k2, k1, k0 = (x.mid() for x in (4 * n.A, 8 * n.alpha * middle, 4 * (n.beta2 - middle * middle)))
    for _ in range(8 + flint.ctx.prec.bit_length()):
        square = p * p
        step = (((square - k2) * p + k1) * p + k0).mid() / (p * (4 * square - 2 * k2) + k1).mid()
        if not step.is_finite():
            break
        p = (p - step).mid()
        if abs(step) <= abs(p) * arb(2) ** (6 - flint.ctx.prec):
            break
    return p


def p_root(n: Numbers, r: Any, p: Any) -> Any:
    """A ball with exactly one root of D(·, r), next to p, for each point of the ball r, or None: interval Newton.

    `p` and `r` both real (arb) give a real root.
    """
    middle, p = r.mid(), p.mid()
    shift = r - middle
    value = quartic(n, p, middle) + shift * (8 * n.alpha * p - 8 * middle - 4 * shift)
    reach = abs(value / D_p(n, p, r)).upper() + abs(p).upper() * arb(2) ** (4 - flint.ctx.prec)
    for k in range(1, 6):
        size = arb(0, (reach * arb(2) ** k).upper())
        around = p + size if isinstance(p, arb) else p + acb(size, size)
        image = p - value / D_p(n, around, r)
        if image.is_finite() and around.contains_interior(image):
            return p - value / D_p(n, image.union(p), r)  # once more, on the hull of p and the image
    return None


@dataclass(frozen=True)
class Roots:
    """The p-roots: two above the real axis, two below it. `met`: an upper and a lower one share a ball."""

    upper: tuple[Any, Any]
    lower: tuple[Any, Any]

    @property
    def resultant(self) -> Any:
        (a, b), (c, e) = self.upper, self.lower
        return (a - c) * (a - e) * (b - c) * (b - e)


def roots_off_cut(n: Numbers, q: Any) -> Roots:
    """The p-roots for a ball q off the cuts, each with its side.

    A side that is open over the whole ball may be told at one point of it, if no cut meets the ball.
    """
    r = q - I * n.eta_b
    found = [p_root(n, r, z) for z in seeds(n, r)]
    require(len(found) == 4, "p-roots cannot be told apart off the cut")
    if sum(p is None for p in found) == 2:
        return one_side_met(n, [p for p in found if p is not None])
    require(all(p is not None for p in found), "p-roots cannot be isolated off the cut")
    apart(found)
    upper: list[Any] = []
    lower: list[Any] = []
    for p in found:
        side = p
        if not (p.imag > 0 or p.imag < 0):
            require(off_the_cuts(n, q), "the ball of q may meet a cut")
            side = p_root(n, acb(r.mid()), polished(n, acb(r.mid()), p.mid()))
            require(side is not None and not any(side.overlaps(o) for o in found if o is not p), "a p-root is lost")
        require(side.imag > 0 or side.imag < 0, "a p-root is too close to the real axis")
        (upper if side.imag > 0 else lower).append(p)
    require(len(upper) == 2 and len(lower) == 2, "the p-roots are not two above and two below the real axis")
    return Roots((upper[0], upper[1]), (lower[0], lower[1]))


def one_side_met(n: Numbers, others: list[Any]) -> Roots:
    """Two roots on one side that may meet share a ball, by Vieta; the other two are isolated on the other side."""
    apart(others)
    total, product = others[0] + others[1], others[0] * others[1]
    square = 4 * n.A + product - 3 * total**2 / 4
    reach = arb(0, abs(square).upper().sqrt().upper())
    pair = -total / 2 + acb(reach, reach)
    if pair.imag > 0 and others[0].imag < 0 and others[1].imag < 0:
        return Roots((pair, pair), (others[0], others[1]))
    require(pair.imag < 0 and others[0].imag > 0 and others[1].imag > 0, "p-roots cannot be isolated off the cut")
    return Roots((others[0], others[1]), (pair, pair))


def off_the_cuts(n: Numbers, q: Any) -> bool:
    """D has no real p-root for any q of the ball: off the line Im q = η_b, or Im q ≤ 0 (for η_b > 0, N < 1)."""
    height = q.imag - n.eta_b
    return bool((cuts_on_line(n) and (height > 0 or height < 0)) or (q.imag <= 0 and n.eta_b > 0))


def apart(found: Sequence[Any]) -> None:
    require(not any(acb(p).overlaps(acb(o)) for k, p in enumerate(found) for o in found[:k]), "p-roots overlap")


def roots_on_cut(n: Numbers, r: Any) -> Roots:
    """For a real ball r, as seen from below the cut: a real root is an upper one iff D_r/D_p > 0 there."""
    if n.alpha.is_zero():
        return even_roots(n, r)
    real_seeds: list[Any] = []
    upper_seeds: list[Any] = []
    for z in seeds(n, r):
        if abs(z.imag) < abs(z) * arb(2) ** -20:
            real_seeds.append(z.real)
        elif z.imag > 0:  # D is real: the conjugate of a root is a root
            upper_seeds.append(z)
    require(len(real_seeds) + 2 * len(upper_seeds) == 4, "the p-roots on the cut cannot be told apart")
    real_ones = {k: p for k, z in enumerate(real_seeds) if (p := p_root(n, r, z)) is not None}
    upper = [p for z in upper_seeds if (p := p_root(n, r, z)) is not None and p.imag > 0]
    lower = [p.conjugate() for p in upper]
    lost = [k for k in range(len(real_seeds)) if k not in real_ones]
    if len(lost) == 1 and real_ones:  # its neighbour, which it may meet, is taken together with it
        real_ones.pop(min(real_ones, key=lambda k: float(abs(real_seeds[k] - real_seeds[lost[0]]).mid())))
    apart([*real_ones.values(), *upper, *lower])
    missing = 4 - len(real_ones) - len(upper) - len(lower)
    for p in real_ones.values():
        sign = (8 * n.alpha * p - 8 * r) * D_p(n, p, r)
        require(sign > 0 or sign < 0, "the side of a real p-root is open")
        (upper if sign > 0 else lower).append(acb(p))
    if missing == 2:
        above, below = last_two(n, r, upper + lower)
        upper.append(above)
        lower.append(below)
    require(len(upper) == 2 and len(lower) == 2, "the p-roots on the cut cannot be told apart")
    return Roots((upper[0], upper[1]), (lower[0], lower[1]))


def even_roots(n: Numbers, r: Any) -> Roots:
    """α = 0: p² = 2A ± √X, X = 4A² + 4r² − 4β², and D_r = −8r < 0: a real root is an upper one iff D_p < 0."""
    require(r > 0, "r is not positive")
    X = 4 * n.A**2 + 4 * r * r - 4 * n.beta2
    if X < 0:
        p = acb(2 * n.A, (-X).sqrt()).sqrt()
        return Roots((p, -p.conjugate()), (p.conjugate(), -p))
    if X > 0:
        pairs = [even_pair(2 * n.A + sign * X.sqrt(), sign) for sign in (1, -1)]
        return Roots((pairs[0][0], pairs[1][0]), (pairs[0][1], pairs[1][1]))
    # √(2A ± √X) = √2A √(1 + t), |√(1 + t) − 1| ≤ |t|/(1 + √(1 − |t|)): an upper and a lower root in each ball
    t = arb(abs(X).upper()).sqrt() / (2 * n.A)
    require(t > 0 and t < 1, "more than two p-roots meet")
    centre = (2 * n.A).sqrt()
    reach = arb(0, (centre * t / (1 + (1 - t).sqrt())).upper())
    p = acb(centre + reach, reach)
    return Roots((p, -p), (p, -p))


def even_pair(square: Any, sign: int) -> tuple[Any, Any]:
    """(above, below) of ±√square, where D_p = 4 sign p √X."""
    if square < 0:
        return acb(0, 1) * (-square).sqrt(), acb(0, -1) * (-square).sqrt()
    if square > 0:
        return acb(-sign * square.sqrt()), acb(sign * square.sqrt())
    reach = arb(0, abs(square).upper().sqrt().upper())
    return acb(reach, reach), acb(reach, reach)


def last_two(n: Numbers, r: Any, others: list[Any]) -> tuple[Any, Any]:
    """(above, below): the last two roots, from the other two by Vieta; they may meet within the ball of r."""
    require(len(others) == 2, "more than two p-roots meet")
    o = m = others
    if not r.is_exact():
        starts = [polished(n, r.mid(), p.real.mid() if p.imag.is_zero() else p.mid()) for p in others]
        m = [p_root(n, r.mid(), p) for p in starts]
        require(all(x is not None and y.contains(acb(x)) for x, y in zip(m, o, strict=True)), "a p-root is lost")
    total, product = (o[0] + o[1]).real, (o[0] * o[1]).real
    centre = -total / 2
    # (p − centre)² = 4A + product − 3 total²/4, centred at the middle of r, with p' = −D_r/D_p
    rate = [-(8 * n.alpha * p - 8 * r) / D_p(n, p, r) for p in o]
    slope = (rate[0] * o[1] + o[0] * rate[1] - 3 * total * (rate[0] + rate[1]) / 2).real
    square = 4 * n.A + (m[0] * m[1] - 3 * (m[0] + m[1]) ** 2 / 4).real + slope * (r - r.mid())
    if square < 0:
        return acb(centre, (-square).sqrt()), acb(centre, -(-square).sqrt())
    if square > 0:
        left, right = centre - square.sqrt(), centre + square.sqrt()
        rest = (left**2 - total * left + product, right**2 - total * right + product)  # (p − p₃)(p − p₄)
        signs = (-rest[0] * (n.alpha * left - r), rest[1] * (n.alpha * right - r))  # of D_p D_r
        if signs[0] > 0 and signs[1] < 0:
            return acb(left), acb(right)
        require(signs[0] < 0 and signs[1] > 0, "the sides of two real p-roots are open")
        return acb(right), acb(left)
    wide, high = (arb(0, positive_root(side).upper()) for side in (square, -square))
    slope = n.alpha * (centre + wide) - r
    require(slope > 0 or slope < 0, "D_r may vanish where p-roots meet")  # else one is above and one below
    pair = acb(centre + wide, high)
    return pair, pair


# --- K, Δ and R Δ -----------------------------------------------------------------------------------------


def kernels(n: Numbers, z: Roots, r: Any, xi: Any, ahead: bool) -> tuple[Any, Any]:
    """K(ξ) by (37) and K_q(ξ) by (39) as corrected: ±2πi times sums over the upper or the lower roots."""
    value, slope = acb(0), acb(0)
    for p in z.upper if ahead else z.lower:
        d1, d2 = D_p(n, p, r), 12 * p * p - 8 * n.A
        dq, dqp = 8 * n.alpha * p - 8 * r, 8 * n.alpha
        wave = (I * p * xi).exp()
        value += wave / d1
        slope += wave * (dq * d2 / d1 - dqp - I * xi * dq) / d1**2
    factor = 2 * arb.pi() * I * (1 if ahead else -1)
    return factor * value, factor * slope


def delta(n: Numbers, z: Roots, q: Any, r: Any) -> tuple[Any, Any]:
    """Δ = det[I − (2q²/π) K_ij η_j], eq. (26), and Δ_q."""
    size = range(len(n.eta))
    rows: list[list[Any]] = [[None] * len(n.eta) for _ in size]
    rates: list[list[Any]] = [[None] * len(n.eta) for _ in size]
    for i in size:
        for j in size:
            value, slope = kernels(n, z, r, n.x[i] - n.x[j], i >= j)
            rows[i][j] = int(i == j) - 2 * q * q / arb.pi() * value * n.eta[j]
            rates[i][j] = -(4 * q * value + 2 * q * q * slope) / arb.pi() * n.eta[j]
    rate = sum((det([*rows[:k], rates[k], *rows[k + 1 :]]) for k in size), acb(0))
    return det(rows), rate


def det(rows: Sequence[Sequence[Any]]) -> Any:
    if len(rows) > 4 and isinstance(rows[0][0], Dual):
        return det_of_duals(rows)
    if len(rows) > 4:
        return acb_mat([list(row) for row in rows]).det()
    if len(rows) == 1:
        return rows[0][0]
    minors = ([[*row[:k], *row[k + 1 :]] for row in rows[1:]] for k in range(len(rows)))
    return sum(((-1) ** k * rows[0][k] * det(minor) for k, minor in enumerate(minors)), acb(0))


def kernel_met(z: Roots, xi: Any, ahead: bool) -> Any:
    """K(ξ) where the two roots a, b of its own side may meet: the divided difference of e^{ipξ}/((p − c)(p − e))."""
    (a, b), (c, e) = (z.upper, z.lower) if ahead else (z.lower, z.upper)
    at_a, at_b = (a - c) * (a - e), (b - c) * (b - e)
    wave = I * xi * (I * a * xi).exp() * (((a - b) * xi / 2).sinc() * (-I * (a - b) * xi / 2).exp())
    value = wave / at_a - (I * b * xi).exp() * (a + b - c - e) / (at_a * at_b)
    return 2 * arb.pi() * I * (value if ahead else -value)


def value_off_cut(n: Numbers, q: Any) -> Any:
    """Δ alone, also where two p-roots on one side of the real axis may meet."""
    z = roots_off_cut(n, q)
    if not (z.upper[0].overlaps(z.upper[1]) or z.lower[0].overlaps(z.lower[1])):
        return delta(n, z, q, q - I * n.eta_b)[0]
    size = range(len(n.eta))
    rows = [[kernel_met(z, n.x[i] - n.x[j], i >= j) * n.eta[j] for j in size] for i in size]
    factor = 2 * q * q / arb.pi()
    return det([[int(i == j) - factor * rows[i][j] for j in size] for i in size])


def delta_off_cut(n: Numbers, q: Any) -> tuple[Any, Any]:
    return delta(n, roots_off_cut(n, q), q, q - I * n.eta_b)


def edge(n: Numbers, r: Any) -> tuple[Any, Any]:
    """G± = R det[I − (2(r ± iη_b)²/π) K M] for a real ball r, K and R as seen from below the cut.

    For one mass at rest G±/s, s = a + b, where R = 2s²(s² − 4A).
    """
    factors = [4 * I * (acb(r) + s * I * n.eta_b) ** 2 for s in (1, -1)]
    if n.single_at_rest:
        s = resting_sum(n, r)
        resting = [2 * s * (s * s - 4 * n.A) + 2 * factor * n.eta[0] for factor in factors]
        return resting[0], resting[1]
    z = roots_on_cut(n, r)
    met = any(u.overlaps(v) for u in z.upper for v in z.lower)
    waves, resultant = None if met else edge_waves(n, z), z.resultant
    values = []
    for factor in factors:
        plain = None if waves is None else resultant * det(edge_rows(n, waves, factor))
        values.append(plain if plain is not None and in_half_plane(plain) else scaled(n, z, factor))
    return values[0], values[1]


def resting_sum(n: Numbers, r: Any) -> Any:
    """s = a + b for α = 0: s² = −4(z − N) with z = √(β² − r²), or i√(r² − β²) for r > β; Im s ≥ 0."""
    x = n.beta2 - r * r
    z = acb(positive_root(x), positive_root(-x))
    w = 4 * (z - n.axial)
    if w.contains(0):
        reach = arb(0, abs(w).upper().sqrt().upper())
        return acb(reach, reach)
    return -(-w).sqrt() if w.real < 0 else I * w.sqrt()


def positive_root(x: Any) -> Any:
    """√max(x, 0)."""
    if x > 0:
        return x.sqrt()
    return arb(0) if x <= 0 else arb(0).union(arb(x.upper()).sqrt())


def scaled(n: Numbers, z: Roots, factor: Any, unit: Any = 1) -> Any:
    """R det(unit·I − κK M), factor = 2πi κ, where an upper root a may meet a lower root c: R cancels by algebra."""
    (a, b), (c, e) = z.upper, z.lower
    if len(n.eta) > 2:
        return det(bordered_rows(n, z, factor, unit))
    # R c_a + R c_b with R c_a = (b − c)(b − e)/(a − b), R c_b = −(a − c)(a − e)/(a − b)
    value = unit * z.resultant - factor * sum(n.eta, arb(0)) * (a + b) * -2
    if len(n.eta) == 2:
        # R c_j c_l (1 − e^{i(p_j − p_l)d}), e.g. (b − e)/((a − b)(a − c)(c − e)) (1 − …) for j, l = a, c
        d = n.x[1] - n.x[0]
        pairs = (b - e) * entire(a - c, d) - (b - c) * entire(a - e, d)
        pairs += (a - c) * entire(b - e, d) - (a - e) * entire(b - c, d)
        value = unit * value - factor * factor * (n.eta[0] * n.eta[1]) * pairs / ((a - b) * (c - e))
    return value


def residue(z: Roots, k: int) -> Any:
    every = [*z.upper, *z.lower]
    result = acb(1)
    for j, other in enumerate(every):
        if j != k:
            result *= every[k] - other
    return 1 / result


def edge_waves(n: Numbers, z: Roots) -> list[list[Any]]:
    """K_ik/(2πi): Σ e^{ipξ}/D_p over the upper roots, −Σ over the lower ones, with D_p = Π (p − p')."""
    c = [residue(z, k) for k in range(4)]
    ahead, behind = list(zip(z.upper, c[:2], strict=True)), list(zip(z.lower, c[2:], strict=True))
    contact = c[0] + c[1]
    rows = []
    for i, xi in enumerate(n.x):
        row = []
        for k, xk in enumerate(n.x):
            if i == k:
                row.append(contact)
            else:
                value = sum(((I * p * (xi - xk)).exp() * w for p, w in (ahead if i > k else behind)), acb(0))
                row.append(value if i > k else -value)
        rows.append(row)
    return rows


def edge_rows(n: Numbers, waves: list[list[Any]], factor: Any, unit: Any = 1) -> list[list[Any]]:
    """unit·I − κK M, factor = 2πi κ."""
    return [[int(i == k) * unit - factor * w * n.eta[k] for k, w in enumerate(row)] for i, row in enumerate(waves)]


def bordered_rows(n: Numbers, z: Roots, factor: Any, unit: Any = 1) -> list[list[Any]]:
    """A matrix with determinant R det(unit·I − κK M), finite where the nearest roots a (above) and c (below) meet.

    K/(2πi) = c_a e^{ia(x_i − x_k)} + F_ik with F finite: the pole of K at a = c has rank one.
    """
    pairs = [(u, v, w, x) for u, v in (z.upper, z.upper[::-1]) for w, x in (z.lower, z.lower[::-1])]
    a, b, c, e = min(pairs, key=lambda t: float(abs(t[0].mid() - t[2].mid())))
    rows = []
    for i, xi in enumerate(n.x):
        row = []
        for k, xk in enumerate(n.x):
            x = xi - xk if i != k else arb(0)
            if i >= k:
                f = (I * b * x).exp() / ((b - a) * (b - c) * (b - e))
            else:
                g_a, g_c = (a - b) * (a - e), (c - b) * (c - e)
                gap = -entire(a - c, x) / g_a - (a + c - b - e) / (g_a * g_c)
                f = -(I * e * x).exp() / ((e - a) * (e - b) * (e - c)) - (I * c * x).exp() * gap
            row.append(int(i == k) * unit - factor * f * n.eta[k])
        rows.append([*row, factor * (b - c) * (b - e) / (a - b) * (I * a * xi).exp()])
    return [*rows, [*(eta * (-I * a * x).exp() for eta, x in zip(n.eta, n.x, strict=True)), z.resultant]]


def entire(z: Any, x: Any) -> Any:
    """(1 − e^{izx})/z."""
    if isinstance(z, Dual):
        return z.entire(x)
    w = z * x / 2
    if w.abs_lower() > 0.5:
        return (1 - (2 * I * w).exp()) / z
    return -I * x * (I * w).exp() * w.sinc()


# --- arguments and windings --------------------------------------------------------------------------------


def in_half_plane(value: Any) -> bool:
    return bool((value * value.mid().conjugate()).real > 0)


def turning(middles: Sequence[Any], first: Any, last: Any) -> Any:
    """The change of argument along pieces that each keep to a half-plane about their middle value."""
    chain = [first, *middles, last]
    return sum(((b / a).arg() for a, b in pairwise(chain)), arb(0))


def along(function: Callable[[Any], Sequence[Any]], breaks: Sequence[Fraction], name: str) -> list[tuple[Any, ...]]:
    """The middle values of every piece, each proved to keep to a half-plane."""
    result = []
    for k, (start, end) in enumerate(pairwise(breaks)):
        try:
            values = function(ball(start).union(ball(end)))
        except Refused as error:
            raise Refused(f"{name}, piece {k}: {error}") from None
        require(all(v.is_finite() and in_half_plane(v) for v in values), f"{name}, piece {k}: not in a half-plane")
        result.append(tuple(v.mid() for v in values))
    return result


def confirms(n: Numbers, kind: str) -> Callable[[Any], bool]:
    """Whether a piece of a contour would pass: for a maker of certificates, which may cut it finer."""

    def accept(piece: Any) -> bool:
        try:
            values = edge(n, piece) if kind == "edge" else [value_off_cut(n, acb(piece))]
        except Refused:
            return False
        return all(v.is_finite() and in_half_plane(v) for v in values)

    return accept


def the_integer(value: Any, name: str) -> int:
    n = value.unique_fmpz()
    require(n is not None, f"{name}: the ball {value.str(5)} holds no single integer")
    return int(n)


def breakpoints(values: Any, name: str) -> list[Fraction]:
    require(
        isinstance(values, list) and 2 <= len(values) <= MAX_PIECES, f"{name}: no list of breakpoints, or too long"
    )
    points = [dyadic(v) for v in values]
    require(all(a < b for a, b in pairwise(points)), f"{name}: breakpoints are not in order")
    return points


def count_on_edge(p: Problem, n: Numbers, points: list[Fraction]) -> int:
    """The number of zeros on the whole sheet, from both sides of the cut and the far field."""
    start, reach = ball(points[0]), ball(points[-1])
    far_field(n, reach)
    middles = along(lambda r: edge(n, r), points, "the edge of the cut")
    first, last = edge(n, start), edge(n, reach)
    far = roots_on_cut(n, reach)
    halves = []
    for k, sign in enumerate((1, -1)):
        q = acb(reach, sign * n.eta_b)
        lead = (-far.resultant / (32 * reach**2)).arg()
        end = lead + far_argument(n, far, q, det(edge_rows(n, edge_waves(n, far), 4 * I * q * q)))
        halves.append(1 + (end - turning([m[k] for m in middles], first[k], last[k])) / arb.pi())
    if p.at_rest and not n.single_at_rest:
        return the_integer(halves[0] + halves[1] + round_the_branch_point(n, start, first) / arb.pi(), "the sheet")
    turn = arb(0)
    if n.single_at_rest:  # of s = a + b from edge to edge, which G±/s leaves out
        turn = 1 - 2 * (far.upper[0] + far.upper[1]).arg() / arb.pi()
    at_start = roots_at_start(n, start)
    if points[0] == 0:
        require(at_start, "the contour starts at 0, but the cuts are not joined there")
        return the_integer(halves[0], "below the cut") + the_integer(halves[1], "above the cut")
    require(not at_start, "the contour starts on the cut, so that a part of the cut is missing")
    return the_integer(halves[0] + halves[1] + turn, "the sheet")


def roots_at_start(n: Numbers, r: Any) -> bool:
    """Whether D has a real p-root at the point r: True or False as proved."""
    if any(
        (w := p_root(n, r, z.real)) is not None and w.is_finite()
        for z in seeds(n, r)
        if abs(z.imag) < abs(z) * arb(2) ** -20
    ):
        return True
    found = [p_root(n, r, z) for z in seeds(n, r)]
    require(all(w is not None and not w.imag.contains(0) for w in found), "the p-roots at the start are open")
    apart(found)
    return False


def count_on_line(n: Numbers, points: list[Fraction]) -> int:
    """The number of zeros with Im q < 0, from Δ on 0 ≤ q ≤ reach."""
    require(points[0] == 0 and n.eta_b > 0, "the line does not start at 0, or there is no damping")
    reach = ball(points[-1])
    far_field(n, reach)
    middles = along(lambda q: [value_off_cut(n, acb(q))], points, "the real line")
    q = acb(reach)
    last = value_off_cut(n, q)
    far = far_argument(n, roots_off_cut(n, q), q, last)
    return the_integer((far - turning([m[0] for m in middles], acb(1), last)) / arb.pi(), "Im q < 0")


def count_in_rectangle(n: Numbers, contour: Any) -> tuple[int, tuple[Any, ...]]:
    """The number of zeros in the rectangle, from its four sides, counterclockwise from the lower left corner."""
    keys(contour["bounds"], {"re_min", "re_max", "im_min", "im_max"})
    exact = [real(contour["bounds"][k], k) for k in ("re_min", "re_max", "im_min", "im_max")]
    require(all(x.rational is not None for x in exact), "a bound is not rational")
    require(exact[0].quartic < exact[1].quartic and exact[2].quartic < exact[3].quartic, "bounds are not in order")
    left, right, bottom, top = (x.ball() for x in exact)
    on_line = cuts_on_line(n)
    below = top < n.eta_b if on_line else exact[3].quartic <= 0 and n.eta_b > 0
    off = below or (on_line and bottom > n.eta_b)
    # both ends of its range in the gap of the cuts, which is one interval about 0
    off = off or (on_line and not roots_at_start(n, left) and not roots_at_start(n, right))
    require(off, "the rectangle may meet the cuts")
    corners = [acb(left, bottom), acb(right, bottom), acb(right, top), acb(left, top)]
    values = [value_off_cut(n, q) for q in corners]
    require(isinstance(contour["sides"], list) and len(contour["sides"]) == 4, "the rectangle has not four sides")
    total = arb(0)
    for k, side in enumerate(contour["sides"]):
        points = breakpoints(side, f"side {k}")
        require(points[0] == 0 and points[-1] == 1, f"side {k} does not run from 0 to 1")
        a, b = corners[k], corners[(k + 1) % 4]

        def value(t: Any, a: Any = a, b: Any = b) -> Sequence[Any]:
            return [value_off_cut(n, a + t * (b - a))]

        middles = along(value, points, f"side {k}")
        total += turning([m[0] for m in middles], values[k], values[(k + 1) % 4])
    return the_integer(total / (2 * arb.pi()), "the rectangle"), (left, right, bottom, top)


def cuts_on_line(n: Numbers) -> bool:
    """η_b < 1 and N < β."""
    return bool(n.beta2 > 0 and n.axial < n.beta2.sqrt())


# --- the far field ------------------------------------------------------------------------------------------


def largest(values: Sequence[Any]) -> Any:
    top = arb(0)
    for value in values:
        top = top.max(arb(abs(value).upper()))
    return top


def far_field(n: Numbers, reach: Any) -> None:
    """Proves that no zero of Δ has |r| ≥ reach (section "Far field" of the specification)."""
    W, units = (2 * reach).sqrt(), (acb(1), I, acb(-1), -I)
    w = arb(0, (1 / W).upper())
    u = acb(w, w)
    P, E = [], []
    for c in units:
        s = -n.alpha * c * c
        q2, q3 = 6 * c * c * s * s - 4 * n.A * c * c + 4 * n.alpha * s, 4 * c * s**3 - 8 * n.A * c * s
        q4 = s**4 - 4 * n.A * s * s + 4 * n.beta2
        rest = u**2 * (q2 + q3 * u + q4 * u**2)
        size = arb(0, (abs(rest) / 2 + w.rad() * arb(2) ** -40).upper())
        box = acb(size, size)
        root = c + s * u + box
        shift = -rest / (4 * root**3 - 8 * n.A * u**2 * root + 4 * n.alpha * u)
        require(shift.is_finite() and box.contains_interior(shift), "far field: p-roots")
        root, t = c + s * u + shift, s * u + shift
        y = (12 * c * c * shift + 12 * c * t**2 + 4 * t**3 - 8 * n.A * u**2 * root) * c / 4
        x = 2 * n.alpha * c * u - y
        require(abs(x) < 1, "far field: residues")
        P.append(root)
        E.append(x * x / (1 - x) - y)
    resultant = (P[0] - P[2]) * (P[0] - P[3]) * (P[1] - P[2]) * (P[1] - P[3])
    require((resultant / -8).real > 0, "far field: the resultant")
    gain = (1 + 2 * I * n.eta_b * u**2) ** 2
    contact = gain * (1 + I + E[0] + I * E[1])
    require((-I * contact).real > 0 and (-I * contact).imag < 0, "far field: the diagonal")
    if len(n.eta) > 1:
        spread = largest([p - c for p, c in zip(P, units, strict=True)])
        rate = W * (1 / arb(2).sqrt() - spread)
        require(rate > 0, "far field: evanescent waves")
        decay = largest([(-rate * (b - a)).exp() for a, b in pairwise(n.x)])
        tilt = 2 * n.alpha * u
        (two_masses if len(n.eta) == 2 else many_masses)(len(n.eta), E, tilt, gain, contact, decay)


def travelling(E: Sequence[Any], tilt: Any, k: int) -> tuple[Any, Any, Any]:
    """F = 4C_k/c, B = 4C_{k+2}/(−c), and F B with its first order cancelled, c = i^k."""
    t = tilt * (acb(1), I)[k]
    product = 1 - t * t + E[k] * (1 - t) + E[k + 2] * (1 + t) + E[k] * E[k + 2]
    return 1 + t + E[k], 1 - t + E[k + 2], product


def two_masses(_: int, E: Sequence[Any], tilt: Any, gain: Any, contact: Any, decay: Any) -> None:
    sides = [travelling(E, tilt, k) for k in (0, 1)]
    main, size = largest([s[2] for s in sides]), largest([x for s in sides for x in s[:2]])
    waves = main + 2 * size**2 * decay + main * decay**2
    require((abs(gain) / abs(contact)) ** 2 * waves < 1, "far field: two masses")


def many_masses(n: int, E: Sequence[Any], tilt: Any, gain: Any, contact: Any, decay: Any) -> None:
    root2 = arb(2).sqrt()
    shift = abs(contact - 1 - I) / root2
    require(shift < 1, "far field: the diagonal of many masses")
    size = largest([x for k in (0, 1) for x in travelling(E, tilt, k)[:2]])
    for k in (0, 1):
        mean = travelling(E, tilt, k)[2].sqrt()
        change = (abs(gain * mean - 1) + shift) / (1 - shift) / root2
        g, skew = 1 / root2 + change, abs((2 + E[k] + E[k + 2]) / mean - 2)
        z, floor = arb(1), arb(1)
        for _ in range(n - 1):
            require(g * z < 1 and z < root2, "far field: reflections")
            floor *= 1 - g * z
            passive = (1 + (z * z - 1) / (root2 - z) ** 2).sqrt()
            z = largest(
                [arb(1), passive + (z * (2 * change + g * skew) + change + passive * z * change) / (1 - g * z)]
            )
        coupling = abs(gain) * size / (root2 * (1 - shift))
        error = coupling * decay
        row = (1 + (n - 1) * (coupling + error) ** 2).sqrt()
        require(n * arb(n - 1).sqrt() * error * row ** (n - 1) < floor, "far field: many masses")


def far_argument(n: Numbers, z: Roots, q: Any, value: Any) -> Any:
    """arg Δ at q beyond the far radius, from the factors of Δ that keep to half-planes there."""
    a, b = sorted(z.upper, key=lambda p: abs(float(p.imag.mid())))
    c, e = sorted(z.lower, key=lambda p: abs(float(p.imag.mid())))
    ahead, behind = 1 / ((a - b) * (a - c) * (a - e)), -1 / ((c - a) * (c - b) * (c - e))
    contact = ahead + 1 / ((b - a) * (b - c) * (b - e))
    factors = [1 - 4 * I * q * q * eta * contact for eta in n.eta]
    if len(n.eta) > 2:
        reflection = acb(0)
        for j in reversed(range(len(n.eta))):
            wave = (I * (a - c) * (n.x[j + 1] - n.x[j])).exp() * reflection if j + 1 < len(n.eta) else acb(0)
            scale = -4 * I * q * q * n.eta[j] / factors[j]
            factors.append(1 + scale * behind * wave)
            reflection = (wave * (1 - scale * (ahead + behind)) - scale * ahead) / factors[-1]
    total = arb(0)
    for factor in factors:
        total += factor.arg()
        value = value / factor
    return total + value.arg()


# --- the load at rest: α = N = 0, D = p⁴ − w⁴, w⁴ = 4(r² − β²) ----------------------------------------------


def round_the_branch_point(n: Numbers, start: Any, first: tuple[Any, Any]) -> Any:
    """The change of argument round r = β, and the proof that no zero has |w|⁴ ≤ 4(start² − β²)."""
    radius, outer, samples = (4 * (start**2 - n.beta2)).sqrt().sqrt(), n.beta2.sqrt().sqrt() / 2, 16
    require(radius < outer, "the start is too far from the branch point at rest")
    rim = [outer * acb(arb(2 * k) / 64 + arb(0, (arb(1) / 64).upper())).exp_pi_i() for k in range(64)]
    bound = largest([at_rest(n, w) for w in rim])
    coefficients = taylor(lambda w: at_rest(n, w), acb(0), outer, bound, outer / 4, samples)
    require(pellet(coefficients, 0, radius, bound, outer), "a zero next to the branch point at rest")
    turn = first[1].conjugate() / first[0]
    return turn.arg()


def at_rest(n: Numbers, w: Any) -> Any:
    """R Δ = −8 w⁴ Δ as a function of w; p-roots −w, iw above and w, −iw below."""
    q = (acb(n.beta2) + w**4 / 4).sqrt() + I * n.eta_b
    z = Roots((-w, I * w), (w, -I * w))
    return -8 * w**4 * det(edge_rows(n, edge_waves(n, z), 4 * I * q * q))


def taylor(f: Callable[[Any], Any], centre: Any, outer: Any, bound: Any, inner: Any, samples: int) -> list[Any]:
    """Taylor coefficients from samples on |z| = inner; |f| ≤ bound on |z| = outer bounds what they cannot see."""
    turns = [acb(arb(2 * j) / samples).exp_pi_i() for j in range(samples)]
    values = [f(centre + inner * t) for t in turns]
    ratio = (inner / outer) ** samples
    result = []
    for k in range(samples):
        total = sum((v / turns[j * k % samples] for j, v in enumerate(values)), acb(0)) / samples
        error = arb(0, (bound * ratio / (1 - ratio) / outer**k).upper())
        result.append(total / inner**k + acb(error, error))
    return result


def pellet(coefficients: Sequence[Any], m: int, radius: Any, bound: Any, outer: Any) -> bool:
    """Exactly m zeros in |z| < radius, if the term m outweighs all others there."""
    ratio = radius / outer
    others = bound * ratio ** len(coefficients) / (1 - ratio)
    others += sum((abs(a) * radius**k for k, a in enumerate(coefficients) if k != m), arb(0))
    return bool(radius > 0 and ratio < 1 and abs(coefficients[m]) * radius**m > others)


# --- roots and the verdict ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Root:
    re: int
    im: int
    exponent: int
    multiplicity: int
    axis: str

    @property
    def radius(self) -> Any:
        return arb((29, self.exponent - 6 + (10 if self.multiplicity > 1 else 0)))

    @property
    def centre(self) -> Any:
        return acb(arb((self.re, self.exponent)), arb((self.im, self.exponent)))

    @property
    def box(self) -> Any:
        reach = arb(0, self.radius)
        return acb(self.centre.real + reach, self.centre.imag + reach)

    @property
    def bits(self) -> int:
        return max(self.re.bit_length(), self.im.bit_length())


def root(value: Any) -> Root:
    keys(value, {"re", "im", "exponent", "multiplicity", "axis"})
    exponent = integer(value["exponent"], -2 * MAX_BITS, 60, "an exponent")
    number = integer(value["multiplicity"], 1, MAX_ROOTS, "a multiplicity")
    axis = value["axis"]
    require(axis in ("none", "real", "imaginary"), "an axis is unknown")
    found = Root(mantissa(value["re"]), mantissa(value["im"]), exponent, number, axis)
    require(found.bits <= MAX_BITS, "a root has too many digits")
    require(
        axis == "none" or (number == 1 and (found.im if axis == "real" else found.re) == 0), "a root is off its axis"
    )
    return found


def check_root(p: Problem, found: Root, mirrored: bool) -> None:
    """Proves that the box holds exactly `multiplicity` roots, on the physical sheet."""
    if mirrored:
        return  # the mirror image −q̄ of a root that has been checked: Δ(−q̄) is the conjugate of Δ(q)
    with precision(2 * found.bits + 64 if found.multiplicity > 1 else found.bits + 48):
        n = numbers(p)
        require(n.axial < 1, "the beam buckles without any load")
        if found.multiplicity > 1:
            check_cluster(n, found)
            return
        require(found.axis != "real" or not p.eta_b.quartic, "a real root needs an undamped track")
        slope = delta_off_cut(n, found.box)[1]
        step = value_off_cut(n, found.centre) / slope
        # against the half-width itself: the radius of a ball is rounded up
        inside = abs(step.real) < found.radius and abs(step.imag) < found.radius
        require(step.is_finite() and inside, "interval Newton does not confirm it")


def check_cluster(n: Numbers, found: Root) -> None:
    """Pellet's test for the disc in the square box and for the disc around it."""
    centre, size = found.centre, max(abs(found.re), abs(found.im)).bit_length() + found.exponent
    outer = arb((1, size - 16))
    spread = arb(0, outer)
    bound = largest([value_off_cut(n, centre + acb(spread, spread))])
    inner = outer * arb((1, -(2 * found.bits // 16)))
    coefficients = taylor(lambda q: value_off_cut(n, q), centre, outer, bound, inner, 16)
    for radius in (found.radius, found.radius * arb(2).sqrt() * (1 + arb((1, -40)))):
        require(pellet(coefficients, found.multiplicity, radius, bound, outer), "Pellet's test does not confirm it")


def check_roots(p: Problem, values: Any) -> list[Root]:
    require(isinstance(values, list) and len(values) <= MAX_ROOTS, "roots are no list, or too many")
    roots = [root(v) for v in values]
    require(sum(r.bits for r in roots) <= MAX_ALL_BITS, "the roots have too many digits in all")
    seen: set[Root] = set()
    for k, found in enumerate(roots):
        mirror = Root(-found.re, found.im, found.exponent, found.multiplicity, found.axis)
        try:
            check_root(p, found, mirror in seen)
        except Refused as error:
            raise Refused(f"root {k}: {error}") from None
        seen.add(found)
    with precision(2 * max((r.bits for r in roots), default=0) + 64):
        for k, found in enumerate(roots):
            require(not any(found.box.overlaps(o.box) for o in roots[:k]), f"root {k} overlaps another")
    return roots


def check_inside(contour: Any, roots: list[Root]) -> None:
    """The box of each root lies inside the region whose roots were counted (the whole sheet needs no test)."""
    for k, found in enumerate(roots):
        with precision(2 * found.bits + 64):
            box = found.box
            if contour["kind"] == "line":
                require(box.imag < 0, f"root {k} is not in Im q < 0")
            if contour["kind"] == "rectangle":
                left, right, bottom, top = (
                    real(contour["bounds"][name], name).ball() for name in ("re_min", "re_max", "im_min", "im_max")
                )
                inside = box.real > left and box.real < right and box.imag > bottom and box.imag < top
                require(inside, f"root {k} is not inside the rectangle")


def check(content: dict[str, Any]) -> str:
    """The claim in words, if every step of the certificate holds."""
    return check_crossings(content) if content["kind"] == "crossings" else check_frequencies(content)[0]


def spectrum_work(p: Problem, content: dict[str, Any]) -> int:
    """The work that a certificate of induced frequencies asks for, as far as it can be read off the lists in it."""
    contour, places = content["contour"], len(p.places)
    lists = [contour.get("breaks"), *(contour["sides"] if isinstance(contour.get("sides"), list) else ())]
    pieces = sum(len(one) for one in lists if isinstance(one, list))
    bits = integer(contour.get("bits"), 53, MAX_CONTOUR_BITS, "bits")
    total = pieces * work(places, bits + 16)
    require(isinstance(content["roots"], list), "roots are no list")
    for value in content["roots"]:
        found = root(value)
        if found.multiplicity > 1:
            total += 20 * work(places, 2 * found.bits + 64)
        else:
            total += 2 * work(places, found.bits + 48)
    return total


def check_frequencies(content: dict[str, Any]) -> tuple[str, list[Root]]:
    """The claim in words and the roots, if every step of a certificate of induced frequencies holds."""
    p, contour = problem(content["case"]), content["contour"]
    require(isinstance(contour, dict) and contour.get("kind") in ("edge", "line", "rectangle"), "no known contour")
    rectangle = contour["kind"] == "rectangle"
    keys(contour, {"kind", "bits"} | ({"bounds", "sides"} if rectangle else {"radius", "breaks"}))
    require(
        spectrum_work(p, content) <= MAX_WORK, "it asks for too much work: too many pieces, roots, masses or digits"
    )
    roots = check_roots(p, content["roots"])
    check_inside(contour, roots)
    with precision(integer(contour["bits"], 53, MAX_CONTOUR_BITS, "bits") + 16):
        n = numbers(p)
        require(n.axial < 1, "the beam buckles without any load")
        if rectangle:
            count = count_in_rectangle(n, contour)[0]
        else:
            points = breakpoints(contour["breaks"], "the contour")
            require(points[-1] == dyadic(contour["radius"]), "the contour does not end at the radius")
            if contour["kind"] == "edge":
                require(cuts_on_line(n), "the cuts are not on the line Im q = eta_b")
                count = count_on_edge(p, n, points)
            else:
                count = count_on_line(n, points)
    return conclude(content, contour["kind"], roots, count), roots


def conclude(content: dict[str, Any], kind: str, roots: list[Root], count: int) -> str:
    """Count, enclosures and claim agree."""
    claim = content["claim"]
    keys(claim, {"count"}, frozenset({"unstable"}))
    listed = content["identity"]
    require(isinstance(listed, list) and all(type(m) is int for m in listed), "the identity is no list of integers")
    require(listed == [r.multiplicity for r in roots], "the identity does not list the multiplicities")
    total = sum(r.multiplicity for r in roots)
    require(
        claim["count"] == total and type(claim["count"]) is int, f"{total} roots are enclosed, not the number claimed"
    )
    require(total == count, f"the winding number is {count}, but {total} roots are enclosed")
    where = {"edge": "on the whole physical sheet", "line": "with Im q < 0", "rectangle": ""}[kind]
    if kind == "rectangle":
        low, high, down, up = (
            said(content["contour"]["bounds"][k]) for k in ("re_min", "re_max", "im_min", "im_max")
        )
        where = f"with {low} < Re q < {high}, {down} < Im q < {up}"
    words = f"exactly {count} induced frequencies {where}"
    if "unstable" in claim:
        words += f", {unstable(claim['unstable'], roots)} of them with Im q < 0"
    return f"{words}; {case_said(content['case'])}"


def case_said(case: dict[str, Any], free: str = "") -> str:
    """The case in its exact numbers; without the parameter that is free."""
    names = [name for name in ("alpha", "eta_b", "eta_n", "eta_s") if name != free]
    values = [f"{name} = {said(case[name])}" for name in names]
    ratio = "eta_m in the ratio" if free == "level" else "eta_m ="
    masses = f"{ratio} {', '.join(map(said, case['eta_m']))}"
    places = "at 0, d, 2d, …" if free == "distance" else f"at {', '.join(map(said, case['positions']))}"
    return f"case {', '.join(values)}, {masses} {places}"


def said(number: str) -> str:
    """An exact number; a long one by its first digits and its digest, which two different numbers do not share."""
    if len(number) <= 40:
        return number
    return f"{number[:24]}… ({len(number)} characters, sha256 {hashlib.sha256(number.encode()).hexdigest()[:16]})"


def unstable(claimed: Any, roots: list[Root]) -> int:
    number = 0
    for k, found in enumerate(roots):
        with precision(found.bits + 64):
            imag = found.box.imag
        above = found.axis == "real" or imag >= 0
        below = found.axis != "real" and imag < 0
        require(above or below, f"root {k} may have either sign of Im q")
        number += found.multiplicity if below else 0
    require(claimed == number and type(claimed) is int, f"{number} roots have Im q < 0, not the number claimed")
    return number


# --- crossings: numbers with slopes ---------------------------------------------------------------------------


class Dual:
    """value + x·ε + t·ε' to first order: a number and its slopes along x and t, in balls.

    Constants may be balls or integers. The slopes of balls of arguments hold all slopes over these balls.
    """

    __slots__ = ("t", "value", "x")

    def __init__(self, value: Any, x: Any, t: Any) -> None:
        self.value, self.x, self.t = value, x, t

    def __add__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value + other.value, self.x + other.x, self.t + other.t)
        return Dual(self.value + other, self.x, self.t)

    __radd__ = __add__

    def __neg__(self) -> Dual:
        return Dual(-self.value, -self.x, -self.t)

    def __sub__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            return Dual(self.value - other.value, self.x - other.x, self.t - other.t)
        return Dual(self.value - other, self.x, self.t)

    def __rsub__(self, other: Any) -> Dual:
        return Dual(other - self.value, -self.x, -self.t)

    def __mul__(self, other: Any) -> Dual:
        if isinstance(other, Dual):
            a, b = self.value, other.value
            return Dual(a * b, a * other.x + self.x * b, a * other.t + self.t * b)
        return Dual(self.value * other, self.x * other, self.t * other)

    __rmul__ = __mul__

    def inverse(self) -> Dual:
        u = 1 / self.value
        rate = -(u * u)
        return Dual(u, rate * self.x, rate * self.t)

    def __truediv__(self, other: Any) -> Dual:
        return self * (other.inverse() if isinstance(other, Dual) else 1 / other)

    def __rtruediv__(self, other: Any) -> Dual:
        u: Dual = self.inverse() * other
        return u

    def exp(self) -> Dual:
        e = self.value.exp()
        return Dual(e, e * self.x, e * self.t)

    def mid(self) -> Any:
        return self.value.mid()

    def entire(self, length: Any) -> Dual:
        """(1 − e^{izx})/z of a dual z and a length x, which may be dual."""
        x = length.value if isinstance(length, Dual) else length
        rate = entire_slope(self.value, x)
        result = Dual(entire(self.value, x), rate * self.x, rate * self.t)
        if isinstance(length, Dual):
            along = -I * (I * self.value * x).exp()
            result = Dual(result.value, result.x + along * length.x, result.t + along * length.t)
        return result


def entire_slope(z: Any, x: Any) -> Any:
    """The derivative of (1 − e^{izx})/z along z: x² times −Σ_{k≥2} i^k (k − 1) w^{k−2}/k!, w = zx."""
    w = z * x
    if w.abs_lower() > 0.5:
        wave = (I * w).exp()
        return -((1 - wave) / z + I * x * wave) / z
    terms, top = 18, arb(abs(w).upper())
    total, power, unit, factorial = acb(0), acb(1), acb(-1), 2  # unit = i^k, factorial = k!
    for k in range(2, terms):
        total -= unit * power * (k - 1) / factorial
        power, unit, factorial = power * w, unit * I, factorial * (k + 1)
    # (k − 1)/k! ≤ 1/(k − 2)!, and Σ_{k≥n} s^{k−2}/(k − 2)! ≤ s^{n−2} e^s/(n − 2)!
    rest = arb(0, (top ** (terms - 2) * top.exp() / math.factorial(terms - 2)).upper())
    return x * x * (total + acb(rest, rest))


def det_of_duals(rows: Sequence[Sequence[Dual]]) -> Dual:
    """The product rule: row by row replaced by its slopes."""
    values = [[entry.value for entry in row] for row in rows]
    slopes = []
    for along in ("x", "t"):
        rates = [[getattr(entry, along) for entry in row] for row in rows]
        slopes.append(sum((det([*values[:k], rates[k], *values[k + 1 :]]) for k in range(len(rows))), acb(0)))
    return Dual(det(values), *slopes)


# --- crossings: a family of cases ------------------------------------------------------------------------------


@dataclass(frozen=True)
class Family:
    """A case with one free parameter t, on the line q = x + i·height, in balls at the present precision.

    The function is R·F, which has the zeros of F: F = Δ, or, for a free level u of all masses,
    det[(1 − u)I − u(1 + q²)KM].
    """

    case: Numbers
    parameter: str
    height: Any

    def at(self, t: Any) -> Numbers:
        """The numbers at t; the places of "distance" are put round 0, where their differences are thinnest."""
        n = self.case
        if self.parameter == "alpha":
            return Numbers(t, n.axial, n.eta_b, n.eta, n.x)
        if self.parameter == "eta_b":
            return Numbers(n.alpha, n.axial, t, n.eta, n.x)
        if self.parameter == "distance":
            return Numbers(n.alpha, n.axial, n.eta_b, n.eta, tuple(t * k for k in self.places))
        return n

    @property
    def places(self) -> list[Any]:
        last = len(self.case.eta) - 1
        return [arb(2 * k - last) / 2 for k in range(last + 1)]

    def weights(self, q: Any, t: Any) -> tuple[Any, Any]:
        """(2πi κ, unit) in det[unit·I − κKM], κ = 2q²/π and unit = 1; or κ = u(1 + q²) and unit = 1 − u."""
        square = q * q
        return (2 * arb.pi() * I * t * (1 + square), 1 - t) if self.parameter == "level" else (4 * I * square, 1)


class Box:
    """x and t in a box: their middles, exact, and what they move by, balls about 0."""

    def __init__(self, family: Family, x: Any, t: Any, dx: Any, dt: Any) -> None:
        still = arb(0)
        self.family, self.x0, self.t0, self.dx, self.dt = family, x, t, dx, dt
        self.q0 = acb(x, family.height)
        self.q, self.t = acb(x + dx, family.height), t + dt
        self.middle, self.over = family.at(t), family.at(self.t)
        self.r0, self.r = self.q0 - I * self.middle.eta_b, self.q - I * self.over.eta_b
        self.dalpha = dt if family.parameter == "alpha" else still
        self.deta = dt if family.parameter == "eta_b" else still
        require(self.over.eta_b > 0 and family.height <= 0, "a box may meet a cut")

    def centre(self) -> Box:
        """The middle alone."""
        still = arb(0)
        return Box(self.family, self.x0, self.t0, still, still)

    def quartic(self, p: Any) -> Any:
        """D(p) over the box, as its value at the middle and what x, α and η_b change, without any cancellation."""
        g, u = self.r0 - self.middle.alpha * p, self.dx - self.dalpha * p
        change = u * (2 * g + u) - 2 * I * self.deta * (g + u + I * self.middle.eta_b)
        return quartic(self.middle, p, self.r0) - 4 * change

    def weights(self) -> tuple[Any, Any]:
        return self.family.weights(self.q, self.t)


# --- crossings: p-roots over a box -----------------------------------------------------------------------------


@dataclass
class Branch:
    """One p-root over a box: `area` holds this root only, `root` holds it; D(seed) lies in `value`."""

    seed: Any
    value: Any
    area: Any
    root: Any


@dataclass(frozen=True)
class Branches:
    """The p-roots over a box, with sides: all four apart, or an upper and a lower one in one ball (`met`)."""

    roots: Roots
    met: bool
    order: tuple[Branch, ...] = ()  # of a, b, c, e, if none is met


@dataclass(frozen=True)
class Beside:
    """Two p-roots on one side; of the other two, both on the side `sign`, the sum and the product are known."""

    known: tuple[Any, Any]
    sign: int
    total: Any
    product: Any


def branch(box: Box, seed: Any) -> Branch | None:
    """The one p-root near the seed, for every point of the box: interval Newton, or None."""
    value = box.quartic(seed)
    reach = abs(value / D_p(box.middle, seed, box.r0)) + abs(seed) * arb(2) ** (4 - flint.ctx.prec)
    for widening in (1.5, 2.5):
        size = arb(0, (reach * widening).upper())
        area = seed + acb(size, size)
        image = seed - value / D_p(box.over, area, box.r)
        if image.is_finite() and area.contains_interior(image):
            return Branch(seed, value, area, image)
    return None


def branches(box: Box, seeds: Sequence[complex]) -> Branches | Beside | None:
    """All p-roots over the box, as far as needed: None if more than two of them are not told apart."""
    fine = flint.ctx.prec > 64
    points = [polished(box.middle, box.r0, acb(z)) if fine else acb(z) for z in seeds]
    found = [branch(box, point) for point in points]
    known = alone(one for one in found if one is not None)
    if len(known) == 3:  # three different roots: the last one, by the sum 0 of all
        point, last = points[found.index(None)], -(known[0].root + known[1].root + known[2].root)
        known = alone([*known, Branch(point, box.quartic(point), last, last)])
    if len(known) not in (2, 4):
        return None
    if len(known) == 4:
        sharpen(known)
    sides = [side_of(box, one) for one in known]
    upper = [one for one, side in zip(known, sides, strict=True) if side > 0]
    lower = [one for one, side in zip(known, sides, strict=True) if side < 0]
    if len(upper) + len(lower) != len(known):
        return None
    if len(known) == 2:
        return with_lost_pair(box.over, [one.root for one in upper], [one.root for one in lower])
    require(len(upper) == 2, "a p-root is on the wrong side")
    roots = Roots((upper[0].root, upper[1].root), (lower[0].root, lower[1].root))
    return Branches(roots, False, (*upper, *lower))


def alone(found: Iterable[Branch]) -> list[Branch]:
    """Those whose balls meet no other: they hold different roots."""
    every = list(found)
    return [one for one in every if not any(one.root.overlaps(o.root) for o in every if o is not one)]


def sharpen(found: Sequence[Branch]) -> None:
    """D(m) = Π (m − p') gives p = m − D(m)/Π (m − p') over the three others."""
    areas = [one.root for one in found]
    for k, one in enumerate(found):
        others = acb(1)
        for j, area in enumerate(areas):
            if j != k:
                others *= one.seed - area
        sharper = one.seed - one.value / others
        if sharper.is_finite() and sharper.rad() < one.root.rad():
            one.root = sharper


def side_of(box: Box, one: Branch) -> int:
    """+1 above the real axis, −1 below it, 0 if open. No cut meets the box, so it may be told at the middle."""
    imag = one.root.imag
    if not (imag > 0 or imag < 0):
        still = branch(box.centre(), one.seed)
        if still is None or not one.area.contains(still.root):
            return 0
        imag = still.root.imag
    return 1 if imag > 0 else -1 if imag < 0 else 0


def with_lost_pair(n: Numbers, upper: list[Any], lower: list[Any]) -> Branches | Beside:
    """The other two of the four roots by Vieta: sum s, product s² − 4A − π, with −s and π of the known two."""
    one, two = [*upper, *lower]
    total = -(one + two)
    product = total * total - 4 * n.A - one * two
    if not (upper and lower):
        return Beside((one, two), -1 if upper else 1, total, product)
    size = arb(0, abs(total * total / 4 - product).upper().sqrt().upper())
    pair = total / 2 + acb(size, size)
    return Branches(Roots((pair, upper[0]), (pair, lower[0])), True)


def seeds_at(box: Box, start: Sequence[complex]) -> list[complex]:
    """Approximate p-roots at the middle, from those of a neighbour: Weierstrass's iteration in floats."""
    n, r = box.middle, complex(box.r0)
    quadratic, linear = 4 * float(n.A), 8 * float(n.alpha) * r
    constant = 4 * (float(n.beta2) - r * r)
    z = list(start)
    for _ in range(60):
        change = 0.0
        for k, p in enumerate(z):
            others = (p - z[k - 1]) * (p - z[k - 2]) * (p - z[k - 3])
            step = (((p * p - quadratic) * p + linear) * p + constant) / (others or 1e-30)
            z[k] = p - step
            change = max(change, abs(step) / (1 + abs(p)))
        if change < 1e-13:
            break
    return z


def first_seeds(q: float) -> list[complex]:
    size = 1 + math.sqrt(2 * q)
    return [size * unit * complex(0.95, 0.3) for unit in (1, 1j, -1, -1j)]


# --- crossings: values and slopes ------------------------------------------------------------------------------


def natural(box: Box, z: Branches | Beside) -> Any:
    """A ball of R·F, or of F where two p-roots of one side may meet."""
    factor, unit = box.weights()
    if isinstance(z, Branches):
        return times_resultant(box.over, z.roots, factor, unit)
    n, size = box.over, range(len(box.over.eta))
    gaps = [[n.x[i] - n.x[j] if i != j else arb(0) for j in size] for i in size]
    rows = [[wave_beside(z, gaps[i][j], 1 if i >= j else -1) * n.eta[j] for j in size] for i in size]
    return det([[int(i == j) * unit - factor * rows[i][j] for j in size] for i in size])


def times_resultant(n: Numbers, z: Roots, factor: Any, unit: Any) -> Any:
    """R det(unit·I − κKM); for many masses by the waves of all p-roots, if no upper root is near a lower one."""
    if len(n.eta) > 2 and all(abs(u.mid() - v.mid()) > 1 for u in z.upper for v in z.lower):
        return z.resultant * det(edge_rows(n, edge_waves(n, z), factor, unit))
    return scaled(n, z, factor, unit)


def wave_beside(z: Beside, xi: Any, ahead: int) -> Any:
    """K(ξ)/(2πi) where the two roots s/2 ± δ on one side may meet: cos δξ and (sin δξ)/δξ are functions of δ².

    With g(p) = (p − k)(p − l) for the other two roots k, l, g(s/2 ± δ) = G ± 2sδ, and R = g(s/2 + δ) g(s/2 − δ):
    the divided difference of e^{ipξ}/g(p) is e^{isξ/2} [iξG (sin δξ)/δξ − 2s cos δξ]/R.
    """
    (k, m), s = z.known, z.total
    at_k, at_m = (p * p - s * p + z.product for p in z.known)
    if ahead != z.sign and not xi.is_zero():
        return ahead * ((I * k * xi).exp() / at_k - (I * m * xi).exp() / at_m) / (k - m)
    square = s * s / 4 - z.product
    cosine, sinc = cosine_and_sinc(square * xi * xi)
    wave = (I * s * xi / 2).exp() * (I * xi * (3 * s * s / 4 + square + k * m) * sinc - 2 * s * cosine)
    return z.sign * wave / (at_k * at_m)


def cosine_and_sinc(square: Any) -> tuple[Any, Any]:
    """cos z and (sin z)/z as functions of z²: 1 up to |z²| cosh|z|/2 and |z²| cosh|z|/6, or as they stand."""
    size = arb(abs(square).upper())
    if size > 0.5:
        z = square.sqrt()
        return z.cos(), z.sinc()
    bound = size * size.sqrt().cosh()
    wide, narrow = (arb(0, (bound / k).upper()) for k in (2, 6))
    return 1 + acb(wide, wide), 1 + acb(narrow, narrow)


def value_and_slopes(box: Box, z: Branches | Beside | None) -> tuple[Any, Any, Any] | None:
    """R·F at the middle and its derivatives along x and t over the box, where all p-roots are apart."""
    if not isinstance(z, Branches) or z.met:
        return None
    centre = box.centre()
    still = [branch(centre, one.seed) for one in z.order]
    a, b, c, e = [s.root if s and one.area.contains(s.root) else None for s, one in zip(still, z.order, strict=True)]
    if a is None or b is None or c is None or e is None:
        return None
    value = times_resultant(centre.over, Roots((a, b), (c, e)), *centre.weights())
    slope = times_resultant(moving(box), moving_roots(box, z.roots), *moving_weights(box))
    if not (value.is_finite() and slope.x.is_finite() and slope.t.is_finite()):
        return None
    return value, slope.x, slope.t


def moving(box: Box) -> Numbers:
    """The numbers over the box; distances move with t, and all else that does is in the p-roots."""
    n = box.over
    if box.family.parameter != "distance":
        return n
    return Numbers(n.alpha, n.axial, n.eta_b, n.eta, tuple(Dual(box.t * k, arb(0), k) for k in box.family.places))


def moving_roots(box: Box, z: Roots) -> Roots:
    """Each p-root with its slopes −D_x/D_p and −D_t/D_p, D_p the product of its distances from the others."""
    n, every, parameter = box.over, [*z.upper, *z.lower], box.family.parameter
    result = []
    for k, p in enumerate(every):
        inverse = 8 * residue(z, k)
        lean = (box.r - n.alpha * p) * inverse
        rate = acb(0)
        if parameter == "alpha":
            rate = -lean * p
        if parameter == "eta_b":
            rate = I * (n.alpha * p - box.q) * inverse
        result.append(Dual(p, lean, rate))
    return Roots((result[0], result[1]), (result[2], result[3]))


def moving_weights(box: Box) -> tuple[Any, Any]:
    factor, unit = box.weights()
    if box.family.parameter == "level":
        turn = 2 * arb.pi() * I
        return Dual(factor, 2 * turn * box.t * box.q, turn * (1 + box.q * box.q)), Dual(unit, acb(0), acb(-1))
    return Dual(factor, 8 * I * box.q, acb(0)), unit


def linear(f: Any, fx: Any, ft: Any, determinant: Any) -> tuple[Any, Any]:
    """(u, v) real with fx u + ft v = f, by Cramer's rule on real and imaginary parts."""
    return (f.real * ft.imag - f.imag * ft.real) / determinant, (fx.real * f.imag - fx.imag * f.real) / determinant


def confirms_crossing(content: dict[str, Any], value: Any) -> bool:
    """Whether a crossing would pass: for a maker of certificates, which may take a smaller reach."""
    try:
        check_crossing(free_problem(content), crossing(value))
    except Refused:
        return False
    return True


def one_zero(family: Family, x: Any, t: Any, dx: Any, dt: Any) -> Any:
    """Proves that the box x ± dx, t ± dt holds exactly one zero (Krawczyk); Im(conj(F_q) F_t) over the box."""
    box = Box(family, x, t, arb(0, dx), arb(0, dt))
    z = branches(box, seeds_at(box, first_seeds(float(x))))
    found = value_and_slopes(box, z)
    if found is None:
        raise Refused("p-roots cannot be told apart")
    f, fx, ft = found
    mx, mt = fx.mid(), ft.mid()
    determinant = (mx.conjugate() * mt).imag
    u, v = linear(f, mx, mt, determinant)
    xx, tx = linear(mx - fx, mx, mt, determinant)
    xt, tt = linear(mt - ft, mx, mt, determinant)
    move_x, move_t = xx * box.dx + xt * box.dt - u, tx * box.dx + tt * box.dt - v
    inside = abs(move_x) < arb(dx) and abs(move_t) < arb(dt)  # not so of what is not finite
    require(inside, "interval Newton does not confirm it")
    return (fx.conjugate() * ft).imag


# --- crossings: no others ----------------------------------------------------------------------------------------

Span = tuple[float, float, float, float]  # x from, x to, t from, t to


def tested(family: Family, span: Span, start: Sequence[complex]) -> tuple[bool, bool, list[complex]]:
    """(whether the box is proved to hold no zero, whether to halve it along x if not, p-roots near its middle)."""
    x0, x1, t0, t1 = span
    x, t = (x0 + x1) / 2, (t0 + t1) / 2
    dx, dt = (max(b - m, m - a) * (1 + 2.0**-50) for a, m, b in ((x0, x, x1), (t0, t, t1)))
    box = Box(family, arb(x), arb(t), arb(0, dx), arb(0, dt))
    seeds = seeds_at(box, start)
    ratio = dx / (1 + x0) / dt
    z = branches(box, seeds)
    if z is None:
        return False, ratio > 1, seeds
    value = natural(box, z)
    if value.is_finite() and not value.contains(0):
        return True, False, seeds
    found = value_and_slopes(box, z)
    if found is None:
        return False, ratio > 1, seeds
    f, fx, ft = found
    if by_slopes(box, f, fx, ft) or (family.parameter == "level" and x0 == 0 and not fx.imag.contains(0)):
        return True, False, seeds
    # slopes of wide boxes mislead: no box becomes a sliver
    across = ratio > 8 or (ratio > 0.125 and float(fx.abs_upper()) * dx > float(ft.abs_upper()) * dt)
    return False, across, seeds


def by_slopes(box: Box, f: Any, fx: Any, ft: Any) -> bool:
    """f + fx dx + ft dt ≠ 0 by the mean value theorem: some real component of it has one sign over the box."""
    for normal in (f.mid(), I * fx.mid(), I * ft.mid()):
        n = normal.conjugate()
        component = (f * n).real + (fx * n).real * box.dx + (ft * n).real * box.dt
        if component > 0 or component < 0:
            return True
    return False


def halves(span: Span, across: bool) -> tuple[Span, Span]:
    x0, x1, t0, t1 = span
    if across:
        x = math.sqrt(x0 * x1) if x0 > 1 else 2.0 if x1 > 4 else (x0 + x1) / 2
        return (x0, x, t0, t1), (x, x1, t0, t1)
    t = (t0 + t1) / 2
    return (x0, x1, t0, t), (x0, x1, t, t1)


def prove_free(family: Family, region: Span, holes: Sequence[Span], most: int = MAX_WORK) -> int:
    """Proves by bisection that the region holds no zero outside of the holes; the number of boxes it took."""
    stack, number = [(region, first_seeds(1.0))], 0
    limit = min(MAX_BOXES, most // work(len(family.case.eta), 64))
    while stack:
        span, start = stack.pop()
        number += 1
        require(number <= limit, f"{limit} boxes do not prove that there are no other crossings")
        if any(within(span, hole) for hole in holes):
            continue
        free, across, seeds = tested(family, span, start)
        if not free:
            x0, x1, t0, t1 = span
            wide = x1 - x0 > 2.0**-44 * max(1.0, x1) or t1 - t0 > 2.0**-44 * max(1.0, t1)
            require(wide, f"there may be another crossing near x = {x0:.12g}, t = {t0:.12g}")
            stack += [(half, seeds) for half in halves(span, across)]
    return number


def within(span: Span, hole: Span) -> bool:
    return hole[0] <= span[0] and span[1] <= hole[1] and hole[2] <= span[2] and span[3] <= hole[3]


def outward(low: Fraction, high: Fraction) -> tuple[float, float]:
    """Floats that enclose [low, high]."""
    a, b = float(low), float(high)
    return a if a <= low else math.nextafter(a, -math.inf), b if b >= high else math.nextafter(b, math.inf)


def inward(low: Fraction, high: Fraction) -> tuple[float, float]:
    """Floats within [low, high]."""
    a, b = float(low), float(high)
    return a if a >= low else math.nextafter(a, math.inf), b if b <= high else math.nextafter(b, -math.inf)


# --- crossings: the certificate ----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Free:
    """A problem with one free parameter from start to end, and the line Im q = height, all exact."""

    problem: Problem
    parameter: str
    start: Fraction
    end: Fraction
    height: Fraction

    def family(self) -> Family:
        """In balls at the present precision."""
        return Family(numbers(self.problem), self.parameter, ball(self.height))

    def at(self, t: Fraction) -> Problem:
        """The problem at t, not for "level"."""
        p, value = self.problem, rational_real(t)
        if self.parameter == "alpha":
            return replace(p, alpha=value)
        if self.parameter == "eta_b":
            return replace(p, eta_b=value)
        return replace(p, places=tuple(rational_real(k * t) for k in range(len(p.places))))


def rational(text: Any, name: str) -> Fraction:
    value = real(text, name).rational
    if value is None:
        raise Refused(f"{name} is not rational")
    return value


def free_problem(content: dict[str, Any]) -> Free:
    """The family, proved admissible: N < 1, and no cut meets Im q ≤ height for any t."""
    p, values = problem(content["case"]), content["family"]
    keys(values, {"parameter", "start", "end"})
    parameter, height = values["parameter"], rational(content["height"], "height")
    start, end = rational(values["start"], "start"), rational(values["end"], "end")
    require(parameter in ("alpha", "eta_b", "distance", "level"), "the parameter is not known")
    require(start < end, "start is not below end")
    require(height <= 0, "a line above the real axis is not known to this verifier")
    require(parameter == "eta_b" or p.eta_b.quartic > 0, "there is no damping")
    require(start >= 0 and (parameter == "alpha" or parameter == "level" or start > 0), "start is too small")
    if parameter == "level":
        require(start == 0 and end == 1 and height == 0, "a free level runs from 0 to 1 on the real axis")
    if parameter == "distance":
        first, count = p.places[min(1, len(p.places) - 1)].quartic, sum(len(group) for group in p.masses)
        even = all(place.quartic == k**4 * first for k, place in enumerate(p.places))
        require(1 < count == len(p.places) and even and first > 0, "the masses do not stand at 0, d, 2d, …")
    free = Free(p, parameter, start, end, height)
    with precision(64):
        require(free.family().case.axial < 1, "the beam buckles without any load")
    return free


@dataclass(frozen=True)
class Crossing:
    """One zero (x, t) within one unit of the last place of each; alone within `reach` of the middle."""

    x: Fraction
    dx: Fraction
    t: Fraction
    dt: Fraction
    direction: int
    reach: Fraction
    bits: int


def crossing(value: Any) -> Crossing:
    keys(value, {"x", "x_exponent", "t", "t_exponent", "direction", "reach"})
    numbers, bits = [], 0
    for name in ("x", "t"):
        exponent = integer(value[f"{name}_exponent"], -MAX_BITS, 60, "an exponent")
        m = mantissa(value[name])
        require(m > 0, "a crossing is not at positive x and t")
        require(m.bit_length() <= MAX_BITS, "a crossing has too many digits")
        numbers += [m * Fraction(2) ** exponent, Fraction(2) ** exponent]
        bits = max(bits, m.bit_length(), -exponent)
    direction, reach = integer(value["direction"], -1, 1, "a direction"), dyadic(value["reach"])
    require(direction != 0 and reach > 0, "a direction or a reach is 0")
    x, dx, t, dt = numbers
    return Crossing(x, dx, t, dt, direction, reach, bits)


def check_crossing(free: Free, c: Crossing) -> None:
    """Proves that one zero is within a unit of the last places, with the direction claimed, and no other nearby."""
    require(c.dx < c.x and c.dx <= c.reach and c.dt <= c.reach, "a reach is less than a unit of the last place")
    require(free.start < c.t - c.dt and c.t + c.dt < free.end, "it is not inside of the range")
    with precision(max(64, c.bits + 48)):
        family = free.family()
        x, t = ball(c.x), ball(c.t)
        turn = c.direction * one_zero(family, x, t, ball(c.dx), ball(c.dt))
        require(turn > 0, "its direction is not as claimed")
        one_zero(family, x, t, ball(c.reach), ball(c.reach))


def crossings_work(free: Free, content: dict[str, Any]) -> int:
    """The work that a certificate of crossings asks for, but for the search for others."""
    values, base, places = content["crossings"], content["base"], len(free.problem.places)
    require(isinstance(values, list) and len(values) <= MAX_CROSSINGS, "crossings are no list, or too many")
    total = sum(5 * work(places, crossing(value).bits + 48) for value in values)
    inner = base.get("certificate") if isinstance(base, dict) else None
    if isinstance(inner, dict) and isinstance(inner.get("contour"), dict):
        total += spectrum_work(free.problem, {"roots": [], **inner})
    return total


def check_each(free: Free, values: Any) -> list[Crossing]:
    """All crossings, each proved, in order: by t, and for a free level by η."""
    found = [crossing(value) for value in values]
    require(sum(c.bits for c in found) <= MAX_ALL_BITS, "the crossings have too many digits in all")
    for k, c in enumerate(found):
        try:
            check_crossing(free, c)
        except Refused as error:
            raise Refused(f"crossing {k}: {error}") from None
    spans = [(c.t - c.dt, c.t + c.dt) for c in found]
    if free.parameter == "level":
        spans = [level_span(c) for c in found]
    require(all(a[1] < b[0] for a, b in pairwise(spans)), "the crossings are not in order, or not apart")
    return found


def level_span(c: Crossing) -> tuple[Fraction, Fraction]:
    """The ends of 2η/π = (1 + 1/x²) u/(1 − u)."""
    low, high = c.t - c.dt, c.t + c.dt
    return (1 + 1 / (c.x + c.dx) ** 2) * low / (1 - low), (1 + 1 / (c.x - c.dx) ** 2) * high / (1 - high)


def check_far(free: Free, reach: Fraction) -> None:
    """No zero has |q − iη_b| ≥ reach for any t, part by part of the range."""
    parts, number = [(free.start, free.end)], 0
    while parts:
        low, high = parts.pop()
        number += 1
        family = free.family()
        try:
            far_field(family.at(ball(low).union(ball(high))), ball(reach))
        except Refused as error:
            require(number < MAX_FAR_PARTS and (high - low) * 2**20 > free.end - free.start, str(error))
            middle = (low + high) / 2
            parts += [(low, middle), (middle, high)]


def check_crossings(content: dict[str, Any]) -> str:
    """The claim in words, if every step of a certificate of crossings holds."""
    free, reach = free_problem(content), dyadic(content["radius"])
    spent = crossings_work(free, content)
    require(spent <= MAX_WORK, "it asks for too much work: too many crossings, pieces, masses or digits")
    found = check_each(free, content["crossings"])
    counts = check_counts(free, found, content["base"], content["claim"])
    with precision(64):
        require(reach > 0, "the radius is not positive")
        check_far(free, reach)
        holes = [(*inward(c.x - c.reach, c.x + c.reach), *inward(c.t - c.reach, c.t + c.reach)) for c in found]
        region = (0.0, outward(Fraction(0), reach)[1], *outward(free.start, free.end))
        prove_free(free.family(), region, holes, MAX_WORK - spent)
    name = "the level of the masses" if free.parameter == "level" else free.parameter
    ends = "" if free.parameter == "level" else f" from {free.start} to {free.end}"
    return (
        f"exactly {len(found)} crossing{'' if len(found) == 1 else 's'} of Im q = {free.height} for {name}{ends}, "
        "each within a unit of its last place; "
        f"induced frequencies below it before, between and after: {', '.join(map(str, counts))}; "
        f"{case_said(content['case'], free.parameter)}"
    )


def check_counts(free: Free, found: Sequence[Crossing], base: Any, claim: Any) -> list[int]:
    """The numbers of roots below the line, from one that is proved: each crossing is two roots, q and −q̄."""
    keys(claim, {"counts"})
    known = free.parameter == "level" or (free.parameter == "alpha" and free.start == 0 and base is None)
    place, below = (0, 0) if known else check_base(free, found, base)
    require(free.parameter != "level" or base is None, "a free level needs no base")
    changes = [2 * c.direction for c in found]
    counts = [below - sum(changes[k:place]) + sum(changes[place:k]) for k in range(len(found) + 1)]
    require(min(counts) >= 0, "a number of roots is negative")
    claimed = claim["counts"]
    agree = isinstance(claimed, list) and all(type(n) is int for n in claimed) and claimed == counts
    require(agree, f"the numbers of roots are {counts}"[:200] + ", not those claimed")
    return counts


def check_base(free: Free, found: Sequence[Crossing], base: Any) -> tuple[int, int]:
    """(how many crossings lie before the base, how many roots are below the line there)."""
    keys(base, {"t", "certificate"})
    t = rational(base["t"], "the base's t")
    require(free.start <= t <= free.end, "the base is not in the range")
    before = [c.t + c.dt < t for c in found]
    require(all(b or t < c.t - c.dt for b, c in zip(before, found, strict=True)), "the base is a crossing")
    try:
        content = opened(base["certificate"])
        require(content["kind"] == "induced frequencies", "it is of another kind")
        require(same(problem(content["case"]), free.at(t)), "it is of another case")
        _, roots = check_frequencies(content)
        require(content["contour"]["kind"] != "rectangle", "it is of a rectangle only")
        return sum(before), roots_below(roots, free.height)
    except Refused as error:
        raise Refused(f"the base: {error}") from None


def same(one: Problem, two: Problem) -> bool:
    """The same exact numbers."""

    def values(p: Problem) -> list[Any]:
        numbers = [p.alpha, p.eta_b, p.eta_n, p.eta_s, *p.places]
        return [[x.quartic for x in numbers], [[m.quartic for m in group] for group in p.masses]]

    return values(one) == values(two)


def roots_below(roots: Sequence[Root], height: Fraction) -> int:
    """How many have Im q < height; each is proved to lie above or below."""
    number = 0
    for k, found in enumerate(roots):
        with precision(found.bits + 64):
            imag, line = found.box.imag, ball(height)
            require(imag < line or imag > line, f"root {k} may lie on either side of the line")
            number += found.multiplicity if imag < line else 0
    return number


def main(paths: Sequence[str]) -> int:
    """Prints one line a file; 0 if all are valid."""
    if not paths:
        print("usage: verify.py FILE [FILE …]", file=sys.stderr)
        return 1
    verdicts = [(path, verify(path)) for path in paths]
    for path, verdict in verdicts:
        print(f"{path}: " + (f"valid: {verdict.claim}" if verdict.valid else f"INVALID: {verdict.reason}"))
    return 0 if all(verdict.valid for _, verdict in verdicts) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
