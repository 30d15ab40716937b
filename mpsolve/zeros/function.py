"""What is counted and enclosed: a function on balls and its Taylor coefficients, of an expression or a callable."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import comb
from typing import Any, Protocol

from flint import acb, acb_series

from mpsolve.errors import InputError, PrecisionError
from mpsolve.numbers.balls import arb, bits_now, precision, square, terms
from mpsolve.numbers.taylor import SAMPLES, Taylor, taylor
from mpsolve.zeros.evaluate import Evaluator, coefficients
from mpsolve.zeros.fraction import factors, guards
from mpsolve.zeros.program import CUT, Expression, reduced

_NEAR = 6
_REAL_BITS = 128
Side = tuple[Any, Any]
"""A line (a ball of its points) and the direction away from it."""


class Function(Protocol):
    """An analytic function; all raise `PrecisionError` where a ball cannot be decided, or f may not be analytic."""

    @property
    def real(self) -> bool:
        """Whether f(z̄) is known to be the conjugate of f(z)."""

    @property
    def entire(self) -> bool:
        """Whether f is known to be analytic everywhere."""

    def series(self, z: Any, n: int, side: Side | None = None) -> list[Any]:
        """Balls of f^(k)/k!, k < n, over the ball z; with a side, continued to its line from there."""

    def require_analytic(self, z: Any, side: Side | None = None, beyond: Side | None = None) -> None:
        """`PrecisionError` unless f is proved to be analytic on z; see `Evaluator.sided`."""

    @property
    def parts(self) -> tuple[tuple[Function, int], ...]:
        """Functions and whole powers whose product f is, up to a constant; f itself where that is not known."""

    def part_series(self, z: Any, n: int, side: Side | None = None) -> list[list[Any]]:
        """`series` of each part."""

    def value(self, z: Any) -> Any: ...
    def slope(self, z: Any) -> Any: ...
    def both(self, z: Any) -> tuple[Any, Any]: ...

    def taylor(self, centre: Any, outer: Any, bits: int) -> Taylor:
        """The series about an exact centre, for discs within the radius `outer`."""


def _finite(values: list[Any]) -> list[acb]:
    if not values[0].is_finite():
        raise PrecisionError("f is not finite, or not analytic, on a ball")
    return values


class _Slopes:
    """What `series` gives besides."""

    def series(self, z: Any, n: int, side: Side | None = None) -> list[Any]:
        raise NotImplementedError

    def slope(self, z: acb) -> Any:
        return self.series(acb(z), 2)[1]

    def both(self, z: acb) -> tuple[acb, acb]:
        a, b = self.series(acb(z), 2)
        return a, b


@dataclass(frozen=True)
class ExpressionFunction(_Slopes):
    """One output of an expression: its numerator or its denominator."""

    expression: Expression
    output: int

    @cached_property
    def _evaluator(self) -> Evaluator:
        steps, _ = reduced(self.expression.steps, [self.output])
        return Evaluator(steps)

    @cached_property
    def _guarded(self) -> Evaluator | None:
        """Only what decides whether f is analytic; None where f is entire."""
        steps = self._evaluator.steps
        where = guards(steps)
        return Evaluator(reduced(steps, where)[0]) if where else None

    @property
    def entire(self) -> bool:
        return self._guarded is None

    @cached_property
    def real(self) -> bool:
        """Without a step `i` all is real for real z, but for roots and logarithms of constants that are negative."""
        own = self._evaluator
        with precision(_REAL_BITS):
            known = own.constants()
        named = (
            known[s[1]] for s, depends in zip(own.steps, own.depends, strict=True) if s[0] in CUT and not depends
        )
        cut = [w for w in named if w is not None]
        return all(step[0] != "i" for step in own.steps) and all(w.real > 0 or w == 0 for w in cut)

    @cached_property
    def _factors(self) -> dict[int, int]:
        return factors(self._evaluator.steps, len(self._evaluator.steps) - 1)

    @cached_property
    def parts(self) -> tuple[tuple[Function, int], ...]:
        whole = Expression(self._evaluator.steps, len(self._evaluator.steps) - 1)
        return tuple((ExpressionFunction(whole, k), power) for k, power in self._factors.items())

    def part_series(self, z: acb, n: int, side: Side | None = None) -> list[list[acb]]:
        values = self._run(z, n, side)
        return [_finite(coefficients(values[k], n)) for k in self._factors]

    def series(self, z: acb, n: int, side: Side | None = None) -> list[acb]:
        return _finite(coefficients(self._run(z, n, side)[-1], n))

    def _run(self, z: acb, n: int, side: Side | None) -> list[Any]:
        return self._evaluator.run(z, n) if side is None else self._evaluator.sided(z, max(n, 2), *side)

    def require_analytic(self, z: Any, side: Side | None = None, beyond: Side | None = None) -> None:
        if self._guarded is None:
            return
        if side is None:
            self._guarded.run(z, 1)
        else:
            self._guarded.sided(z, 2, *side, beyond)

    def value(self, z: Any) -> acb:
        return self.series(acb(z), 1)[0]

    def taylor(self, centre: acb, outer: arb, bits: int) -> Taylor:  # noqa: ARG002 — exact at any precision
        bound = arb(self.value(centre + square(outer)).abs_upper())
        return Taylor(centre, tuple(self.series(centre, SAMPLES)), bound, outer)


@dataclass(frozen=True)
class CallableFunction(_Slopes):
    """A Python function that takes and gives flint.acb, as the user vouches for: not finite where not analytic.

    derivative: the user's f′, or None; then acb_series is tried, and at last the values on a circle.
    """

    function: Callable[[Any], Any]
    derivative: Callable[[Any], Any] | None = None
    real: bool = False
    entire: bool = False

    @property
    def parts(self) -> tuple[tuple[Function, int], ...]:
        return ((self, 1),)

    def part_series(self, z: Any, n: int, side: Side | None = None) -> list[list[Any]]:
        return [self.series(z, n, side)]

    @cached_property
    def _takes_series(self) -> bool:
        try:
            with terms(3):
                found = self.function(acb_series([acb(0.3, 0.4), 1], prec=3))
            return isinstance(found, acb_series) and found.prec >= 3
        except Exception:  # noqa: BLE001 — whatever a user's function raises on what it was not made for
            return False

    def _ball(self, function: Callable[[Any], Any], z: acb) -> acb:
        try:
            given = function(acb(z))
            if isinstance(given, str):
                raise TypeError("a text")
            value = acb(given)
        except (ZeroDivisionError, ValueError, ArithmeticError):
            raise PrecisionError("f raises an error on a ball") from None
        except TypeError as error:
            raise InputError(
                "f", f"does not give flint.acb for flint.acb ({error}): give a function of balls"
            ) from None
        return _finite([value])[0]

    def value(self, z: Any) -> Any:
        return self._ball(self.function, z)

    def series(self, z: acb, n: int, side: Side | None = None) -> list[acb]:
        if side is not None:
            raise PrecisionError("a Python function cannot be continued to a branch cut")
        value = self.value(z)  # this is what the user vouches for: not finite where not analytic
        if n == 1:
            return [value]
        if self._takes_series:
            with terms(n):
                found = self.function(acb_series([acb(z), 1], prec=n))
            return _finite(coefficients(found, n))
        if n == 2 and self.derivative is not None:
            return [value, self._ball(self.derivative, z)]
        return self._from_values(acb(z), n)

    def _from_values(self, z: acb, n: int) -> list[acb]:
        """By Cauchy's bound on a larger disc about the middle of the ball."""
        middle, radius = z.mid(), abs(z - z.mid()).upper()
        outer = arb(max(abs(middle), arb(1)) * arb(2) ** -_NEAR)
        if not 8 * radius < outer:  # too wide for a bound of the slopes that helps
            return [self.value(z), *[acb("nan")] * (n - 1)]
        one = self.taylor(middle, outer, bits_now())
        if radius == 0:
            return list(one.coefficients[:n])
        offset, rest = z - middle, one.bound / outer**SAMPLES
        ratio = radius / outer
        out = []
        for k in range(n):
            total = acb(0)
            for j in range(SAMPLES - 1, k - 1, -1):
                total = total * offset + one.coefficients[j] * comb(j, k)
            # Σ_{j ≥ S} C(j, k) M r^{j−k} / R^j ≤ M R^{−k} ρ^{S−k} C(S, k)/(1 − ρ)^{k+1}
            tail = rest * (outer * ratio) ** (SAMPLES - k) * comb(SAMPLES, k) / (1 - ratio) ** (k + 1)
            out.append(total + square(arb(tail.upper())))
        return out

    def require_analytic(self, z: Any, side: Side | None = None, beyond: Side | None = None) -> None:  # noqa: ARG002
        if side is not None:
            raise PrecisionError("a Python function cannot be continued to a branch cut")
        self.value(z)

    def taylor(self, centre: acb, outer: arb, bits: int) -> Taylor:
        bound = arb(self.value(centre + square(outer)).abs_upper())
        if self._takes_series:
            return Taylor(centre, tuple(self.series(centre, SAMPLES)), bound, outer)
        return taylor(self.value, centre, outer, bound, max(4, bits // 8))
