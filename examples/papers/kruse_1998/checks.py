"""The checks: proved real roots, and complete lists of complex ones on two choices of the cuts."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from mpsolve import Cut, Rectangle, real_roots, roots
from mpsolve.claims import Claim, Finding, Verdict
from mpsolve.claims.values import shown
from mpsolve.errors import PrecisionError

_UPWARDS = "(sqrt(-i*(1 - z))*sqrt(i*(1 + z)))"  # √(1 − z²), cut from ±1 along +i: √(1 ∓ z) = e^{±iπ/4} √(∓i(1 ∓ z))


def elastic(wheel: str, k: str, v: str) -> str:
    """The characteristic function times (k − q²), in z = q; without viscosity."""
    square = 1 - Fraction(v) ** 2
    return f"2*sqrt({square} - z**2)*({k} - z**2) - {wheel}*z**2*({k} - z**2) - {k}*z**2"


def one_or_two(claim: Claim) -> Finding:
    numbers, counts = [], set()
    for v in claim.values("v"):
        for wheel, k in zip(claim.values("wheel"), claim.values("k"), strict=True):
            # every real eigenfrequency is below the cut at √(1 − v²); the band edge itself is left out
            edge = Fraction(int(10**6 * float(1 - Fraction(v) ** 2) ** 0.5), 10**6)
            found = real_roots(elastic(wheel, k, v), 0, edge, digits=15)
            if not found.proved:
                raise PrecisionError(str(found.reason))
            counts.add(len(found.roots))
            values = ", ".join(shown(root.q, 10) for root in found.roots)
            numbers.append((f"wheel {wheel}, k = {k}, v = {v}: q from 0 to {float(edge):.6f}", values))
    if counts != {1, 2}:
        return Finding(Verdict.UNDECIDABLE, f"These oscillators have {sorted(counts)} each.", numbers)
    sentence = (
        "Some of these oscillators have exactly one real positive eigenfrequency, the others exactly two (proved, up "
        "to 1e-6 of the edge from which on waves run away)."
    )
    return Finding(Verdict.PROVED, sentence, numbers)


def not_unique(claim: Claim) -> Finding:
    wheel, k, c, v = claim.numbers("wheel", "k", "c", "v")
    b = _root_of((1 - Fraction(v) ** 2) * (1 - Fraction(c) ** 2 / 4))
    q = f"({b}*z + i*{Fraction(c) / 2})"  # z = (q − ic/2)/b: the branch points lie at ±1
    body = f"({k} - {q}**2)"
    level = f"2*{b}*sqrt(1 - z**2)*{body} - {wheel}*{q}**2*{body} - {k}*{q}**2"
    region = Rectangle(-3, 3, -Fraction(c) / 2 / b, 2)  # 0 < Im q < 2b + c/2
    upwards = level.replace("sqrt(1 - z**2)", _UPWARDS)
    lists = {
        "cuts to both sides": roots(level, region, cuts=[Cut.ray(1, 1), Cut.ray(-1, -1)]),
        "cuts upwards": roots(upwards, region, cuts=[Cut.ray(1, 1j), Cut.ray(-1, 1j)]),
    }
    numbers, sets = [], []
    for name, found in lists.items():
        if not found.proved:
            raise PrecisionError(str(found.reason))
        values = [f"{float(x.q.real) * b:.6f} + {float(x.q.imag) * b + Fraction(c) / 2:.6f}i" for x in found.roots]
        numbers.append((f"{name}: {found.count} eigenfrequencies q", ", ".join(values) or "none"))
        sets.append(values)
    if sets[0] == sets[1]:
        return Finding(Verdict.UNDECIDABLE, "Both cuts give the same eigenfrequencies here.", numbers)
    sentence = (
        "Above the branch points the list depends on where the cuts are laid: the two lists differ (each is proved "
        "complete). Below them, so for all that grows or decays slowly, the cuts do not matter."
    )
    return Finding(Verdict.PROVED, sentence, numbers)


def _root_of(x: Fraction) -> Fraction:
    root = Fraction(isqrt(x.numerator), isqrt(x.denominator))
    if root * root != x:
        raise PrecisionError(f"{x} has no rational root: give v and c for which b is rational")
    return root
