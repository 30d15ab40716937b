"""One motion in balls in the making, in scaled units: the path, the integral along it, and the residues.

That û is analytic between the line of the path and the parabola that leaves it, rows of cells prove.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from math import ceil, log
from typing import Any

import numpy as np

from mpsolve.errors import EffortError, PrecisionError
from mpsolve.numbers.balls import acb, arb, greatest, least
from mpsolve.progress import Progress
from mpsolve.proof.effort import Effort
from mpsolve.vibration.balls.far import Bound, far_field
from mpsolve.vibration.balls.image import BallImage, hull
from mpsolve.vibration.balls.integral import panels
from mpsolve.vibration.balls.residues import radius_round, residues
from mpsolve.vibration.path import Path, bent
from mpsolve.vibration.poles import lowest, natural, room

_MOST_TURNS = 3e5
"""ωt at most on the line."""
_LONGEST, _TURNS, _ECHOES = 3000.0, 10_000.0, 150.0
"""The largest r of the path, of r² t at the first time, and of r times the distance of the contacts: further on it
turns too often, or needs too many panels between the echoes of the contacts."""


class Work:
    """A motion at the times `at` ≥ 0 to so many digits, and the number of those that its parts lose.

    poles: balls of all roots of the problem that may lie to the right of the path's line, and of others. alone: how
    far round a σ̂ there is no root that is not among them.
    """

    def __init__(
        self,
        image: BallImage,
        poles: list[Any],
        line: Path,
        at: list[arb],
        digits: tuple[int, int],
        effort: Effort,
        said: Progress,
        alone: Callable[[complex], float],
    ) -> None:
        self.image, self.line, self.at, self.alone = image, line, at, alone
        self.digits, self.lost = digits
        self.late = [t for t in at if t > 0]
        self.effort, self.said = effort, said
        self.tones = image.tones()
        self.loaded = [acb(0)] + [sign * acb(0, 1) * rate for rate, _ in self.tones if rate != 0 for sign in (1, -1)]
        self.poles = poles
        self.span = float(max(image.at) - min(image.at))
        self.empty = np.full((image.image.channels, len(at)), arb(0), object)

    def parts(self, sizes: list[float]) -> tuple[Any, Any, Any, Any]:
        """The motion, and of it steady, harmonic and transient part, (channels, times) each."""
        goals = [arb(size) * arb(10) ** -(self.digits + 1) for size in sizes]
        path, radius, bounds = self._path()
        self.said("path", 1.0)
        along = self._started(self._integral(path, radius, bounds, goals) if self.late else None)
        if not all(z.real < self.line.alpha for z in self.poles):
            raise PrecisionError("a root may lie on the path: change a parameter a little")
        steady, harmonic = self._known(self._steady), self._known(self._modes)
        return along, steady, harmonic, along - steady - harmonic

    def _started(self, along: Any) -> Any:
        """With the times 0, where the rail is at rest, and no other channel is known."""
        rail = self.image.image.channels - len(self.image.seen)
        total = np.array(self.empty)
        total[:rail] = arb(0, float("inf"))
        for k, column in enumerate([k for k, t in enumerate(self.at) if t > 0]):
            total[:, column] = along[:, k]
        return total

    def _known(self, part: Callable[[], Any]) -> Any:
        """A part of which the sum does not depend: infinite balls where it is not proved, as on an undamped track."""
        try:
            return part()
        except EffortError:
            raise
        except PrecisionError:
            return np.full(self.empty.shape, arb(0, float("inf")), object)

    def _path(self) -> tuple[Path, float, list[Bound]]:
        """A path that is proved, and from where on û is bounded as told."""
        fast = [abs(complex(z.mid())) for z in (*self.poles, *self.loaded)]
        error: PrecisionError | None = None
        for path in bent(self.line, max([*fast, natural(self.image.image)]), self.span):
            if self.late and path.start**2 * float(max(self.late, key=float)) > _MOST_TURNS:
                stated = "a load or the vehicle turns too often on the path of balls"
                raise error or PrecisionError(f"{stated}: end earlier, or use float64")
            try:
                radius, bounds = far_field(self.image, path, path.start**2)
                self._arrived(bounds)
                prove_strip(self.image, path, radius, self.effort)
            except EffortError:
                raise
            except PrecisionError as found:
                error = found
                continue
            return path, radius, bounds
        raise error or PrecisionError("no path is proved: change a parameter")

    def _integral(self, path: Path, radius: float, bounds: list[Bound], goals: list[arb]) -> Any:
        """(1/π) Im ∫, with what is missed in the radii."""
        first, end = least(self.late), radius**0.5 * 1.001
        longest = min(_LONGEST, (_TURNS / float(first)) ** 0.5, _ECHOES / self.span if self.span else _LONGEST)
        while end < longest and any(
            not x < goal for x, goal in zip(self._tail(path, bounds, end, first), goals, strict=True)
        ):
            end *= 1.2
            bounds = far_field(self.image, path, end**2 / 1.2)[1]
        total = np.full((len(self.empty), len(self.late)), acb(0), object)
        missed = np.array([self._tail(path, bounds, end, t) for t in self.late], object).T
        share = [goal / 100 for goal in goals]
        for straight, leg in zip((True, False), path.legs(end), strict=True):
            for panel in panels(self.image, leg, straight, self.late, share, self.effort):
                missed = missed + np.array(panel.missed, object)
                for sigma, values in panel.nodes:
                    waves = np.array([(sigma * t).exp() for t in self.late], object)
                    total = total + np.multiply.outer(np.array(values, object), waves)
            self.said("integral", 0.5 if straight else 1.0)
        ball = np.vectorize(lambda value, off: (value.imag + arb(0, off.upper())) / arb.pi(), otypes=[object])
        return ball(total, missed)

    def _arrived(self, bounds: list[Bound]) -> None:
        """PrecisionError unless all waves have arrived at the first time."""
        last = greatest(bound.delay for bound in bounds)
        if self.late and not last < least(self.late):
            when = float(last / self.image.rate_ball)
            raise PrecisionError(
                f"a place is reached by waves at t = {when:.6g} only: give later times, or nearer places"
            )

    def _tail(self, path: Path, bounds: list[Bound], end: float, t: arb) -> list[arb]:
        """Bounds of what lies beyond r = end, by channels: ∫ |σ'| e^{αt − δ(r − r₀)(t − delay)} dr in closed form."""
        out = []
        for size, delay in bounds:
            rate = (t - delay) * path.delta
            wave = (t * path.alpha - rate * (arb(end) - path.start)).exp()
            out.append(size * wave * ((path.delta + 2 * arb(end)) / rate + 2 / rate**2))
        return out

    def _steady(self) -> Any:
        """What the loads keep up for ever."""
        total = self.empty
        for rate, force in self.tones:
            sigma = acb(0, 1) * rate
            values = self.image.response(self.image.on_axis(sigma), force)
            rows = [[(x * (sigma * t).exp()).real for t in self.at] for x in values]
            total = total + np.array(rows, object).reshape(self.empty.shape)
        return total

    def _modes(self) -> Any:
        """The motion at the induced frequencies."""
        total, last = self.empty, max(float(t) for t in self.at)
        for k, root in enumerate(self.poles):
            self.said("residues", k / len(self.poles))
            others = [z for z in self.poles if z is not root] + self.loaded
            middle = complex(root.mid())
            clear = middle.real - lowest(self.image.image)
            clear = min(clear if clear > 0 else room(self.image.image, middle), self.alone(middle))
            if not clear > 0:
                raise PrecisionError("roots beside one of these are not known: certify a larger region")
            radius = radius_round(root, others, clear, last)
            bits = ceil((self.digits + self.lost + 3) * log(10) / log(2))
            rows = residues(self.image, root, others, radius, self.at, bits, self.effort)
            total = total + np.array([[x.real for x in row] for row in rows], object).reshape(self.empty.shape)
        return total


