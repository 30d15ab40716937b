"""The deformed contour in Re q ≥ 0 as paths q(u), each on the sheet of its section of the cut line.

A finite section is replaced by (half) an ellipse between its branch points, the last one by the parabola

    q = q_b + u²/2 + iδu,   that is p ≈ u + iδ,

which starts more flatly where a complex branch point of the continued sheet has to be passed below. `lift` follows
the sheet along the path, makes sure that no other branch point lies between it and the line, and finds the zeros of
Δ there by the argument principle, all in float64: the contour passes above such a zero, which gives a residue.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from mpsolve.model.branch import Track
from mpsolve.model.kernel import kernel_at_contact
from mpsolve.motion.sheets import PHYSICAL, Sheet, continued, followed, nearest, pairing_of, ranked
from mpsolve.motion.transform import system

_TINY = 1e-13  # where a graded path starts, relative to its length
_STEP = 2.0  # the largest change of phase from sample to sample
_SAME = 1e-6
_SECANTS = 50
_BELOW, _NEAR = 1e-3, 1e-7  # parts of the height: of the path below the line that closes the loop, of steps across it

Place = Callable[[Any], tuple[Any, Any]]
Loop = tuple[Any, Any, Sheet]  # points, s there, and the sheet


def ellipse(centre: complex, radius: float, height: float) -> Place:
    """Half an ellipse, from the branch point centre + radius at u = 0 over its top at u = π/2 to the one at u = π."""
    return lambda u: (
        centre + radius * np.cos(u) + 1j * height * np.sin(u),
        1j * height * np.cos(u) - radius * np.sin(u),
    )


@dataclass(frozen=True)
class Rise:
    """How an outgoing path q(u) = q_b + u²/2 + i h(u) leaves the line: h = δ₁u, and further out more steeply.

    Beyond `bend`, h grows by (δ − δ₁)(u − bend) more, and beyond `turn` by steep (u − turn)²/2.
    """

    first: float  # δ₁
    bend: float
    delta: float
    turn: float = 0.0
    steep: float = 0.0

    @property
    def breaks(self) -> list[float]:
        return sorted({x for x in (self.bend, self.turn) if x})

    def place(self, start: complex, scale: float) -> Place:
        def place(u: Any) -> tuple[Any, Any]:
            over = np.maximum(u - self.bend, 0.0)
            gain, later, far = self.delta - self.first, over > 0, np.maximum(u - self.turn, 0.0)
            height = self.first * u + gain * over + self.steep * far * far / 2
            slope = self.first + gain * later + self.steep * far
            return start + u * u / 2 + 1j * scale * height, u + 1j * scale * slope

        return place


def graded(first: float, last: float = 0.0, ratio: float = 2.0) -> Any:
    """Breaks at 0, near 0, and in geometric progression up to `first`, then up to `last`."""
    steps = int(np.ceil(np.log(1 / _TINY) / np.log(ratio)))
    breaks = np.concatenate([[0.0], first * np.geomspace(_TINY, 1.0, steps)])
    if last > first:
        more = int(np.ceil(np.log(last / first) / np.log(ratio)))
        breaks = np.concatenate([breaks, np.geomspace(first, last, more + 1)[1:]])
    return breaks


@dataclass(frozen=True)
class Lift:
    """A path that has been followed from its branch point: samples u, s there, and the zeros of Δ it passes above."""

    place: Place
    samples: Any
    sums: Any
    sheet: Sheet
    zeros: tuple[tuple[complex, complex], ...]  # q and s
    closed: bool  # it ends in a branch point

    def clearance(self, z: complex) -> float:
        """The distance of z from the path and from the line, at most 0.1."""
        q, _ = self.place(self.samples)
        base = self.place(np.array([0.0]))[0][0].imag
        return float(min(np.abs(q - z).min(), abs(z.imag - base), 0.1))

    def covers(self, z: complex) -> bool:
        """Whether z lies between the path and the line; for outgoing paths, Re q = Re q_b + u²/2."""
        start = self.place(np.array([0.0]))[0][0]
        if not z.real > start.real:
            return False
        return bool(self.place(np.array([np.sqrt(2 * (z - start).real)]))[0][0].imag > z.imag)

    def sums_at(self, track: Track, u: Any, q: Any) -> Any:
        """s at the points q(u): next to a branch point the nearest, far out by rank, else as followed."""
        first, last = self.samples[0], self.samples[-1]
        near = (u <= first) | ((u >= last) & self.closed)
        if self.sheet.rank:
            near |= u < last
        # np.interp is constant beyond the samples, where the rank drowns in rounding
        real, imag = (np.interp(u[near], self.samples, part) for part in (self.sums.real, self.sums.imag))
        s = np.empty(len(q), complex)
        s[near], s[~near] = nearest(track, q[near], real + 1j * imag), ranked(track, q[~near], self.sheet)
        return s


def lift(
    track: Track,
    family: Callable[[float], Place],
    scale: float,
    samples: Any,
    sheet: Sheet,
    mass: int | None = None,
    closed: bool = False,
) -> Lift | None:
    """The path family(scale), with the zeros of Δ (of one mass alone, if given) between it and the line.

    family(s) is the path lowered by the factor s, and starts in one branch point for all s; `samples` are its u. The
    loop around the zeros runs back just below the line, on the physical sheet, which the path's sheet continues. None
    where another branch point lies inside, the samples are too sparse, or a zero cannot be located.
    """
    low, high = (family(s * scale)(samples)[0] for s in (-_BELOW, 1.0))
    shares = np.concatenate([-np.geomspace(_BELOW, _NEAR, 60), np.geomspace(_NEAR, 1.0, 120)])
    across = np.array([family(s * scale)(samples[-1:])[0][0] for s in shares])
    own, below = followed(track, high, sheet), ranked(track, low, PHYSICAL)
    rising = continued(track, across, below[-1])
    if own is None or rising is None:
        return None
    end = ranked(track, high[-1:], sheet)[0]
    if max(abs(own[-1] - end), abs(rising[-1] - end)) > _SAME * (abs(end) + 1):
        return None
    around = np.concatenate([below, rising[1:]])
    q, s = np.concatenate([high[::-1], low, across[1:]]), np.concatenate([own[::-1], around])
    values = scaled_delta(track, q, s, mass)
    turns = np.log(values[1:] / values[:-1]) / (2j * np.pi)
    if not 2 * np.pi * np.abs(turns.real).max() < _STEP:
        return None
    count = abs(round(turns.sum().real))
    zeros: list[tuple[complex, complex]] | None = []
    if count:
        picked = np.arange(len(samples))[:: max(1, len(samples) // 40)]
        share = np.array([0.1, 0.3, 0.5, 0.7, 0.9])[:, None]
        starts, guesses = (
            (share * x[picked] + (1 - share) * y[picked]).ravel() for x, y in ((high, low), (own, below))
        )
        zeros = locate(track, starts, guesses, (q, s, sheet), count, mass)
    if zeros is None:
        return None
    zeros = [zero for zero in zeros if zero[0].imag > track.eta_b]  # those below are no part of the cut
    return Lift(family(scale), samples, own, sheet, tuple(zeros), closed)


def scaled_delta(track: Track, q: Any, s: Any, mass: int | None = None) -> Any:
    """R·Δ, which is finite and in general not 0 at a branch point."""
    pair = pairing_of(track, q, s)
    if mass is None:
        return pair.R * track.field.det(system(track, pair, q))
    return pair.R * (1 - 2 * q * q / np.pi * track.eta_m[mass] * kernel_at_contact(track, pair))


def locate(
    track: Track, starts: Any, guesses: Any, loop: Loop, count: int, mass: int | None
) -> list[tuple[complex, complex]] | None:
    """The zeros inside the loop, each with its s, by the secant method from many points; None unless all appear."""
    a, s = starts, nearest(track, starts, guesses)
    b = a * (1 + 1e-4)
    with np.errstate(all="ignore"):
        fa = scaled_delta(track, a, s, mass)
        for _ in range(_SECANTS):
            s = nearest(track, b, s)
            fb = scaled_delta(track, b, s, mass)
            step = np.where(fb == fa, 0, fb * (b - a) / (fb - fa))
            step = step * np.minimum(1, 0.3 / np.maximum(np.abs(step), 1e-300))
            a, fa, b = b, fb, b - step
        settled = np.abs(b - a) < 1e-11 * (1 + np.abs(b))
    found: list[tuple[complex, complex]] = []
    for z, sum_ in zip(b[settled].tolist(), nearest(track, b[settled], s[settled]).tolist(), strict=True):
        fresh = _encloses(loop[0], z) and all(abs(z - other) > 1e-7 for other, _ in found)
        if fresh and _same_sheet(track, z, sum_, loop):
            found.append((z, sum_))
    return found if len(found) == count else None


def _same_sheet(track: Track, z: complex, s: complex, loop: Loop) -> bool:
    """Whether s at z is that of the loop's sheet: a long step may have left it."""
    points, sums, sheet = loop
    own = ranked(track, np.array([z]), sheet)
    if sheet.rank:
        k = int(np.argmin(np.abs(points - z)))
        own = continued(track, points[k] + (z - points[k]) * np.linspace(0, 1, 200), sums[k])
    return own is not None and bool(abs(own[-1] - s) < _SAME * (1 + abs(s)))


def _encloses(loop: Any, z: complex) -> bool:
    ratios = (np.append(loop[1:], loop[0]) - z) / (loop - z)
    return bool(abs(np.angle(ratios).sum()) > np.pi)
