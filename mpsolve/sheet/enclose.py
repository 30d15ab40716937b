"""Enclosures: a box proved to hold exactly one root of Δ, sharpened to any number of digits.

Existence and uniqueness come from interval Newton with interior containment: if m − Δ(m)/Δ_q(X) lies in the
interior of X, then X holds exactly one root. Precision doubles up to what is asked, and each step needs only
the value of Δ at the new precision: its slope comes from the step before.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid
from mpsolve.problem.case import Case

acb, arb = flint.acb, flint.arb

BASE_BITS = 80
_GUARD = 24
_MOST = 64  # times the bits that are asked for, at most, next to a branch point


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

    Costs about one evaluation of Δ at the last precision and half of that again below it; more next to a branch
    point, where the number of right digits does not double with each step.
    """
    goal = math.ceil(digits * math.log2(10)) + 1
    try:
        return _doubled(case, box, goal)
    except PrecisionError:
        pass
    image = _contracted(case, box, goal + _GUARD)
    with ball_arithmetic(goal + _GUARD + 10):
        ball = on_grid(image, goal, 1, box.symmetry)
        if not (box.q.contains(ball.q) and ball.q.contains(image)):
            raise PrecisionError(f"the root near {image.str(6)} could not be sharpened to {digits} digits")
    return ball


def _contracted(case: Case, box: Box, goal: int) -> Any:
    """The root to `goal` bits, by steps that need no more than to halve the ball; bits double where they do not."""
    image, bits = box.image, BASE_BITS
    while bits <= _MOST * goal:
        with ball_arithmetic(bits) as field:
            model = track(case, field)
            middle = onto_axis(image, box.symmetry).mid()
            try:
                slope = characteristic_rate(model, image)[1]
                step = onto_axis(middle - characteristic(model, middle) / slope, box.symmetry)
            except PrecisionError:
                step = acb("nan")
            if not (step.is_finite() and 2 * _reach(step) < _reach(image)):
                bits *= 2
                continue
            image = step
            if _reach(image) < image.abs_lower() * arb((1, -goal)):
                return image
    raise PrecisionError(f"the root near {image.str(6)} is too close to a branch point or to another root")


def _reach(image: Any) -> Any:
    return image.real.rad() + image.imag.rad()


def _doubled(case: Case, box: Box, goal: int) -> RootBall:
    """As in `refine`, where each step doubles the number of right digits; `PrecisionError` where one does not."""
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
        image = onto_axis(image, box.symmetry)
        ball = on_grid(image, goal, 1, box.symmetry)
        if not (box.q.contains(ball.q) and ball.q.contains(image)):
            raise PrecisionError(f"the root near {image.str(6)} did not get sharper fast enough")
    return ball


def _ladder(last: int) -> list[int]:
    """Precisions that end at `last` and roughly double, from the image of a box, whose last bits are rounding."""
    steps = [last]
    while steps[0] > 2 * (BASE_BITS - 16):
        steps.insert(0, steps[0] // 2 + 16)
    return steps
