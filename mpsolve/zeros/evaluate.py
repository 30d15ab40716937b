"""Values and Taylor coefficients of a program over a ball of z, in balls; analytic there, or refused by name.

On a ball that comes back, every step is analytic: a logarithm or square root whose argument may meet (−∞, 0], and a
quotient whose denominator may vanish, are refused. Beside a branch cut `sided` continues them from one side.

Beside a line. Let w be the argument of √ or log, real on the line, and Im(w′n) ≠ 0 on a box beside it, n the
direction from the line into the box. Then Im w ≠ 0, of the sign of Im(w′n), in the box off the line: w misses
(−∞, 0] there, and √w = ±i√(−w), log w = log(−w) ± iπ for Im w ≷ 0, which continue to the line where w misses [0, ∞).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import acb, acb_series, arb, fmpq

from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import bits_now, terms
from mpsolve.zeros.program import CUT, LEAVES, WITH_ORDER, Step, dependent


class CutError(PrecisionError):
    """A square root or logarithm may meet its branch cut."""


class PoleError(PrecisionError):
    """A denominator may vanish."""


def off_cut(w: acb) -> bool:
    """Whether a ball misses (−∞, 0]."""
    return bool(w.real > 0 or w.imag > 0 or w.imag < 0)


class Evaluator:
    """A program at the precision that is set; constants are kept for each precision."""

    def __init__(self, steps: Sequence[Step]) -> None:
        self.steps = tuple(steps)
        self.depends = dependent(self.steps)
        self._ready: dict[int, list[Any]] = {}

    def constants(self) -> list[acb | None]:
        """A fresh list with the constants in their places."""
        bits = bits_now()
        if bits not in self._ready:
            values: list[Any] = []
            for step, depends in zip(self.steps, self.depends, strict=True):
                values.append(None if depends else _constant(step, values))
            self._ready[bits] = values
        return list(self._ready[bits])

    def run(self, z: acb, n: int) -> list[Any]:
        """The values of all steps over the ball z: balls for n = 1, else power series of n terms in its offset."""
        values = self.constants()
        with terms(n):
            for k, step in enumerate(self.steps):
                if self.depends[k]:
                    values[k] = _applied(step, values, z, n)
        return values

    def sided(self, z: Any, n: int, line: Any, normal: Any, beyond: tuple[Any, Any] | None = None) -> list[Any]:
        """The same in a box z beside the line `line`, continued to it from the side of `normal`; n ≥ 2.

        beyond: a branch point at an end of the line, and the direction in which the line goes on from it away from
        the cut: then nothing is continued, and all is proved to be analytic on the closed box without that point.
        """
        values, on_line = self.constants(), self.constants()
        at_tip = self.constants()
        for k, step in enumerate(self.steps):
            if not self.depends[k]:
                continue
            if step[0] in CUT:
                one = values[step[1]], on_line[step[1]]
                if beyond is not None:
                    _require_beyond(step[0], one[0], at_tip[step[1]], beyond[1])
                    at_tip[k] = _hull(step[0], at_tip[step[1]])
                values[k], on_line[k] = _beside(step[0], *one, normal, beyond is not None)
            else:
                if beyond is not None:
                    at_tip[k] = _applied(step, at_tip, beyond[0], 1)
                values[k], on_line[k] = _applied(step, values, z, n), _applied(step, on_line, line, 1)
        return values


def coefficients(value: Any, n: int) -> list[acb]:
    """The first n Taylor coefficients of what `run` gives."""
    if not isinstance(value, acb_series):
        return [acb(value), *[acb(0)] * (n - 1)]
    return [value[k] for k in range(n)]


def constant_of(value: Any) -> acb:
    """The value itself, without the slopes."""
    return value[0] if isinstance(value, acb_series) else value


def _constant(step: Step, values: list[Any]) -> Any:
    if step[0] == "number":
        return acb(arb(fmpq(*map(int, step[1].split("/")))))
    if step[0] in LEAVES:
        return acb(0, 1) if step[0] == "i" else acb(arb.pi())
    return _applied(step, values, None, 1)


def _applied(step: Step, values: list[Any], z: Any, n: int) -> Any:
    name = step[0]
    if name == "z":
        return z if n == 1 else acb_series([z, 1], prec=n)
    a = values[step[1]]
    if name in _PLAIN:
        return _PLAIN[name](a, values[step[2]])
    if name == "pow":
        return a ** step[2]
    if name == "div":
        return _quotient(a, values[step[2]])
    if name in CUT and z is not None and not off_cut(constant_of(a)):  # of a constant the principal value is meant
        raise CutError(f"{name} may meet its branch cut")
    if name == "hyp0f1" and step[2] in ("1/2", "3/2") and (off_cut(constant_of(a)) or off_cut(-constant_of(a))):
        return _by_root(step[2], a)
    if name in WITH_ORDER:
        return _composed(_COEFFICIENTS[name], step[2], a)
    if name in ("atan", "sinh", "cosh"):
        return _other(name, a, z is not None)
    return getattr(a, name)()


def _other(name: str, a: Any, analytic: bool = True) -> Any:
    w = constant_of(a)
    if name == "atan" and not analytic:
        return a.atan()
    if name == "atan":  # cuts on the imaginary axis, from ±i outwards
        if not (w.real > 0 or w.real < 0 or (w.imag < 1 and w.imag > -1)):
            raise CutError("atan may meet its branch cut")
        return a.atan()
    if not isinstance(a, acb_series):
        return getattr(a, name)()
    b = acb(0, 1) * a
    return b.cos() if name == "cosh" else acb(0, -1) * b.sin()


_PLAIN: dict[str, Callable[[Any, Any], Any]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
}


def _quotient(a: Any, b: Any) -> Any:
    if not constant_of(b).abs_lower() > 0:
        raise PoleError("a denominator may vanish")
    return a / b


def _require_beyond(name: str, w: Any, w_tip: Any, away: Any) -> None:
    """On the line w is real: it must be ≥ 0 at the branch point and grow from there."""
    if off_cut(constant_of(w)):
        return
    grows = isinstance(w, acb_series) and (w[1] * away).real > 0
    if not (grows and w_tip.imag == 0 and w_tip.real >= 0):
        raise CutError(f"{name} may have a longer branch cut than is declared")


def _hull(name: str, w: Any) -> Any:
    """The value at one point, which may lie on the cut: then a ball that is not real."""
    if off_cut(w):
        return getattr(w, name)()
    if name != "sqrt" or not w.is_finite():
        raise CutError(f"{name} may meet its branch point")
    return _root_hull(w)


def _beside(name: str, w: Any, w_line: Any, normal: Any, beyond: bool) -> tuple[Any, Any]:
    """√ or log in the box and on its line."""
    w0 = constant_of(w)
    if off_cut(w0):
        return getattr(w, name)(), getattr(w_line, name)()
    if not isinstance(w, acb_series) or not w_line.imag == 0:
        raise CutError(f"{name} may meet its branch cut off the line of a declared cut")
    turn = (w[1] * normal).imag
    if not (turn > 0 or turn < 0):
        raise CutError(f"the side from which {name} comes to its branch cut cannot be told")
    up = acb(0, 1) if turn > 0 else acb(0, -1)
    if off_cut(-w0) and not beyond:
        return _continued(name, w, up), _continued(name, w_line, up)
    if name != "sqrt" or not w0.is_finite():
        raise CutError(f"{name} may meet its branch point")
    side = arb(0, w_line.abs_upper().sqrt().upper())  # continuous there, but without a slope
    return acb_series([_root_hull(w0), acb("nan")], prec=w.prec), acb(side, side)


def _root_hull(w: acb) -> acb:
    """A ball of all square roots of the numbers in w."""
    side = arb(0, w.abs_upper().sqrt().upper())
    return acb(side, side)


def _continued(name: str, w: Any, up: acb) -> Any:
    return up * (-w).sqrt() if name == "sqrt" else (-w).log() + up * arb.pi()


def _composed(coefficients_at: Callable[[Any, Any, int], list[Any]], parameter: Any, x: Any) -> Any:
    """f(x) for a power series x, by the Taylor coefficients of f about its constant term."""
    if not isinstance(x, acb_series):
        return coefficients_at(parameter, x, 1)[0]
    n = x.prec
    row = coefficients_at(parameter, x[0], n)
    offset = acb_series([0, *(x[k] for k in range(1, n))], prec=n)
    out = acb_series([row[-1]], prec=n)
    for c in reversed(row[:-1]):
        out = out * offset + c
    return out


def _by_root(parameter: str, u: Any) -> Any:
    """₀F₁(1/2; u) = cosh 2√u = cos 2√(−u), ₀F₁(3/2; u) = sinh 2√u/2√u = sin 2√(−u)/2√(−u): any root will do."""
    if off_cut(-constant_of(u)):
        s = 2 * (-u).sqrt()
        even, odd = s.cos(), s.sin()
    else:
        s = 2 * u.sqrt()
        even, odd = _other("cosh", s), _other("sinh", s)
    if parameter == "1/2":
        return even
    return odd / s if constant_of(s).abs_lower() > 0 else _composed(_hyp0f1, parameter, u)


def _hyp0f1(parameter: str, w: Any, n: int) -> list[Any]:
    """d/dw ₀F₁(a; w) = ₀F₁(a + 1; w)/a."""
    a = fmpq(*map(int, parameter.split("/")))
    out, factor = [], arb(1)
    for k in range(n):
        out.append(w.hypgeom_0f1(acb(arb(a + k))) / factor)
        factor = factor * arb(a + k) * (k + 1)
    return out


def _bessel_j(order: int, w: Any, n: int) -> list[Any]:
    """2 J_m′ = J_{m−1} − J_{m+1}."""
    rows = [w.bessel_j(acb(order + m)) for m in range(-(n - 1), n)]
    out, factor = [], 1
    for k in range(n):
        out.append(rows[len(rows) // 2] / factor)
        rows = [(rows[j] - rows[j + 2]) / 2 for j in range(len(rows) - 2)]
        factor *= k + 1
    return out


_COEFFICIENTS: dict[str, Callable[[Any, Any, int], list[Any]]] = {"hyp0f1": _hyp0f1, "bessel_j": _bessel_j}
