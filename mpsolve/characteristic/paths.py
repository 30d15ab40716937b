"""Paths in the q-plane on which something is proved piece by piece: the splitting goes on, Δ̂ turns, V is passive.

Points are complex floats q̂ (scaled); σ̂ = i q̂. Every piece stands for a disc of σ̂ that holds it. Pieces are chosen
by halving; then one pass over all paths proves everything at once: each point has one thin splitting, to which all
pieces that meet there are linked.

Where waves come to P = 0 at q = 0 no splitting passes; pieces that end there stand for a disc round σ̂ = 0, on which
`Origin` tells the p-roots apart.

A path begins where an earlier one ends, the first at the start, whose thin splitting is linked to the one that
`start` has told apart. So along every path U is the continuation of that at the start: over a piece it is analytic,
and at a point two pieces have the pair of the thin splitting there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import fsum
from typing import Any

import numpy as np

from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.discs import Splittings, linked, split
from mpsolve.characteristic.origin import Origin
from mpsolve.characteristic.path import Kind, Path, Proved, between, check_chain, discs, on_arc
from mpsolve.characteristic.start import Start
from mpsolve.errors import PrecisionError
from mpsolve.frozen import frozen
from mpsolve.numbers.float64 import distinct
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.proof.cover import cover, covered, evened, halved, joined
from mpsolve.proof.definite import positive
from mpsolve.proof.effort import Effort
from mpsolve.proof.turning import Regular, pivot_arguments, regular

_ROUNDS = 8
_HARD, _ORDER = 0.88, 0.6  # θ of a piece that is aimed at where pieces are spread evenly; θ^0.6 grows as their length
_SPREADS, _ROUGH, _SMOOTH = 4, 4.0, 3.0
ROOM = 1.03
"""Pieces are planned on discs this much larger, so that a checker with wider bounds passes them too."""
_BATCH = 2**19  # entries of the matrices of pieces that are tried at once
_ENDS = slice(None, -1), slice(1, None)  # which points pieces begin and end at

Waves = tuple[Splittings, Jet, Any]
"""Splittings, G between the places, and where it is bounded."""


@frozen
class Paths:
    """The tests of a problem whose splitting starts at `start`; pieces are planned on discs larger by `room`.

    origin: where waves come to P = 0 at q = 0.
    """

    arrays: Arrays
    start: Start
    room: float = ROOM
    origin: Origin | None = None

    @property
    def up(self) -> int:
        """The number of p-roots in U."""
        return self.start.up

    def plan(self, kind: Kind, points: Any, effort: Effort, arc: float | None = None) -> Path:
        """A path through `points` whose pieces pass the test of its kind, links left aside."""
        points = np.asarray(points, complex)
        if kind == "turn" and arc is None:
            return self.plan_turns([points], effort)[0]
        if len(points) < 2:
            return Path(kind, points)
        test = lambda a, b: self._tried(kind, a, b, effort)[0]  # noqa: E731
        found = cover(points, test, effort, middle=between(arc))
        return Path(kind, joined(found, test, effort, kind == "link") if arc is None else found, arc)

    def plan_turns(self, parts: Sequence[Any], effort: Effort) -> list[Path]:
        """Paths that turn, through the points of each part; pieces of all are tried at once."""
        long = self._spread([part for part in parts if len(part) > 1], effort)
        found = iter(covered(long, lambda a, b: self._tried("turn", a, b, effort)[0], effort))
        return [Path("turn", next(found) if len(part) > 1 else part) for part in parts]

    def _spread(self, parts: Sequence[Any], effort: Effort) -> Sequence[Any]:
        """Points between which the determinant is about as hard to keep from 0, as far as some rounds tell."""
        for _ in range(_SPREADS if parts else 0):
            ends = np.cumsum([len(part) - 1 for part in parts])
            effort.spend(int(ends[-1]))
            a, b = (np.concatenate([part[of] for part in parts]) for of in _ENDS)
            passed, theta = self._tried("turn", a, b, effort)
            hardness = np.minimum(np.nan_to_num(theta / _HARD, nan=np.inf) ** _ORDER, _ROUGH)
            hardness = np.where(passed | (hardness > 1), hardness, 2.0)
            parts = [evened(*one) for one in zip(parts, np.split(hardness, ends[:-1]), strict=True)]
            if (hardness < _SMOOTH).all():
                break
        return parts

    @property
    def _at_once(self) -> int:
        """How many pieces are tried at once: effort is asked about in between."""
        return max(1, _BATCH // (self.arrays.reduced.bodies + self.arrays.reduced.contacts) ** 2)

    def _batches(self, pieces: int, effort: Effort) -> Iterator[slice]:
        """Some pieces at a time; EffortError in between where the effort is spent."""
        for at in range(0, pieces, self._at_once):
            effort.spend(0)
            yield slice(at, min(at + self._at_once, pieces))

    def _tried(self, kind: Kind, a: Any, b: Any, effort: Effort) -> tuple[Any, Any]:
        """Which pieces pass on discs larger by `room`, and θ of those that turn."""
        with np.errstate(all="ignore"):  # pieces that are far too long overflow: nothing is proved of them
            found = [self._evaluate(kind, a[part], b[part], self.room) for part in self._batches(len(a), effort)]
        theta = [piece.theta for _, _, piece in found if piece is not None]
        return np.concatenate([passed for _, passed, _ in found]), np.concatenate(theta) if theta else None

    def _evaluate(
        self, kind: Kind, a: Any, b: Any, room: float = 1.0, known: Waves | None = None
    ) -> tuple[Splittings, Any, Regular | None]:
        m, r = discs(a, b)
        r = r * room
        if kind == "link" and self.origin is None:
            s = split(self.arrays.D, m, r, self.up)
            return s, s.good, None
        s, G, good = known or self._over(m, r, _at_zero(a, b), 2 * r)
        if kind == "link":
            return s, np.where(_at_zero(a, b), good, s.good), None
        if kind == "turn":
            piece = regular(self.arrays.matrix(G, _middles(a, b, m, self.origin)))
            return s, good & piece.good, piece
        sigma = Jet(m[:, None, None], np.ones((len(m), 1, 1), complex), np.zeros((len(m), 1, 1)), r)
        if self.origin is not None:
            good = good & ~_at_zero(a, b)  # their discs have another middle
        drift = 64 * U * (np.abs(m) + r)  # the piece runs through its rounded middle, along a rounded direction
        return s, good & positive(sigma * G, 1j * (b - a) / np.abs(b - a), drift), None

    def _over(self, m: Any, r: Any, at_zero: Any, radius: Any) -> Waves:
        """On discs, some of which stand for others round σ̂ = 0."""
        s, G, good = self.arrays.evaluate(m, r, self.up)
        return (s, G, good) if self.origin is None else (s, *self._at_origin(G, good, at_zero, radius))

    def _at_origin(self, G: Jet, good: Any, where: Any, radius: Any) -> tuple[Jet, Any]:
        """G and where it is bounded, with the discs round σ̂ = 0 put in."""
        a, b, e, r, good = G.a.copy(), G.b.copy(), G.e.copy(), G.r.copy(), good.copy()
        distances, pairs = self.arrays.distances
        for k in np.flatnonzero(where):
            found = self.origin(float(radius[k]), distances)  # type: ignore[misc]
            a[k], b[k], e[k] = (part[0][pairs] for part in (found.jet.a, found.jet.b, found.jet.e))
            r[k], good[k] = radius[k], found.good[0]
        return Jet(a, b, e, r), good

    def prove(self, paths: tuple[Path, ...], effort: Effort, reached: tuple[complex, ...] = ()) -> Proved:
        """All pieces of all paths, linked; pieces that fail are halved a few times. Raises PrecisionError.

        reached: further points at which paths may begin, as the pair of their thin splitting is known to be the one.
        """
        check_chain(paths, self.start.depth, reached)
        for _ in range(_ROUNDS):
            with np.errstate(all="ignore"):
                proved = self._pass(paths, effort)
            if isinstance(proved, Proved):
                return proved
            paths = proved
        raise PrecisionError(
            "pieces of the paths cannot be joined to each other: a root lies next to them, or p-roots nearly meet"
        )

    def _pass(self, paths: tuple[Path, ...], effort: Effort) -> Proved | tuple[Path, ...]:
        every = np.concatenate([path.points for path in paths])
        points = distinct(every)
        index = np.searchsorted(points, every)
        effort.spend(len(points) + sum(path.pieces for path in paths))
        felt = [path for path in paths if path.kind != "link"]
        together = felt if sum(path.pieces for path in felt) <= self._at_once else []
        a, b = (np.concatenate([points[:0], *(path.points[of] for path in together)]) for of in _ENDS)
        m, r = discs(a, b)
        at_zero, none = np.concatenate([points == 0, _at_zero(a, b)]), np.zeros(len(points))
        thin, G, good = self._over(
            np.concatenate([1j * points, m]), np.concatenate([none, r]), at_zero, np.concatenate([none, 2 * r])
        )
        if not linked(thin.take(index[:1]), self.start.splitting).all():
            raise PrecisionError("the splitting at the start is not found again to within rounding")
        turns, refined, whole, at, beyond = [], [], True, 0, len(points)
        for path in paths:
            here = index[at : at + len(path.points)]
            at += len(path.points)
            ready = beyond if together and path.kind != "link" else None
            beyond += 0 if ready is None else path.pieces
            passed, turn = self._path(path, here, (thin, G, good), points, ready, effort)
            turns.append(turn)
            whole = whole and bool(passed.all())
            middles = between(path.arc)(path.points[:-1][~passed], path.points[1:][~passed])
            refined.append(replace(path, points=halved(path.points, passed, middles)[0]))
        if not whole:
            return tuple(refined)
        ends = np.cumsum([len(path.points) for path in paths]) - 1
        corners = tuple(
            (G.a[index[end]], G.e[index[end]] if good[index[end]] else np.inf * G.e[index[end]]) for end in ends
        )
        return Proved(paths, tuple(turns), corners)

    def _path(
        self, path: Path, here: Any, waves: Waves, points: Any, ready: int | None, effort: Effort
    ) -> tuple[Any, tuple[float, float]]:
        """(which pieces pass, (turn, its error)) of one path; `here` numbers its points among all `points`.

        waves: at all points, and from number `ready` on those over its pieces.
        """
        thin, G, good = waves
        passed, turns, errors = on_arc(path), [], []
        for part in self._batches(path.pieces, effort):
            ends = slice(part.start, part.stop + 1)
            some, at = replace(path, points=path.points[ends]), here[ends]
            first, last = at[:-1], at[1:]
            rows = None if ready is None else np.arange(ready + part.start, ready + part.stop)
            known = None if rows is None else (thin.take(rows), G.take(rows), good[rows])
            s, fine, piece = self._evaluate(path.kind, some.points[:-1], some.points[1:], known=known)
            fine = fine & self._linked(some, s, thin.take(first), thin.take(last))
            if piece is not None:
                A = self.arrays.matrix(G.take(at), 1j * points[at])
                every = np.arange(len(at))
                start, lost, sharp = pivot_arguments(piece, A.take(every[:-1]))
                end, lost_too, sharp_too = pivot_arguments(piece, A.take(every[1:]))
                fine = fine & sharp & sharp_too & good[first] & good[last]
                turn = end - start  # each rounded to within U |turn|, their sum to nearest
                turns += turn.tolist()
                errors += [*lost, *lost_too, *(2 * U * np.abs(turn))]
            passed[part] &= fine
        turned = fsum(turns)
        return passed, (turned, fsum(errors) * UP + 2 * U * abs(turned))

    def _linked(self, path: Path, s: Splittings, start: Splittings, end: Splittings) -> Any:
        """Which pieces join on to the splittings at both of their ends; at q = 0 there is none."""
        joined = linked(s, start) & linked(s, end)
        if self.origin is not None:
            for k in np.flatnonzero(_at_zero(path.points[:-1], path.points[1:])):
                other = end if path.points[k] == 0 else start
                joined[k] = self.origin.links(other.take(np.array([k])), complex(other.m[k]))
        return joined


def _at_zero(a: Any, b: Any) -> Any:
    """Which pieces end at q = 0."""
    return (a == 0) | (b == 0)


def _middles(a: Any, b: Any, m: Any, origin: Origin | None) -> Any:
    """The middles of the discs: σ̂ = 0 for those that `origin` serves."""
    return m if origin is None else np.where(_at_zero(a, b), 0, m)
