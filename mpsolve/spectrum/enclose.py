"""Enclosures: a box proved to hold exactly one root of Δ, sharpened to any number of digits.

Existence and uniqueness come from interval Newton with interior containment: if m − Δ(m)/Δ_q(X) lies in the
interior of X, then X holds exactly one root. Precision doubles up to what is asked, and each step needs only
the value of Δ at the new precision: its slope comes from the step before.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import Enum
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.model.parameters import Case

acb, arb = flint.acb, flint.arb

BASE_BITS = 80
_GUARD = 24


class Symmetry(Enum):
    """Where a root lies as a consequence of its box being symmetric and holding one root."""

    NONE = "none"
    IMAGINARY = "imaginary"  # Re q = 0, from the symmetry q → −q̄
    REAL = "real"  # Im q = 0, from the symmetry q → q̄ of the undamped gap


@dataclass(frozen=True)
class RootBall:
    """A ball that is proved to hold exactly `multiplicity` roots of Δ, counted with multiplicity.

    `isolated`: multiplicity 1, by interval Newton; otherwise a cluster, by Pellet's test.
    """

    q: Any
    multiplicity: int = 1
    symmetry: Symmetry = Symmetry.NONE

    @property
    def mirrored(self) -> RootBall:
        """The ball of −q̄."""
        return RootBall(-self.q.conjugate(), self.multiplicity, self.symmetry)


@dataclass(frozen=True)
class Box:
    """A box proved to hold one root; the root's sharper image in it, with the ball of Δ_q over the image."""

    q: Any
    image: Any
    slope: Any
    symmetry: Symmetry


def isolate(case: Case, seed: Any, bits: int = BASE_BITS) -> Box:
    """A box around the root that Newton's method reaches from `seed` (complex or flint.acb), proved.

    Raises `PrecisionError` if no box is proved to hold exactly one root.
    """
    with ball_arithmetic(bits) as field:
        model = track(case, field)
        middle = _polish(model, acb(seed), bits)
        options = [Symmetry.NONE]
        near_axis = 2.0**-30 * float(middle.abs_upper())
        if abs(float(middle.real.mid())) < near_axis:
            options.insert(0, Symmetry.IMAGINARY)
        if not case.eta_b and abs(float(middle.imag.mid())) < near_axis:
            options.insert(0, Symmetry.REAL)
        for symmetry in options:
            start = onto_axis(middle, symmetry).mid()
            for shrink in range(16, bits - 12, 8):
                box = _prove(model, start, start.abs_upper() * arb(2) ** -shrink, symmetry)
                if box is not None:
                    return box
        raise PrecisionError(f"no box around {complex(acb(seed).mid()):.6g} is proved to hold exactly one root")


def _polish(model: Any, q: Any, bits: int) -> Any:
    """A few Newton steps on midpoints."""
    for _ in range(3):
        value, slope = characteristic_rate(model, q)
        step = value.mid() / slope.mid()
        if not step.is_finite():
            raise PrecisionError("Newton's method met a stationary point of the characteristic function")
        q = (q - step).mid()
        if step.abs_upper() < q.abs_lower() * arb(2) ** (8 - bits):
            break
    return q


def onto_axis(q: Any, symmetry: Symmetry) -> Any:
    """q with the coordinate that the symmetry proves to vanish set to 0."""
    if symmetry is Symmetry.REAL:
        return acb(q.real, 0)
    if symmetry is Symmetry.IMAGINARY:
        return acb(0, q.imag)
    return q


def _prove(model: Any, middle: Any, radius: Any, symmetry: Symmetry) -> Box | None:
    reach = arb(0, radius.upper())
    box = acb(middle.real + reach, middle.imag + reach)
    try:
        slope = characteristic_rate(model, box)[1]
        image = middle - characteristic(model, middle) / slope
    except PrecisionError:
        return None
    if not (image.is_finite() and box.contains_interior(image)):
        return None
    image = onto_axis(image, symmetry)
    return Box(box, image, characteristic_rate(model, image)[1], symmetry)


def refine(case: Case, box: Box, digits: int) -> RootBall:
    """The root of `box` in a ball of relative radius below 10^−digits that lies within `box`.

    Costs about one evaluation of Δ at the last precision and half of that again below it.
    """
    goal = math.ceil(digits * math.log2(10)) + 1
    image, slope = box.image, box.slope
    for bits in _ladder(goal + _GUARD):
        with ball_arithmetic(bits + 10) as field:
            model = track(case, field)
            middle = onto_axis(image, box.symmetry).mid()
            image = middle - characteristic(model, middle) / slope
        if bits < goal + _GUARD:
            with ball_arithmetic(max(BASE_BITS, bits)) as field:
                slope = characteristic_rate(track(case, field), onto_axis(image, box.symmetry))[1]
    with ball_arithmetic(goal + _GUARD + 10):
        ball = _round(image, goal, box.symmetry)
        if not (box.q.contains(ball) and ball.contains(onto_axis(image, box.symmetry))):
            raise PrecisionError(f"the root near {image.str(6)} could not be sharpened to {digits} digits")
    return RootBall(ball, 1, box.symmetry)


def _ladder(last: int) -> list[int]:
    """Precisions that end at `last` and roughly double."""
    steps = [last]
    while steps[0] > 2 * BASE_BITS:
        steps.insert(0, steps[0] // 2 + 16)
    return steps


def _round(image: Any, goal: int, symmetry: Symmetry) -> Any:
    """A ball with a short midpoint, of radius |q| 2^−goal to a factor of 2, around the much smaller image."""
    exponent = math.frexp(float(image.abs_lower()))[1] - 1 - goal
    unit, radius = arb(2) ** (exponent - 8), arb(0, (arb(2) ** exponent))

    def shorten(x: Any) -> Any:
        return (x.mid() / unit + arb(0.5)).floor().mid() * unit

    real = arb(0) if symmetry is Symmetry.IMAGINARY else shorten(image.real) + radius
    imag = arb(0) if symmetry is Symmetry.REAL else shorten(image.imag) + radius
    return acb(real, imag)
