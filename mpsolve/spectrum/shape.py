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
from mpsolve.numbers.reduction import Reduction
from mpsolve.spectrum.enclose import RootBall

_GUARD = 40


@dataclass(frozen=True)
class Shape:
    """Balls of complex amplitudes: `bodies` by the names of the coordinates, the largest is 1; `rail` at the `places`.

    A coordinate that is an angle is in radians per metre of the largest motion. places: in the problem's units.
    """

    bodies: dict[str, Any]
    places: tuple[Fraction, ...]
    rail: tuple[Any, ...]


def shape_of(proved: Proved, root: RootBall, places: Sequence[object] = ()) -> Shape:
    """The shape in a simple root; `PrecisionError` where the ball of the root is too wide to tell it."""
    if root.multiplicity > 1:
        raise PrecisionError("several roots meet in this ball, so it has no single shape: ask for more digits")
    reduced = proved.reduced
    exact = tuple(rational(x, "places") for x in places)
    with precision(max(64, root.q.rel_accuracy_bits() + _GUARD)):
        unit = rational_ball(1 / reduced.frequency_unit)
        sigma = acb(-root.q.imag * unit, root.q.real * unit)
        A = proved.matrices(sigma, slope=False)[0]
        kernel = Reduction.of(A, near_root=True).kernel(A)
        y, forces = kernel[: reduced.bodies], kernel[reduced.bodies :]
        motions = _motions(reduced, y)
        largest = max(motions, key=lambda x: float(abs(x.mid())))
        if largest.contains(0):
            raise PrecisionError("the ball of the root is too wide to tell its shape: ask for more digits")
        length = Fraction(2) ** reduced.guide.length
        scaled = [x / length for x in exact]
        distances = sorted({x - place for x in scaled for place in reduced.places})
        G = dict(zip(distances, proved.splitting(sigma).receptances(distances, slope=False)[0], strict=True))
        contacts = [reduced.places[k] for k in reduced.index]
        rail = tuple(
            -sum((f * G[x - at] for f, at in zip(forces, contacts, strict=True)), acb(0)) / largest for x in scaled
        )
        names = reduced.problem.pencil.names
        bodies = {
            name: acb(1) if x is largest else x / largest for name, x in zip(names, motions, strict=True)
        }
    return Shape(bodies, exact, rail)


def _motions(reduced: Any, y: Sequence[Any]) -> list[Any]:
    """The vehicle's own coordinates, in units in which the rail's are Ĝ: y = Q d ŷ, Q the basis of the felt part."""
    grown = [x * rational_ball(Fraction(2) ** k) for x, k in zip(y, reduced.scales, strict=False)]
    basis = reduced.parts.basis
    if basis is None:
        return grown
    return [
        sum((rational_ball(c) * x for c, x in zip(row, grown, strict=False) if c), acb(0)) for row in basis
    ]
