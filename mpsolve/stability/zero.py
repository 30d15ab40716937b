"""One real zero (x, t) of a family: proved in a box with no other zero, and sharpened to any number of digits."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import ALONG_Q, Track
from mpsolve.model.characteristic import (
    characteristic,
    characteristic_rates,
    determinant_rate,
    kernel_matrix,
    kernel_matrix_rates,
)
from mpsolve.stability.exclude import local
from mpsolve.stability.family import Family
from mpsolve.stability.holes import about, exact, holds, inward
from mpsolve.stability.krawczyk import ball_of, contracted, newton_step

acb, arb = flint.acb, flint.arb
BITS = 64
_GUARD = 16


@dataclass(frozen=True)
class Zero:
    """The one zero in the box centre ± reach (x, t), enclosed by the balls x and t.

    centre and reach: the proved box, exactly. direction: +1 where a root passes below the line as t (for masses: η)
    grows, −1 where one comes up.
    """

    x: Any
    t: Any
    centre: tuple[Fraction, Fraction]
    reach: tuple[float, float]
    direction: int

    @property
    def hole(self) -> tuple[float, float, float, float]:
        """The box of uniqueness, rounded inward: x from, x to, t from, t to."""
        x, t = (inward(about(c, h)) for c, h in zip(self.centre, self.reach, strict=True))
        return *x, *t

    @property
    def level(self) -> Any:
        """η, of a zero of a free mass level."""
        return mass_level(self)


def mass_level(zero: Any) -> Any:
    """η = πx/(2q²), x = (1 + q²) u/(1 − u), of a zero of a free mass level."""
    square = zero.x * zero.x
    return arb.pi() * (1 + square) * zero.t / (1 - zero.t) / (2 * square)


def value(family: Family, field: Any, x: Any, t: Any) -> Any:
    """The function of the family (without the factor R) at the balls x, t."""
    model = family.at(field, t)
    q = acb(x, family.height.ball())
    if family.parameter != "level":
        return characteristic(model, q)
    return field.det(_level_rows(model, kernel_matrix(model, q), 1 - t, t * (1 + q * q)))


def slopes(family: Family, field: Any, x: Any, t: Any) -> tuple[Any, Any, Any]:
    """The function and its derivatives along x and t."""
    model = family.at(field, t)
    q = acb(x, family.height.ball())
    if family.parameter != "level":
        f, (along_x, along_t) = characteristic_rates(model, q, (ALONG_Q, family.motion(len(model.eta_m))))
        return f, along_x, along_t
    kernels, (rates,) = kernel_matrix_rates(model, q, (ALONG_Q,))
    scale, order, eta = 1 + q * q, range(len(model.eta_m)), model.eta_m
    rows = _level_rows(model, kernels, 1 - t, t * scale)
    along_q = [[-t * (2 * q * kernels[j][k] + scale * rates[j][k]) * eta[k] for k in order] for j in order]
    along_u = [[-int(j == k) - scale * kernels[j][k] * eta[k] for k in order] for j in order]
    return field.det(rows), determinant_rate(model, rows, along_q), determinant_rate(model, rows, along_u)


def _level_rows(model: Track, kernels: Any, unit: Any, kappa: Any) -> Any:
    order = range(len(model.eta_m))
    return [[int(j == k) * unit - kappa * kernels[j][k] * model.eta_m[k] for k in order] for j in order]


def approach(family: Family, x: float, t: float, steps: int = 12) -> tuple[Any, Any] | None:
    """Newton's method on midpoints from (x, t): a point near a zero, or None. Heuristic."""
    with ball_arithmetic(BITS) as field:
        here = arb(x), arb(t)
        for _ in range(steps):
            try:
                step = _newton_step(family, field, *here)
            except PrecisionError:
                return None
            if step is None:
                return None
            here = (here[0] - step[0]).mid(), (here[1] - step[1]).mid()
            size = max(abs(float(here[k])) for k in (0, 1)) + 1e-3
            if max(abs(float(s)) for s in step) < 1e-13 * size:
                return here
            if not all(math.isfinite(float(h)) and abs(float(h)) < 1e6 for h in here):
                return None
    return None


def _newton_step(family: Family, field: Any, x: Any, t: Any) -> tuple[Any, Any] | None:
    return newton_step(*slopes(family, field, x, t))


