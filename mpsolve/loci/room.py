"""Where tubes may stand, so that what each holds is the determinant of the physical sheet.

A tube holds the determinant continued from the middle of its box over the box, a disc B round q₀ for an interval of x̂
on which no upper p-root meets a lower one. Its kind: BELOW, Im q₀ below the cuts for all x̂ of the interval; ABOVE;
GAP, B meets no cut. At each x̂ a tube of kind BELOW holds the determinant of the sheet in the part of B below the line
of the cuts, and in all of B if B meets the line in the gap alone: B holds no branch point, where an upper and a lower
p-root meet, as its continuation along the straight way from q₀ to there is that of the sheet.

Two tubes of kind BELOW whose discs meet at some x̂ hold the same function there: mirrored in the line what is above it
in both discs lies in both, so that they meet below it. So do two of kind GAP, and one of kind GAP and one of kind
BELOW: if B of the latter meets the line in a cut, what of B is above the line lies over the cut, and not in the gap.
With ABOVE likewise. So a chain may go from any kind to GAP, and from GAP to any kind, but not from BELOW to ABOVE.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from flint import fmpq, fmpq_poly

from mpsolve.characteristic.free_proved import value_at
from mpsolve.cuts.edge import beam
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.plain import outward
from mpsolve.numbers.realroots import is_positive
from mpsolve.problem.family import Family

if TYPE_CHECKING:
    from mpsolve.numbers.several import Several

BELOW, GAP, ABOVE = -1, 0, 1
_SHARES = (1 - 1e-9, 1 - 1e-3, 0.5)  # of the gap in floats: what is tried
_POINTS = 200


@dataclass(frozen=True)
class Room:
    """From low to high in x̂; the middle of no tube has Im q̂ > top, which is below all cuts.

    off: of the radius of a box, how far off the cuts its middle is, at least.
    """

    low: float
    high: float
    top: float = math.inf
    off: float = 0.0

    @property
    def width(self) -> float:
        """Of the range."""
        return self.high - self.low

    def height(self, ends: tuple[float, float]) -> tuple[float, float]:  # noqa: ARG002
        """Floats between which the line of the cuts lies for these x̂; here what is below them all."""
        return self.top, self.top

    def gap(self, ends: tuple[float, float]) -> float:  # noqa: ARG002
        """No q̂ with |Re q̂| < this is on a cut, for any x̂ between the ends; 0 where none is proved."""
        return 0.0

    def kind_of(self, q: complex, radius: float, x: float) -> int:
        """Of a disc at x̂ that holds a root of the sheet; GAP where it may meet the line of the cuts."""
        if not self.off:
            return BELOW
        low, high = self.height((x, x))
        slack = radius * (1 + 2.0**-20)
        return BELOW if q.imag + slack < low else ABOVE if q.imag - slack > high else GAP

    def placed(
        self, q: complex, rho: float, ends: tuple[float, float], kind: int, begins: bool
    ) -> tuple[complex, int] | None:
        """(the middle of a box that is tried for a chain of this kind at q, its kind).

        In the gap where the box lies there; else on the chain's side, or behind the gap on that of its root.
        """
        if self.fits(q, rho, ends, GAP):
            return q, GAP
        if kind == GAP:
            if begins:
                return None
            low, high = self.height(ends)
            kind = BELOW if q.imag < low / 2 + high / 2 else ABOVE
        return self.kept(q, kind, ends, self.off * rho), kind

    def kept(self, q: complex, kind: int, ends: tuple[float, float], off: float = 0.0) -> complex:
        """The nearest point at which a tube of that kind may stand, so far off the cuts at least."""
        if kind == GAP:
            return q
        low, high = self.height(ends)
        if kind == BELOW:
            return complex(q.real, min(q.imag, math.nextafter(low - off, -math.inf)))
        return complex(q.real, max(q.imag, math.nextafter(high + off, math.inf)))

    def fits(self, q: complex, rho: float, ends: tuple[float, float], kind: int) -> bool:
        """Whether a box with that middle is of that kind."""
        if kind == GAP:
            return (abs(q.real) + rho) * (1 + 2.0**-20) < self.gap(ends)
        low, high = self.height(ends)
        return q.imag < low if kind == BELOW else q.imag > high

    def holds(self, q: Any, kind: int, x: float) -> bool:
        """Whether a ball of a root of the sheet at x̂ is proved to lie where a tube of that kind holds the sheet's."""
        if not self.off or kind == GAP:
            return True
        low, high = self.height((x, x))
        side = bool(q.imag < low) if kind == BELOW else bool(q.imag > high)
        return side or bool(abs(q.real) < self.gap((x, x)))


@dataclass(frozen=True)
class SheetRoom(Room):
    """The whole sheet of a family of beams whose cuts lie on the lines Im q̂ = η̂(x̂)."""

    family: Family = field(kw_only=True)
    off: float = 0.125
    _gaps: dict[tuple[float, float], float] = field(default_factory=dict, compare=False)

    @cached_property
    def _beam(self) -> list[Several]:
        return beam(self.family)

    @cached_property
    def _still(self) -> tuple[float, float] | None:
        """η̂ between floats, if it does not depend on x̂."""
        _, _, _, m, c, *_ = self._beam
        return None if any(any(e) for part in (m, c) for e, _ in part) else self._height(self.low, self.high)

    def _height(self, low: float, high: float) -> tuple[float, float]:
        with precision(64):
            _, _, _, m, c, *_ = self._at(low, high)
            height = c / (2 * m)
            return outward(height, up=False), outward(height, up=True)

    def _at(self, low: float, high: float) -> list[arb]:
        """EI, T, k, m, c, v and the numerator as balls, for all x̂ between."""
        box = [acb(arb(low).union(arb(high)))]
        return [value_at(part, box).real for part in self._beam]

    def height(self, ends: tuple[float, float]) -> tuple[float, float]:
        return self._still or self._height(*ends)

    def gap(self, ends: tuple[float, float]) -> float:
        if ends not in self._gaps:
            self._gaps[ends] = self._gap(*ends)
        return self._gaps[ends]

    def _gap(self, low: float, high: float) -> float:
        """EI p⁴ − (T + m v²) p² − 2 m v z p + k − c²/4m − m z² > 0 for all p ≥ 0, with the worst of each number."""
        with precision(64):
            EI, T, k, m, c, v, _ = self._at(low, high)
            least, rest = outward(EI, up=False), outward(k - c * c / (4 * m), up=False)
            pull, mass, speed = outward(T, up=True), outward(m, up=True), outward(arb(v.abs_upper()), up=True)
        p = np.linspace(0, 2 * ((abs(pull) + mass * speed**2) / least) ** 0.5 + 1, _POINTS)
        for _ in range(3):
            waves = np.sqrt(np.maximum((least * p**4 - pull * p**2 + rest) / mass, 0)) - speed * p
            n = int(waves.argmin())
            p = np.linspace(p[max(n - 1, 0)], p[min(n + 1, _POINTS - 1)], _POINTS)
        for share in _SHARES if waves.min() > 0 else ():
            z = float(waves.min()) * share
            exact = [fmpq(*x.as_integer_ratio()) for x in (least, pull, rest, mass, speed, z)]
            a, t, r, w, s, y = exact
            if is_positive(fmpq_poly([r - w * y * y, -2 * w * s * y, -t - w * s * s, 0, a])):
                return z
        return 0.0
