"""Interval Newton for one complex equation in two real unknowns, f(y, x) = 0, at rising precision.

With a real 2 × 2 matrix Y near the inverse of the Jacobian at the middle m of a box X, Krawczyk's image
m − Y f(m) + (I − Y J(X))(X − m) in the interior of X proves exactly one zero in X, which lies in the image.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, arb_mat, bits_now, precision

Point = tuple[Any, Any]
"""Two real balls."""
_GUARD = 32
_POLISH = 12
_MOST_STEPS = 60


class Planar(Protocol):
    """f on real balls; raises `PrecisionError` where balls cannot decide."""

    def value(self, y: Any, x: Any) -> Any:
        """A ball of f."""

    def slopes(self, y: Any, x: Any) -> tuple[Any, Any]:
        """Balls of f_y and f_x."""


@dataclass(frozen=True)
class Zero:
    """A box with exactly one zero, and its sharper image."""

    box: Point
    image: Point


def polished(f: Planar, seed: tuple[float, float]) -> Point:
    """Exact numbers to which Newton's method leads."""
    at: Point = (arb(seed[0]), arb(seed[1]))
    for _ in range(_POLISH):
        step = _newton(f, at)
        at = (arb((at[0] - step[0]).mid()), arb((at[1] - step[1]).mid()))
        if not (at[0].is_finite() and at[1].is_finite()):
            raise PrecisionError("Newton's method left the plane near a crossing: two crossings may be too close")
        if all(
            abs(s).upper() <= (abs(p) + 1).upper() * arb(2) ** (-bits_now() // 2)
            for s, p in zip(step, at, strict=True)
        ):
            break
    return at


def _newton(f: Planar, at: Point) -> Point:
    moved = _inverse(f.slopes(*at)) * _column(f.value(*at))
    return arb(moved[0, 0].mid()), arb(moved[1, 0].mid())


def isolated(f: Planar, middle: Point, size: Point) -> Zero:
    """The largest of the boxes of half-widths size·2⁻⁴, 2⁻⁸, … that is proved; `PrecisionError` where none is."""
    value, slopes = f.value(*middle), f.slopes(*middle)
    Y = _inverse(slopes)
    for shift in range(4, bits_now() - 8, 6):
        radii = [arb(s) * arb(2) ** -shift for s in size]
        box = (middle[0] + arb(0, radii[0]), middle[1] + arb(0, radii[1]))
        image = _image(f, middle, value, Y, box)
        if image is not None:
            return Zero(box, image)
    raise PrecisionError(
        f"no box around ({middle[0].str(6)}, {middle[1].str(6)}) is proved to hold exactly one crossing"
    )


def _image(f: Planar, middle: Point, value: Any, Y: Any, box: Point) -> Point | None:
    try:
        J = _jacobian(f.slopes(*box))
    except PrecisionError:
        return None
    spread = arb_mat([[box[0] - middle[0]], [box[1] - middle[1]]])
    step = (_one() - Y * J) * spread - Y * _column(value)
    image = (middle[0] + step[0, 0], middle[1] + step[1, 0])
    return image if all(b.contains_interior(i) for b, i in zip(box, image, strict=True)) else None


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
            middle = (arb(at[0].mid()), arb(at[1].mid()))
            Y = _mid(_regular(_mid(J)))
            spread = arb_mat([[at[0] - middle[0]], [at[1] - middle[1]]])
            step = (_one() - Y * J) * spread - Y * _column(f.value(*middle))
            new = (middle[0] + step[0, 0], middle[1] + step[1, 0])
            at = (_met(at[0], new[0]), _met(at[1], new[1]))
    raise PrecisionError("a crossing could not be sharpened to the digits asked: it is too badly conditioned")


def settled(f: Planar, zero: Zero) -> Point:
    """The image, made smaller by further steps as long as they help: f may be known on balls only."""
    at = zero.image
    for _ in range(_MOST_STEPS):
        middle = (arb(at[0].mid()), arb(at[1].mid()))
        slopes = f.slopes(*at)
        Y = _inverse(slopes)
        spread = arb_mat([[at[0] - middle[0]], [at[1] - middle[1]]])
        step = (_one() - Y * _jacobian(slopes)) * spread - Y * _column(f.value(*middle))
        new = tuple(_met(old, m + s) for old, m, s in zip(at, middle, (step[0, 0], step[1, 0]), strict=True))
        better = any(bool(b.rad() * 2 < a.rad()) for a, b in zip(at, new, strict=True))
        at = (new[0], new[1])
        if not better:
            break
    return at


def _met(old: Any, new: Any) -> Any:
    return new if new.is_finite() and new.rad() < old.rad() else old


def _accuracy(x: Any) -> int:
    """Bits of the modulus that the ball fixes; of 0 or less where it holds 0."""
    if x.rad() == 0:
        return 1 << 40
    return int(x.rel_accuracy_bits()) if not x.contains(0) else -int(_exponent(x.rad()))


def _exponent(x: Any) -> int:
    mantissa, exponent = arb(x).mid().man_exp()
    return int(exponent) + int(abs(mantissa)).bit_length()


def _column(value: Any) -> Any:
    return arb_mat([[value.real], [value.imag]])


def _jacobian(slopes: tuple[Any, Any]) -> Any:
    one, other = (acb(s) for s in slopes)
    return arb_mat([[one.real, other.real], [one.imag, other.imag]])


def _inverse(slopes: tuple[Any, Any]) -> Any:
    """A real matrix near the inverse of the Jacobian, exact."""
    return _mid(_regular(_mid(_jacobian(slopes))))


def _regular(J: Any) -> Any:
    try:
        return J.inv()
    except ZeroDivisionError:
        raise PrecisionError(
            "a crossing is tangent to within the precision: two crossings may be too close"
        ) from None


def _mid(a: Any) -> Any:
    return arb_mat([[arb(a[i, j].mid()) for j in range(2)] for i in range(2)])


def _one() -> Any:
    return arb_mat([[1, 0], [0, 1]])
