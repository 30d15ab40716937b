"""Paths in the q-plane on which something is proved piece by piece: the splitting goes on, Δ̂ turns, V is passive.

Points are complex floats q̂ (scaled); σ̂ = i q̂. Every piece stands for a disc of σ̂ that holds it. Pieces are chosen
by halving; then one pass over all paths proves everything at once: each point has one thin splitting, to which all
pieces that meet there are linked.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from mpsolve.characteristic.bordered import Arrays
from mpsolve.characteristic.discs import Splittings, linked, split
from mpsolve.errors import PrecisionError
from mpsolve.numbers.jets import UP, Jet, U
from mpsolve.proof.cover import cover, halfway
from mpsolve.proof.effort import Effort
from mpsolve.proof.turning import Regular, pivot_arguments, regular

Kind = Literal["link", "turn", "passive"]
_ROUNDS = 8
_DEFINITE = 0.9
_ROOM = 1.3  # pieces are planned on discs this much larger, so that a checker with wider bounds passes them too


@dataclass(frozen=True)
class Path:
    """Break points in order, and what is proved between them.

    radius: of the circle round 0 of which slanted pieces are arcs: their discs hold the arcs. 0: all are straight.
    """

    kind: Kind
    points: Any
    radius: float = 0.0

    @property
    def pieces(self) -> int:
        return len(self.points) - 1


@dataclass(frozen=True)
class Proved:
    """Paths whose pieces all passed; for each the change of arg Δ̂ and a bound of its error (0 unless it turns).

    corners: G between the places (middle, radius) at the last point of each path.
    """

    paths: tuple[Path, ...]
    turns: tuple[tuple[float, float], ...]
    corners: tuple[tuple[Any, Any], ...]

    @property
    def pieces(self) -> int:
        return sum(path.pieces for path in self.paths)


@dataclass(frozen=True)
class Paths:
    """The tests of a problem with `up` p-roots in U."""

    arrays: Arrays
    up: int

    def plan(self, kind: Kind, points: Any, effort: Effort, radius: float = 0.0) -> Path:
        """A path through `points` whose pieces pass the test of its kind, links left aside."""
        points = np.asarray(points, complex)
        if len(points) < 2:
            return Path(kind, points, radius)
        return Path(kind, cover(points, self._test(kind), effort, radius=radius), radius)

    def _test(self, kind: Kind) -> Any:
        def passes(a: Any, b: Any) -> Any:
            with np.errstate(all="ignore"):  # what is not bounded is ∞ or nan, and passes nothing
                return self._evaluate(kind, a, b, _ROOM)[1]

        return passes

    def _evaluate(self, kind: Kind, a: Any, b: Any, room: float = 1.0) -> tuple[Splittings, Any, Regular | None]:
        m, r = discs(a, b)
        r = r * room
        if kind == "link":
            s = split(self.arrays.D, m, r, self.up)
            return s, s.good, None
        s, G, good = self.arrays.evaluate(m, r, self.up)
        if kind == "turn":
            piece = regular(self.arrays.matrix(G, m))
            return s, good & piece.good, piece
        sigma = Jet(m[:, None, None], np.ones((len(m), 1, 1), complex), np.zeros((len(m), 1, 1)), r)
        drift = 1e-14 * (np.abs(m) + r)  # the piece runs through its rounded middle, along a rounded direction
        return s, good & positive(sigma * G, 1j * (b - a) / np.abs(b - a), drift), None

    def prove(self, paths: tuple[Path, ...], effort: Effort) -> Proved:
        """All pieces of all paths, linked; pieces that fail are halved a few times. Raises PrecisionError."""
        for _ in range(_ROUNDS):
            with np.errstate(all="ignore"):
                proved = self._pass(paths, effort)
            if isinstance(proved, Proved):
                return proved
            paths = proved
        raise PrecisionError(
            "pieces of the paths cannot be joined to their neighbours: the p-roots are nearly multiple"
        )

    def _pass(self, paths: tuple[Path, ...], effort: Effort) -> Proved | tuple[Path, ...]:
        points, index = np.unique(np.concatenate([path.points for path in paths]), return_inverse=True)
        effort.spend(len(points) + sum(path.pieces for path in paths))
        thin, G, good = self.arrays.evaluate(1j * points, np.zeros(len(points)), self.up)
        A = self.arrays.matrix(G, 1j * points)
        turns, refined, whole, at = [], [], True, 0
        for path in paths:
            here = index[at : at + len(path.points)]
            at += len(path.points)
            passed, turn = self._path(path, here, thin, A, good)
            turns.append(turn)
            whole = whole and bool(passed.all())
            refined.append(Path(path.kind, _halved(path, passed), path.radius))
        if not whole:
            return tuple(refined)
        ends = np.cumsum([len(path.points) for path in paths]) - 1
        corners = tuple(
            (G.a[index[end]], G.e[index[end]] if good[index[end]] else np.inf * G.e[index[end]]) for end in ends
        )
        return Proved(paths, tuple(turns), corners)

    def _path(self, path: Path, here: Any, thin: Splittings, A: Jet, good: Any) -> tuple[Any, tuple[float, float]]:
        """(which pieces pass, (turn, its error)) of one path; `here` numbers its points among those of `thin`."""
        first, last = here[:-1], here[1:]
        if not len(first):
            return np.ones(0, bool), (0.0, 0.0)
        s, passed, piece = self._evaluate(path.kind, path.points[:-1], path.points[1:])
        passed = passed & linked(s, thin.take(first)) & linked(s, thin.take(last))
        if piece is None:
            return passed, (0.0, 0.0)
        start, lost, fine = pivot_arguments(piece, A.take(first))
        end, lost_too, fine_too = pivot_arguments(piece, A.take(last))
        passed = passed & fine & fine_too & good[first] & good[last]
        error = float((lost + lost_too).sum()) * UP + 1e-13 * len(first)
        return passed, (float((end - start).sum()), error)


def _halved(path: Path, passed: Any) -> Any:
    points = path.points
    middles = halfway(points[:-1], points[1:], path.radius)
    out = [points[:1]]
    for middle, b, good in zip(middles, points[1:], passed, strict=True):
        out.append(np.array([b] if good else [middle, b]))
    return np.concatenate(out)


def discs(a: Any, b: Any) -> tuple[Any, Any]:
    """Midpoints and radii in σ̂ of discs that hold the pieces from a to b, and any whose ends are rounded to a and b."""
    m = (a + b) / 2
    r = np.maximum(np.abs(a - m), np.abs(b - m)) * UP + 4 * U * (np.abs(a) + np.abs(b))
    return 1j * m, r


def positive(V: Jet, way: Any, drift: Any) -> Any:
    """True where V + V* is positive definite for t along `way` |t| ≤ r, to within `drift` of the line."""
    n = V.a.shape[1]
    with np.errstate(all="ignore"):
        H0, H1 = _hermitian(V.a), _hermitian(way[:, None, None] * V.b)
        finite = np.isfinite(V.a).all((1, 2)) & np.isfinite(V.e).all((1, 2))
        definite = np.linalg.eigvalsh(np.where(finite[:, None, None], H0, -np.eye(n)))[:, 0] > 0
        ok = finite & definite
        X, regular_ = _inverse_factor(np.where(ok[:, None, None], H0, np.eye(n)))
        ok = ok & regular_
        size, lost = np.abs(X), 64 * (n + 4) * U
        Xh, sizeh = np.swapaxes(X.conj(), 1, 2), np.swapaxes(size, 1, 2)
        r = V.r[:, None, None]
        rest = V.e + drift[:, None, None] * np.abs(V.b) + lost * (np.abs(V.a) + np.abs(V.b) * r)
        spread = (rest + np.swapaxes(rest, 1, 2)) / 2
        E = np.abs(X @ H0 @ Xh - np.eye(n)) + np.abs(X @ H1 @ Xh) * r + lost + size @ spread @ sizeh
        E = E * UP
        x = np.ones((len(E), n))
        for _ in range(12):
            y = np.einsum("bij,bj->bi", E, x)
            y = y + 0.02 * x
            x = y / y.max(1, keepdims=True)
        return ok & (np.max(np.einsum("bij,bj->bi", E, x) / x, axis=1) * UP < _DEFINITE)


def _inverse_factor(H: Any) -> tuple[Any, Any]:
    """X with X H X* ≈ I, and where there is one."""
    try:
        return np.linalg.inv(np.linalg.cholesky(H)), np.ones(len(H), bool)
    except np.linalg.LinAlgError:
        out, good = np.tile(np.eye(H.shape[1], dtype=complex), (len(H), 1, 1)), np.zeros(len(H), bool)
        for k, h in enumerate(H):
            try:
                out[k], good[k] = np.linalg.inv(np.linalg.cholesky(h)), True
            except np.linalg.LinAlgError:
                continue
        return out, good


def _hermitian(a: Any) -> Any:
    return (a + np.swapaxes(a.conj(), 1, 2)) / 2
