"""The shape of a vibration: the motion of every body and of the rail in one root, in balls.

At a root the bordered matrix has a null vector (y, λ): motions of the vehicle and forces of its contacts. The rail
moves as w(x) = −Σ λ_j G(x − x_j, σ). Everything is divided by the largest motion of the vehicle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, precision, rational_ball
from mpsolve.numbers.model import rational
from mpsolve.numbers.packed import Portable
from mpsolve.numbers.reduction import Reduction
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem

_GUARD = 40


@dataclass(frozen=True)
class Shape(Portable):
    """Balls of complex amplitudes: `bodies` by the names of their coordinates, the largest 1; `rail` at the `places`.

    A coordinate that is an angle is in radians per metre of the largest motion. places: in the problem's units.
    """

    bodies: dict[str, acb]
    places: tuple[Fraction, ...]
    rail: tuple[acb, ...]


def root_shape(problem: Problem, q: Any, multiplicity: int = 1, places: Sequence[object] | None = None) -> Shape:
    """The shape in a simple root with the ball q; places: where the rail is asked for, its contacts if None.

    `PrecisionError` where the ball is too wide to tell the shape, or several roots share it.
    """
    reduced = reduce_problem(problem)
    asked = problem.pencil.places if places is None else tuple(rational(x, "places") for x in places)
    if multiplicity > 1:
        raise PrecisionError("several roots meet in this ball, so it has no single shape: ask for more digits")
    with precision(max(64, q.rel_accuracy_bits() + _GUARD)):
        unit = rational_ball(1 / reduced.frequency_unit)
        return _shape(Proved(reduced, eliminate=False), acb(-q.imag * unit, q.real * unit), asked)


def _shape(proved: Proved, sigma: Any, asked: tuple[Fraction, ...]) -> Shape:
    """The shape at the root σ̂."""
    reduced = proved.reduced
    A, A_sigma = proved.matrices(sigma)
    kernel = Reduction.of(A, near_root=True, moves=A_sigma * sigma.mid()).kernel(A)
    y, forces = kernel[: reduced.bodies], kernel[reduced.bodies :]
    motions = _motions(reduced, y)
    largest = max(range(len(motions)), key=lambda k: float(abs(motions[k].mid())))
    scale = motions[largest]
    if scale.contains(0):
        raise PrecisionError("the ball of the root is too wide to tell its shape: ask for more digits")
    length = Fraction(2) ** reduced.guide.length
    scaled = [x / length for x in asked]
    contacts = [reduced.places[k] for k in reduced.index]
    distances = sorted({x - at for x in scaled for at in contacts})
    G = dict(zip(distances, proved.splitting(sigma).receptances(distances, slope=False)[0], strict=True))
    rail = tuple(
        -sum((f * G[x - at] for f, at in zip(forces, contacts, strict=True)), acb(0)) / scale for x in scaled
    )
    names = reduced.problem.pencil.names
    bodies = {
        name: acb(1) if k == largest else x / scale for k, (name, x) in enumerate(zip(names, motions, strict=True))
    }
    return Shape(bodies, asked, rail)


def _motions(reduced: Reduced, y: Sequence[Any]) -> list[acb]:
    """The vehicle's own coordinates, in units in which the rail's are Ĝ: y = Q d ŷ, Q the basis of the felt part."""
    grown = [x * rational_ball(Fraction(2) ** k) for x, k in zip(y, reduced.scales, strict=False)]
    basis = reduced.parts.basis
    if basis is None:
        return grown
    return [sum((rational_ball(c) * x for c, x in zip(row, grown, strict=False) if c), acb(0)) for row in basis]
