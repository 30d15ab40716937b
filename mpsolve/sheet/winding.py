"""How many induced frequencies there are: winding numbers of R·Δ over the sheet, of Δ over other regions.

The sheet is symmetric under q → −q̄, so half of its boundary is enough. With G± on the edge of the cut and
A± the principal arguments of its far-field factors at r = ρ (see far.py), the arcs close in themselves:

    below:  n = 1 + (A₊ − [arg G₊] from r₀ to ρ)/π,      above:  the same with G₋.

r₀ = 0 when the cuts are joined (α > α_C): the two halves are counted apart. Otherwise r₀ is a point of the
gap, and the sum of both halves counts the one connected sheet. For a load at rest without axial force r₀ lies
on the cut, and rest.py gives the change of argument round the branch point; for one mass at rest G±/s is followed.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import flint

from mpsolve.errors import PrecisionError
from mpsolve.model.branch import Track, pairing
from mpsolve.model.characteristic import characteristic
from mpsolve.model.edge import edge_roots, edge_value, resting_edge_value
from mpsolve.numbers.balls import rational_ball
from mpsolve.sheet.contour import Accept, Path, cover, turning
from mpsolve.sheet.scatter import far_argument, paired_roots
from mpsolve.spectrum.regions import Rectangle

acb, arb = flint.acb, flint.arb
Meter = Callable[[float], None]


def _silent(_here: float) -> None:
    """No progress report."""


def count_sheet(
    track: Track,
    start: float,
    rho: float,
    limit: int,
    meter: Meter = _silent,
    accept: Accept | None = None,
    at_rest: bool = False,
) -> tuple[int, Path]:
    """The proved number of roots of Δ on the physical sheet. `start` is 0 for joined cuts, else a point of the gap.

    `at_rest`: one mass with α = 0, or more with α = N = 0 and `start` from `resting_start`. Raises
    `PrecisionError` when the edge cannot be covered.
    """
    single = at_rest and len(track.eta_m) == 1
    values = resting_edge_value if single else edge_value
    step = _first_step(track, start, rho)
    path = cover(lambda r: _pair(values(track, r)), start, rho, step, limit, meter, accept)
    first, last = _pair(values(track, arb(start))), _pair(values(track, arb(rho)))
    far = _far_arguments(track, rho)
    pi = track.field.pi
    halves = [1 + (far[k] - turning(path, k, first[k], last[k])) / pi for k in (0, 1)]
    if start == 0:
        return sum(unique_integer(half) for half in halves), path
    closing = _closing_argument(track, single, rho, first) / pi if at_rest else 0
    return unique_integer(halves[0] + halves[1] + closing), path


def _closing_argument(track: Track, single: bool, rho: float, first: tuple[Any, Any]) -> Any:
    """Loads at rest. One mass: the turn of s = a + b (0 ≤ Arg s ≤ π) from edge to edge, which G±/s leaves out.

    More, without axial force: the turn of R·Δ round the branch point, from the lower to the upper edge.
    """
    if single:
        roots = edge_roots(track, arb(rho))
        return track.field.pi - 2 * (roots.a + roots.b).arg()
    return (first[1].conjugate() / first[0]).arg()


def _pair(value: Any) -> tuple[Any, Any]:
    return value.plus, value.minus


def _first_step(track: Track, start: float, rho: float) -> float:
    """Small against the distance to the first branch point."""
    if start:
        return start / 64
    return min(rho / 4096, float(abs(track.beta2.sqrt() - track.A).mid()) / 16)


def _far_arguments(track: Track, rho: float) -> list[Any]:
    """A±: Arg(−R/(32ρ²)) and the argument of the rest of G±, by the factors that far.py keeps in half-planes."""
    roots, r, values = edge_roots(track, arb(rho)), arb(rho), _pair(edge_value(track, arb(rho)))
    resultant = (-roots.R / (32 * r * r)).arg()
    total = []
    for sign, value in zip((1, -1), values, strict=True):
        kappa = 2 * (r + sign * acb(0, 1) * track.eta_b) ** 2 / track.field.pi
        total.append(resultant + far_argument(track, roots, kappa, value / roots.R))
    return total


def unique_integer(value: Any) -> int:
    """The one integer in a real ball; `PrecisionError` unless there is exactly one."""
    n = value.unique_fmpz()
    if n is None:
        raise PrecisionError(f"the winding number's ball {value.str(6)} holds no single integer: raise the precision")
    return int(n)


def count_unstable(
    track: Track, reach: float, limit: int, meter: Meter = _silent, accept: Accept | None = None
) -> tuple[int, Path]:
    """The proved number of roots with Im q < 0, from the real line 0 ≤ q ≤ reach and its far arc.

    Needs no cut at Im q ≤ 0 (η_b > 0), and no root at |q − iη_b| ≥ reach.
    """
    path = cover(lambda q: (characteristic(track, acb(q)),), 0.0, reach, reach / 4096, limit, meter, accept)
    q = acb(reach)
    last = characteristic(track, q)
    far = far_argument(track, paired_roots(track, pairing(track, q)), 2 * q * q / track.field.pi, last)
    turn = turning(path, 0, acb(1), last)
    return unique_integer((far - turn) / track.field.pi), path


def count_rectangle(
    track: Track, box: Rectangle, limit: int, accept: Accept | None = None
) -> tuple[int, tuple[Path, ...]]:
    """The proved number of roots inside the rectangle, from its four sides, each run over 0 ≤ t ≤ 1."""
    corners = rectangle_corners(box)
    values = [characteristic(track, corner) for corner in corners]
    total, paths = arb(0), []
    for k in range(4):
        side = _cover_side(track, corners[k], corners[(k + 1) % 4], limit, accept)
        total += turning(side, 0, values[k], values[(k + 1) % 4])
        paths.append(side)
    return unique_integer(total / (2 * track.field.pi)), tuple(paths)


def _cover_side(track: Track, start: Any, end: Any, limit: int, accept: Accept | None) -> Path:
    def values(t: Any) -> tuple[Any, ...]:
        return (characteristic(track, start + t * (end - start)),)

    def confirmed(t: Any, wider: Any) -> bool:
        return accept is None or accept(*(start + s * (end - start) for s in (t, wider)))

    return cover(values, 0.0, 1.0, 1 / 64, limit, None, confirmed)


def rectangle_corners(box: Rectangle) -> list[Any]:
    """Counterclockwise from the lower left corner."""
    lo, hi, bottom, top = (rational_ball(x) for x in box.bounds)
    return [acb(lo, bottom), acb(hi, bottom), acb(hi, top), acb(lo, top)]