def isolate(family: Family, x: Any, t: Any) -> Zero:
    """The largest box about the point that is proved to hold exactly one zero (interval Newton, Krawczyk's form).

    Raises `PrecisionError` when none is found.
    """
    x, t = x.mid(), t.mid()
    reach = _widest(family, x, t)
    with ball_arithmetic(BITS) as field:
        for k in range(8, 46, 2):
            small = 2.0**-k
            try:
                image = _krawczyk(family, field, x, t, small, small)
                if image is not None:
                    centre, wide = _box_of((x, t), small, reach, image)
                    return Zero(*image, centre, (wide, wide), _direction(family, field, *image))
            except PrecisionError:
                continue
    raise PrecisionError(
        f"a root touches the line near x = {float(x):.6g}, t = {float(t):.8g}, or two crossings are "
        "too close together to be told apart"
    )


def _box_of(
    point: tuple[Any, Any], small: float, wide: float, image: tuple[Any, Any]
) -> tuple[tuple[Fraction, Fraction], float]:
    """(centre, reach) of the wider of two proved boxes: that of the discs only if it holds the zero of the image."""
    if wide > small:
        centre = Fraction(float(point[0])), Fraction(float(point[1]))
        if all(holds(about(c, wide), ball) for c, ball in zip(centre, image, strict=True)):
            return centre, wide
    return (exact(point[0]), exact(point[1])), small


def _widest(family: Family, x: Any, t: Any) -> float:
    """The largest 2^−k for which discs prove that the box x ± 2^−k, t ± 2^−k holds one zero; or 0."""
    reaches = [2.0**-k for k in range(3, 24)]
    x, t = float(x), float(t)
    value, (along_x, along_t), good = local(family, (x, t), reaches)
    with ball_arithmetic(BITS):
        for k, reach in enumerate(reaches):
            if good[k]:
                f, fx, ft = (ball_of(z, k) for z in (value, along_x, along_t))
                if contracted(f, fx, ft, arb(x), arb(t), reach, reach) is not None:
                    return reach
    return 0.0


def _krawczyk(family: Family, field: Any, x: Any, t: Any, dx: Any, dt: Any) -> tuple[Any, Any] | None:
    """The image of the box x ± dx, t ± dt, if it is proved to hold exactly one zero."""
    _, fx, ft = slopes(family, field, arb(x, dx), arb(t, dt))
    if not (fx.is_finite() and ft.is_finite()):
        return None
    return contracted(value(family, field, x, t), fx, ft, x, t, dx, dt)


def _direction(family: Family, field: Any, x: Any, t: Any) -> int:
    """The sign of −Im dq/dt = Im(f_t/f_q), which is that of Im(conj(f_q) f_t)."""
    _, fx, ft = slopes(family, field, x, t)
    turn = (fx.conjugate() * ft).imag
    if turn > 0:
        return 1
    if turn < 0:
        return -1
    raise PrecisionError("the direction of a crossing is open: raise the precision")


def sharpen(family: Family, zero: Zero, digits: int) -> Zero:
    """The same zero with balls of relative radius below 10^−digits, proved to lie within the zero's box."""
    goal = math.ceil(digits * math.log2(10)) + _GUARD
    x, t = zero.x.mid(), zero.t.mid()
    ladder = [goal + _GUARD]
    while ladder[0] > 2 * BITS:
        ladder.insert(0, ladder[0] // 2 + 8)
    for bits in ladder:
        with ball_arithmetic(bits + 24) as field:
            step = _newton_step(family, field, x, t)
            if step is None:
                raise PrecisionError("Newton's method lost a crossing while sharpening it: ask for fewer digits")
            x, t = (x - step[0]).mid(), (t - step[1]).mid()
    with ball_arithmetic(goal + 3 * _GUARD) as field:
        for slack in range(2, 14, 3):
            dx, dt = (abs(v).upper() * arb((1, slack - goal)) for v in (x, t))
            image = _krawczyk(family, field, x, t, dx.upper(), dt.upper())
            if image is not None and zero.x.contains(image[0]) and zero.t.contains(image[1]):
                with ball_arithmetic(goal):
                    return Zero(+image[0], +image[1], zero.centre, zero.reach, zero.direction)
    raise PrecisionError(f"a crossing could not be sharpened to {digits} digits")
