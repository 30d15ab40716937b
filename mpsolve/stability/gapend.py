"""Undamped and below α_C: the velocity ratios at which a root reaches the end q_lm of the gap, all of them proved.

The double p-root −x at q = q_lm > 0 gives everything explicitly. With z = x², S² = z² − 4Nz + 4,

    α = x (z − 2N)/S,   q_lm = (4 − z²)/(2S),   upper and lower p-root x ± iw, w² = 2 (z − 2N)(4 − z²)/S²,

and α grows from 0 to α_C as x does from √max(2N, 0) to √2: S³ S''/2 = z³ − 6Nz² + 12z − 8N is positive there. On the
double root R = 0, and the limit G of R·Δ is real; with κ = 2q_lm²/π the function whose zeros are isolated is

    F(x) = G/(κw) = −4π (η₁ + η₂) + (κ/w) R (K(0)² − K(d)K(−d))        for two masses, finite up to α_C,
    F(x) = G/κ                                                          for more.

One mass has G/(κw) = −4πη, so that its root never reaches the cut. Just inside the gap the pair of p-roots is
−x ± iτ with τ² ~ q_lm − q: a root with τ > 0 is one of the sheet, and dτ/dx = −F_x/F_τ tells which way it goes.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import flint

from mpsolve.dual import Dual
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import Track, track
from mpsolve.model.scaled import SplitRoots, scaled_characteristic
from mpsolve.numbers.exact import Exact
from mpsolve.problem.case import Case
from mpsolve.stability.entire import EntireBalls
from mpsolve.stability.search import Strip

acb, arb = flint.acb, flint.arb
_BITS = 96
_DEPTH = 22  # halvings of the range in x
_EFFORT = 1500  # pieces that are looked at
_NEAR = 1e-6  # open parts this close are one
_GUARD = 32


@dataclass(frozen=True)
class GapEnd:
    """At the velocity ratio `alpha` (ball) the root q = `q` = q_lm leaves the gap, or enters it (`appears`)."""

    alpha: Any
    q: Any
    appears: bool


@dataclass(frozen=True)
class _Curve:
    """The quantities above at x, with slopes along x if x is a dual number."""

    x: Any
    alpha: Any
    q: Any
    kappa: Any
    w: Any
    per_width: Any  # κ/w


def gap_ends(case: Case, low: Exact, high: Exact, digits: int) -> tuple[list[GapEnd], list[Strip]]:
    """Every α in [low, high] ∩ [0, α_C) at which a root reaches q_lm, and strips of α that stay open."""
    with ball_arithmetic(_BITS) as field:
        model = track(case, field)
        if len(model.eta_m) == 1:
            return [], []
        start, end = _bracket(model, low, high)
        if start >= end:
            return [], []
        found, rest = _isolated(model, start, end)
        strips = [_strip(model, a, b) for a, b in rest]
    ends = []
    for x in found:
        try:
            end_point = _sharpened(case, x, digits)
        except PrecisionError as error:
            with ball_arithmetic(_BITS) as field:
                strips.append(_strip(track(case, field), float(x.lower()), float(x.upper()), str(error)))
            continue
        if end_point.alpha < low.ball() or end_point.alpha > high.ball():
            continue
        ends.append(end_point)
    return sorted(ends, key=lambda e: float(e.alpha.mid())), strips


def _bracket(model: Track, low: Exact, high: Exact) -> tuple[float, float]:
    """Floats in x, between which α runs through [low, high] as far as it is below α_C."""
    axial = float(model.axial)
    first, last = math.sqrt(max(2 * axial, 0.0)), math.sqrt(2)

    def speed(x: float) -> float:
        z = x * x
        return x * (z - 2 * axial) / math.sqrt(z * z - 4 * axial * z + 4)

    def inverse(alpha: float) -> float:
        a, b = first, last
        for _ in range(60):
            a, b = ((a + b) / 2, b) if speed((a + b) / 2) < alpha else (a, (a + b) / 2)
        return (a + b) / 2

    start, end = inverse(float(low)) - 2.0**-40, inverse(float(high)) + 2.0**-40
    start = start if start > first and _curve(model, arb(start)).alpha < low.ball() else _below(first)
    end = end if end < last and _curve(model, arb(end)).alpha > high.ball() else math.nextafter(last, 2)
    return start, end


def _below(x: float) -> float:
    return max(0.0, math.nextafter(x, 0))


def _positive(x: Any) -> Any:
    """√max(x, 0), for a number that is not negative in exact terms."""
    if isinstance(x, Dual):
        root = _positive(x.value)
        return Dual(root, [slope / (2 * root) for slope in x.slopes])
    return x.sqrt() if x > 0 else arb(0).union(arb(max(x.upper(), arb(0)).sqrt().upper()))


def _curve(model: Track, x: Any) -> _Curve:
    N, z = model.axial, x * x
    lift, fall = z - 2 * N, 4 - z * z
    square = lift * lift + 4 * (1 - N * N) if N > 0 else z * (z - 4 * N) + 4
    S = _positive(square)
    w2 = 2 * lift * fall / square
    w, q, ratio = _positive(w2), fall / (2 * S), S / (4 * lift)
    pi = model.field.pi
    return _Curve(x, x * lift / S, q, 2 * q * q / pi, w, 2 / pi * ratio * ratio * w2 * w)


def _function(model: Track, curve: _Curve) -> Any:
    """F, as a real number (with its slope)."""
    field = EntireBalls(model.field)
    moving = replace(model, field=field, alpha=curve.alpha)
    x, lean = _complex(curve.x), _complex(curve.w) * acb(0, 1)
    roots = SplitRoots(-x, x + lean, -x, x - lean)
    if len(model.eta_m) == 2:
        pairs = scaled_characteristic(moving, roots, [acb(1)], 0)[0]
        value = pairs * _complex(curve.per_width) - 4 * field.pi * sum(model.eta_m)
    else:
        value = scaled_characteristic(moving, roots, [_complex(curve.kappa)])[0] / _complex(curve.kappa)
    return Dual(value.value.real, [s.real for s in value.slopes]) if isinstance(value, Dual) else value.real


def _complex(x: Any) -> Any:
    return Dual(acb(x.value), [acb(s) for s in x.slopes]) if isinstance(x, Dual) else acb(x)


def _value_and_slope(model: Track, x: Any) -> tuple[Any, Any]:
    """F and F_x on a ball of x."""
    f = _function(model, _curve(model, Dual(x, [arb(1)])))
    return f.value, f.slopes[0]


def _isolated(model: Track, start: float, end: float) -> tuple[list[Any], list[tuple[float, float]]]:
    """Balls of x that each hold one zero of F, and the parts of [start, end] that stay open."""
    found: list[Any] = []
    rest: list[tuple[float, float]] = []
    stack, effort = [(start, end, 0)], 0
    while stack:
        a, b, depth = stack.pop()
        effort += 1
        verdict = _verdict(model, a, b) if effort <= _EFFORT else None
        if verdict is False:
            continue
        if verdict is True:
            found.append(arb(a).union(arb(b)))
        elif depth >= _DEPTH or effort > _EFFORT:
            rest.append((a, b))
        else:
            cut = a + 0.4921875 * (b - a)  # off the simple numbers at which a zero might lie
            stack += [(a, cut, depth + 1), (cut, b, depth + 1)]
    found.sort(key=lambda x: float(x.mid()))
    return found, _joined(rest)


def _verdict(model: Track, a: float, b: float) -> bool | None:
    """False: no zero in [a, b]; True: exactly one, and none at its ends; None: open."""
    ball = arb(a).union(arb(b))
    try:
        value = _function(model, _curve(model, ball))
        if value.is_finite() and not value.contains(0):
            return False
        slope = _value_and_slope(model, ball)[1]
        if not slope.is_finite():
            return None
        middle = arb((a + b) / 2)
        centred = _function(model, _curve(model, middle)) + slope * (ball - middle)
        if not centred.contains(0):
            return False
        if slope.contains(0):
            return None
        left, right = (_function(model, _curve(model, arb(x))) for x in (a, b))
    except PrecisionError:
        return None
    product = left * right
    return True if product < 0 else False if product > 0 else None


def _joined(parts: list[tuple[float, float]]) -> list[tuple[float, float]]:
    result: list[tuple[float, float]] = []
    for a, b in sorted(parts):
        if result and a <= result[-1][1] + _NEAR:
            result[-1] = (result[-1][0], max(b, result[-1][1]))
        else:
            result.append((a, b))
    return result


def _strip(model: Track, a: float, b: float, reason: str = "") -> Strip:
    ball = _curve(model, arb(a).union(arb(b))).alpha
    low, high = (float(_curve(model, arb(x)).alpha.mid()) for x in (a, b))
    if ball.is_finite():
        low, high = float(ball.lower()), float(ball.upper())
    reason = reason or "two roots may reach the end of the gap together, or the p-roots all meet: change a parameter"
    return Strip(max(low, 0.0), high, reason)


def _sharpened(case: Case, x: Any, digits: int) -> GapEnd:
    """The zero in the ball x, by interval Newton at the precision that the digits need."""
    goal = math.ceil(digits * math.log2(10)) + _GUARD
    image = x
    for bits in (*_ladder(goal), goal + 2 * _GUARD):
        with ball_arithmetic(bits) as field:
            model = track(case, field)
            for _ in range(60):
                middle = image.mid()
                slope = _value_and_slope(model, image)[1]
                step = _function(model, _curve(model, middle)) / slope
                if not step.is_finite():
                    raise PrecisionError("a cut point could not be sharpened: change a parameter a little")
                narrower = image.intersection(middle - step)
                done = not narrower.rad() < image.rad() / 2
                image = narrower
                if done:
                    break
    with ball_arithmetic(goal + 2 * _GUARD) as field:
        model = track(case, field)
        curve = _curve(model, image)
        if not (curve.alpha.rad() < abs(curve.alpha) * arb(10) ** -digits):
            raise PrecisionError(f"a cut point could not be sharpened to {digits} digits")
        return GapEnd(curve.alpha, curve.q, _appears(model, image))


def _ladder(goal: int) -> list[int]:
    steps = [_BITS]
    while 2 * steps[-1] < goal:
        steps.append(2 * steps[-1])
    return steps


def _appears(model: Track, x: Any) -> bool:
    """Whether τ grows with x."""
    curve, field = _curve(model, x), EntireBalls(model.field)
    lean, still = acb(0, curve.w), acb(0)
    spread = Dual(acb(-curve.x), [acb(0, 1)]), Dual(acb(-curve.x), [acb(0, -1)])
    roots = SplitRoots(spread[0], Dual(curve.x + lean, [still]), spread[1], Dual(curve.x - lean, [still]))
    moving = replace(model, field=field, alpha=curve.alpha)
    along = scaled_characteristic(moving, roots, [acb(curve.kappa)])[0].slopes[0].real
    turn = _value_and_slope(model, x)[1] * along
    if turn > 0 or turn < 0:
        return bool(turn < 0)
    raise PrecisionError("whether a root leaves the gap or enters it is open: ask for more digits")
