"""Interval Newton for one complex equation in two real unknowns, f(y, x) = 0, or n in 2n, at rising precision.

With a real matrix Y near the inverse of the Jacobian at the middle m of a box X, Krawczyk's image
m − Y f(m) + (I − Y J(X))(X − m) in the interior of X proves exactly one zero in X, which lies in the image.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, arb_mat, bits_now, precision
from mpsolve.numbers.packed import exponent_of

Point = tuple[Any, ...]
"""Real balls, two for each equation."""
_GUARD = 32
_POLISH = 12
_MOST_STEPS = 60


class Planar(Protocol):
    """f on real balls; raises `PrecisionError` where balls cannot decide."""

    def value(self, *at: Any) -> Any:
        """A ball of f, or a tuple of them."""

    def slopes(self, *at: Any) -> tuple[Any, ...]:
        """Balls of f_y and f_x, or a tuple of such rows."""


@dataclass(frozen=True)
class Zero:
    """A box with exactly one zero, and its sharper image."""

    box: Point
    image: Point


def polished(f: Planar, seed: Sequence[float]) -> Point:
    """Exact numbers to which Newton's method leads."""
    at: Point = tuple(map(arb, seed))
    for _ in range(_POLISH):
        step = _newton(f, at)
        at = tuple(arb((a - s).mid()) for a, s in zip(at, step, strict=True))
        if not all(a.is_finite() for a in at):
            raise PrecisionError("Newton's method left the plane near a crossing: two crossings may be too close")
        if all(
            abs(s).upper() <= (abs(p) + 1).upper() * arb(2) ** (-bits_now() // 2)
            for s, p in zip(step, at, strict=True)
        ):
            break
    return at


def _newton(f: Planar, at: Point) -> Point:
    moved = _inverse(f.slopes(*at)) * _column(f.value(*at))
    return tuple(arb(x.mid()) for x in moved.entries())


def isolated(f: Planar, middle: Point, size: Point) -> Zero:
    """The largest of the boxes of half-widths size·2⁻⁴, 2⁻⁸, … that is proved; `PrecisionError` where none is."""
    value, slopes = f.value(*middle), f.slopes(*middle)
    Y = _inverse(slopes)
    for shift in range(4, bits_now() - 8, 6):
        box = tuple(m + arb(0, arb(s) * arb(2) ** -shift) for m, s in zip(middle, size, strict=True))
        image = _image(f, middle, value, Y, box)
        if image is not None:
            return Zero(box, image)
    where = ", ".join(m.str(6) for m in middle)
    raise PrecisionError(f"no box around ({where}) is proved to hold exactly one crossing")


def _image(f: Planar, middle: Point, value: Any, Y: arb_mat, box: Point) -> Point | None:
    try:
        J = _jacobian(f.slopes(*box))
    except PrecisionError:
        return None
    image = _step(middle, box, value, Y, J)
    return image if all(b.contains_interior(i) for b, i in zip(box, image, strict=True)) else None


def _step(middle: Point, box: Point, value: Any, Y: arb_mat, J: arb_mat) -> Point:
    """m − Y f(m) + (I − Y J)(X − m)."""
    n = len(box)
    one = arb_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    spread = arb_mat([[b - m] for b, m in zip(box, middle, strict=True)])
    step = (one - Y * J) * spread - Y * _column(value)
    return tuple(m + s for m, s in zip(middle, step.entries(), strict=True))


def sharpened(f: Planar, zero: Zero, goal: int) -> Point:
    """The zero with radii below 2^−goal of the larger of 2^-goal and each modulus; precision about doubles a step."""
    at = zero.image
    bits = bits_now()
    for _ in range(_MOST_STEPS):
        if all(_accuracy(part) >= goal for part in at):
            return at
        known = min(_accuracy(part) for part in at)
        with precision(max(bits, known + _GUARD)):
            J = _jacobian(f.slopes(*at))
        bits = min(2 * known + 2 * _GUARD, goal + 2 * _GUARD) if known > _GUARD else bits + _GUARD
        with precision(bits):
            middle = tuple(arb(a.mid()) for a in at)
            new = _step(middle, at, f.value(*middle), _mid(_regular(_mid(J))), J)
            at = tuple(map(_met, at, new))
    raise PrecisionError("a crossing could not be sharpened to the digits asked: it is too badly conditioned")


def settled(f: Planar, zero: Zero) -> Point:
    """The image, made smaller by further steps as long as they help: f may be known on balls only."""
    at = zero.image
    for _ in range(_MOST_STEPS):
        middle = tuple(arb(a.mid()) for a in at)
        slopes = f.slopes(*at)
        new = tuple(map(_met, at, _step(middle, at, f.value(*middle), _inverse(slopes), _jacobian(slopes))))
        better = any(bool(b.rad() * 2 < a.rad()) for a, b in zip(at, new, strict=True))
        at = new
        if not better:
            break
    return at


def _met(old: arb, new: arb) -> arb:
    return new if new.is_finite() and new.rad() < old.rad() else old


def _accuracy(x: arb) -> int:
    """Bits of the modulus that the ball fixes; of 0 or less where it holds 0."""
    if x.rad() == 0:
        return 1 << 40
    return int(x.rel_accuracy_bits()) if not x.contains(0) else -exponent_of(x.rad())


def _column(value: Any) -> arb_mat:
    each = value if isinstance(value, tuple) else (value,)
    return arb_mat([[part] for z in each for part in (acb(z).real, acb(z).imag)])


def _jacobian(slopes: tuple[Any, ...]) -> arb_mat:
    rows = slopes if isinstance(slopes[0], tuple) else (slopes,)
    return arb_mat([line for row in rows for line in ([acb(z).real for z in row], [acb(z).imag for z in row])])


def _inverse(slopes: tuple[Any, ...]) -> arb_mat:
    """A real matrix near the inverse of the Jacobian, exact."""
    return _mid(_regular(_mid(_jacobian(slopes))))


def _regular(J: arb_mat) -> arb_mat:
    try:
        return J.inv()
    except ZeroDivisionError:
        raise PrecisionError(
            "a crossing is tangent to within the precision: two crossings may be too close"
        ) from None


def _mid(a: Any) -> arb_mat:
    return arb_mat(a.nrows(), a.ncols(), [arb(x.mid()) for x in a.entries()])
