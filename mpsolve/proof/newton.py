"""Interval Newton for one analytic equation f(z) = 0, at the precision that is set and at rising ones.

If the image m − f(m)/f′(X) of a box X round m lies in the interior of X, then X holds exactly one root of f, a
simple one, and it lies in the image. Nothing here knows what f is.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.balls import acb, arb, bits_now, precision, square
from mpsolve.numbers.packed import exponent_of

_GUARD = 24
_LOSS = 12
_MOST_GUARD = 2000
_POLISH = 8


class Analytic(Protocol):
    """A function on balls; all raise `PrecisionError` where a ball cannot be decided."""

    def value(self, z: Any) -> Any:
        """A ball that holds f on the ball z."""

    def slope(self, z: Any) -> Any:
        """A ball that holds f′ on the ball z."""

    def both(self, z: Any) -> tuple[Any, Any]:
        """The two at once."""


@frozen
class Isolated:
    """A box that holds exactly one root of f, and its sharper image, which holds that root too."""

    box: acb
    image: acb


def polished(f: Analytic, seed: Any) -> acb:
    """An exact point where Newton's method from `seed` stands still to the precision that is set, or nearly so."""
    z = acb(seed).mid()
    for _ in range(_POLISH):
        value, slope = f.both(z)
        step = value.mid() / slope.mid()
        if not step.is_finite():
            raise PrecisionError("Newton's method met a stationary point: roots may be too close for this precision")
        z = (z - step).mid()
        if step.abs_upper() <= z.abs_upper() * arb(2) ** (-bits_now() // 2):  # the next step is its square
            break
    return z


def isolated(f: Analytic, middle: Any, size: Any) -> Isolated:
    """The largest of the boxes of half-width size·2⁻¹⁶, size·2⁻²⁴, … round the exact `middle` that is proved.

    `PrecisionError` where none is proved at the precision that is set.
    """
    value = f.value(middle)
    for shrink in range(16, bits_now() - 12, 8):
        box = middle + square(arb(size) * arb(2) ** -shrink)
        image = _image(f, middle, value, box)
        if image is not None:
            return Isolated(box, image)
    near = complex(middle)
    raise PrecisionError(f"no box around {near:.6g} is proved to hold exactly one root: raise the precision")


def _image(f: Analytic, middle: Any, value: acb, box: acb) -> acb | None:
    try:
        image = middle - value / f.slope(box)
    except PrecisionError:
        return None
    return image if image.is_finite() and box.contains_interior(image) else None


def real_part(ball: Any) -> acb:
    """Of a ball that holds a real root."""
    return acb(ball.real)


def sharpened(f: Analytic, image: Any, goal: int, onto: Callable[[Any], Any] | None = None, least: Any = 0) -> Any:
    """A ball with the one root that `image` holds, of a radius below 2^−goal of the root's modulus.

    onto: takes a ball to its part on the line on which the root is known to lie. least: a size below which a root
    counts as one of this size. Precision doubles with what is known of the root, so as to end at the goal: the last
    step costs one value of f at goal bits and a little more, and one slope at half of them.
    """
    guard, loss = _GUARD, _LOSS
    image = onto(image) if onto else image
    known = _accuracy(image, least)
    while known < goal:
        target = _next(known, goal, loss)
        try:
            with precision(known + guard):
                slope = f.slope(image)
            with precision(target + guard):
                middle = image.mid()
                ahead = middle - f.value(middle) / slope
                ahead = onto(ahead) if onto else ahead
            reached = _accuracy(ahead, least)
        except PrecisionError:  # f itself loses what it is made of
            guard, loss = 2 * guard, 2 * loss
            if guard > _MOST_GUARD:
                raise
            continue
        if reached > known:  # else it may hold more than the root, such as a cut
            image = ahead
        if reached < target:
            guard, loss = guard + target - reached, loss + target - reached
            if guard > _MOST_GUARD:
                near = complex(image)
                raise PrecisionError(f"the root near {near:.6g} could not be sharpened: it is too badly conditioned")
        known = max(known, reached, 2)
    return image


def _next(known: int, goal: int, loss: int) -> int:
    """The lowest precision that one step can reach from `known`, on the way that halves back from the goal."""
    target = goal
    while target > max(2 * known - loss, known + 1):
        target = max(target // 2 + loss, known + 1) if target // 2 + loss < target else known + 1
    return target


def _accuracy(image: acb, least: Any) -> int:
    """Bits of the modulus, or of `least` where that is larger, that the ball fixes."""
    if not image.is_finite():
        raise PrecisionError("interval Newton lost the root: raise the precision")
    radius = image.rad()
    if radius == 0:
        return 1 << 40
    size = image.abs_upper()
    size = size if least == 0 or size > least else arb(least)
    return exponent_of(size) - exponent_of(arb(radius))