_SIZE = 0.2
"""Of ω: the first try of a cell."""
_LEAST = 2.0**-16


def leftmost(path: Path, omega: float) -> float:
    """A lower bound of Re σ on the path at heights up to ω."""
    gone = arb(0).max(arb(omega).sqrt() - path.start)
    return math.nextafter(float((arb(path.alpha) - gone * path.delta).lower()), -math.inf)


def prove_strip(image: BallImage, path: Path, top: float, effort: Effort) -> int:
    """û is analytic between the line and the path up to the height `top`, which cells prove; their number.

    Each row of cells begins at the line, where the upper p-roots are known; PrecisionError where no cells prove it.
    """
    low = math.nextafter(path.start**2, 0.0)  # at or below the corner
    size, count = _SIZE * low, 0
    while low < top:
        high = low + size
        found = _row(image, path, low, high, effort)
        count += abs(found)
        if found > 0:
            low, size = high, max(1.3 * size, _LEAST)
            size = min(size, _SIZE * high)
        elif size < _LEAST * high:
            raise PrecisionError(
                "a root, or a point where p-roots meet, may lie between the cuts and the path: lower it"
            )
        else:
            size /= 2
    return count


def _row(image: BallImage, path: Path, low: float, high: float, effort: Effort) -> int:
    """The number of cells between two heights; below 0 where they do not prove it."""
    right, left, width, count = path.alpha, leftmost(path, high), high - low, 0
    point = acb(right, (low + high) / 2)
    cell = image.start(point)
    while right > left:
        next_right = max(right - width, left)
        ball = hull(acb(right, low), acb(next_right, high))
        effort.spend(1)
        count += 1
        try:
            cell = image.beside(ball, point, cell)
            image.sizes(cell)
        except PrecisionError:
            return -count
        right = next_right
        point = acb(right, (low + high) / 2)
    return count
