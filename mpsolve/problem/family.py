"""A family: a problem with named parameters left free over exact intervals, in the form that is computed with.

D, N, S, B, h and the places are exact polynomials in the free parameters too (`Several`; a contact stiffness enters
by its inverse). All is scaled by the powers of two of the problem in the middle of the box, and each parameter by one
of its own, x = x̂ · unit. Factors (`scale.…`) are applied after all other parameters.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise, product
from math import log2
from typing import Any, cast

from mpsolve.errors import InputError
from mpsolve.numbers.linear import congruent, image
from mpsolve.numbers.several import Ring, Several
from mpsolve.problem.free_track import FreePolynomial, free_guide
from mpsolve.problem.parameters import changed
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Guide, Reduced, conjugate, reduce_problem, times, without_neutral
from mpsolve.tracks.waveguide import moving
from mpsolve.vehicles.vehicle import Pencil, Rows, joined

Interval = tuple[Fraction, Fraction]
_SHARES = (Fraction(1, 2), Fraction(3, 8), Fraction(9, 16))
"""Of the box: where the problem that scales stands; one after the other, as it must not be a wave speed."""


@dataclass(frozen=True)
class Family:
    """The problems of a box of parameters: Δ̂ = det [[S, −B], [Bᵀ, Ĝ + diag ĥ]] as in `Reduced`, with free entries.

    over: the interval of each path, in the problem's units; units: powers of two, x = x̂ · unit; box: of x̂.
    D, N (in P, σ, moving) and D_rest, N_rest (in P, s, at rest), v, places, S, B, h: scaled, over x̂.
    index: for each contact the number of its place. base: the problem that gave the scales.
    """

    problem: Problem
    over: Mapping[str, Interval]
    units: tuple[Fraction, ...]
    base: Reduced
    ring: Ring
    D_rest: FreePolynomial
    N_rest: FreePolynomial
    D: FreePolynomial
    N: FreePolynomial
    v: Several
    places: tuple[Several, ...]
    index: tuple[int, ...]
    S: tuple[tuple[tuple[Several, ...], ...], tuple[tuple[Several, ...], ...], tuple[tuple[Several, ...], ...]]
    B: Any
    h: tuple[Several, ...]

    @property
    def paths(self) -> tuple[str, ...]:
        """Of the free parameters, in the order of x̂."""
        return tuple(self.over)

    @cached_property
    def box(self) -> tuple[Interval, ...]:
        """The intervals of x̂."""
        return tuple((a / u, b / u) for (a, b), u in zip(self.over.values(), self.units, strict=True))

    @cached_property
    def felt(self) -> tuple[bool, ...]:
        """Of each parameter whether the track, its velocity or the places of the contacts depend on it."""
        told = [*self.D_rest.values(), *self.N_rest.values(), self.v, *self.places]
        return tuple(any(e[k] for c in told for e, _ in c) for k in range(len(self.paths)))

    @property
    def degree(self) -> int:
        """The number of p-roots."""
        return max(i for i, _ in self.D)

    @property
    def frequency_unit(self) -> Fraction:
        """q = q̂ · frequency_unit."""
        return self.base.frequency_unit

    def at(self, x: Sequence[Fraction]) -> Problem:
        """The problem at a point x̂."""
        problem = self.problem
        for path, unit, value in factors_last(list(zip(self.paths, self.units, x, strict=True))):
            problem = problem.changed(path, value * unit)
        return problem

    def guide(self, x: Sequence[Fraction]) -> Guide:
        """The track at a point x̂, in the family's scales."""
        D_rest, N_rest, D, N = (
            {key: value for key, c in a.items() if (value := c.at(x))}
            for a in (self.D_rest, self.N_rest, self.D, self.N)
        )
        old = self.base.guide
        return Guide(old.length, old.time, D_rest, N_rest, D, N, self.v.at(x), old.g)

    def reduced(self, x: Sequence[Fraction]) -> Reduced:
        """The problem at a point x̂ in the family's scales; its contacts keep their order and number of places."""
        S0, S1, S2 = (_values(rows, x) for rows in self.S)
        places, h = (tuple(c.at(x) for c in a) for a in (self.places, self.h))
        B, base = _values(self.B, x), self.base
        return Reduced(self.at(x), self.guide(x), places, self.index, (S0, S1, S2), B, h, base.parts, base.scales)


def family_of(problem: Problem, over: Mapping[str, Interval]) -> Family:
    """The family of `problem` with each path free over its closed interval, ends exact and in the problem's units.

    InputError for a path that there is not, ends that cannot be, a path whose numbers a later one sets, contacts
    that overtake each other within the box, and motions that contacts feel at some parameters only.
    """
    require_ends(problem, over)
    _require_none_undone(problem, over)
    units = tuple(Fraction(2) ** round(log2(max(abs(a), abs(b)) or 1)) for a, b in over.values())
    base, point = _base(problem, over, units)
    ring = Ring(tuple(over), point)
    track, vehicles, v = problem.track, problem.vehicles, cast(Any, problem.v)
    for path, unit, x in factors_last(list(zip(over, units, ring.variables, strict=True))):
        track, vehicles, v = changed(track, vehicles, v, path, x * unit)
    D_rest, N_rest, speed = free_guide(track, base.guide, ring, ring.constant(v))
    pencil = joined([(placed.vehicle.pencil, placed.position, "") for placed in vehicles])
    length = Fraction(2) ** -base.guide.length
    every = [ring.constant(place) * length for place in pencil.places]
    places = tuple(sorted(set(every)))
    _require_order(places, over, units)
    S, B = _vehicle(pencil, base, ring)
    h = tuple(ring.constant(x) / base.guide.g for x in pencil.h)
    _require_contacts(h, over)
    return Family(
        problem=problem,
        over=dict(over),
        units=units,
        base=base,
        ring=ring,
        D_rest=D_rest,
        N_rest=N_rest,
        D=_moving(D_rest, speed),
        N=_moving(N_rest, speed),
        v=speed,
        places=places,
        index=tuple(places.index(place) for place in every),
        S=S,
        B=B,
        h=h,
    )


def require_ends(problem: Problem, over: Mapping[str, Interval]) -> None:
    """InputError where an end of a range is no value that the parameter may have."""
    for path, ends in over.items():
        for end in ends:
            if end or (path == "v" and end is not None):  # at 0 a mass or spring is left out: the limit is known
                problem.changed(path, end)


def _require_none_undone(problem: Problem, over: Mapping[str, Interval]) -> None:
    """Of two paths that set the same numbers the second decides alone: the range of the first would say nothing."""
    free = [path for path, (a, b) in over.items() if a < b]
    for path in free if len(over) > 1 else ():
        first, second = (_at_shares(problem, over, {path: share}) for share in (Fraction(1, 2), Fraction(3, 8)))
        if first == second:
            stated = "moves nothing, as a parameter that is given after it sets the same numbers"
            raise InputError(path, f"{stated}: give {path} after that one, or leave it out")


def _at_shares(problem: Problem, over: Mapping[str, Interval], shares: Mapping[str, Fraction]) -> Problem:
    """The problem at these shares of the ranges, in the middle of the others."""
    half = Fraction(1, 2)
    for path, a, b in factors_last([(path, a, b) for path, (a, b) in over.items()]):
        problem = problem.changed(path, a + shares.get(path, half) * (b - a))
    return problem


def factors_last(entries: list[tuple[str, Any, Any]]) -> list[tuple[str, Fraction | None, Any]]:
    return sorted(entries, key=lambda entry: entry[0].startswith("scale."))


def _require_contacts(h: tuple[Several, ...], over: Mapping[str, Interval]) -> None:
    for powers, _ in (term for x in h for term in x):
        for path, power in zip(over, powers, strict=True):
            if power < 0 and over[path][0] == 0:
                stated = "begins at 0, where a contact spring carries no force and its compliance has no limit"
                raise InputError(path, f"{stated}: begin above 0")


def _base(
    problem: Problem, over: Mapping[str, Interval], units: tuple[Fraction, ...]
) -> tuple[Reduced, tuple[Fraction, ...]]:
    """A problem inside the box, reduced, and where it is."""
    for share in _SHARES:
        point = [a + share * (b - a) for a, b in over.values()]
        inside = _at_shares(problem, over, dict.fromkeys(over, share))
        try:
            return reduce_problem(inside), tuple(x / u for x, u in zip(point, units, strict=True))
        except InputError:
            if share == _SHARES[-1]:
                raise
    raise InputError("over", "is empty: give a path and a range")


def _vehicle(pencil: Pencil, base: Reduced, ring: Ring) -> tuple[tuple[Any, Any, Any], Any]:
    """S and B of the felt motions, in the coordinates and scales of the base."""
    M, C, K, B = (
        [[ring.constant(x) for x in row] for row in rows] for rows in (pencil.M, pencil.C, pencil.K, pencil.B)
    )
    size, neutral, basis = base.bodies, base.neutral, base.parts.basis
    if basis is not None:
        columns = [[row[k] for row in basis] for k in range(len(basis))]
        M, C, K = (congruent(rows, columns, columns) for rows in (M, C, K))
        B = [image(zip(*B, strict=True), column) for column in columns]
        coupled = any(rows[i][j] for rows in (M, C, K) for i in range(size) for j in range(size, len(columns)))
        lost = any(any(row) for row in K[size - neutral : size]) or any(map(any, B[size - neutral : size]))
        if coupled or lost or any(map(any, B[size:])):
            stated = "change which motions of the vehicles their contacts feel"
            raise InputError("over", f"holds parameters that {stated}: fix one of them, or make equal bodies differ")
        M, C, K, B = ([row[:size] for row in rows[:size]] for rows in (M, C, K, B))
    guide, rate = base.guide, Fraction(2) ** -base.guide.time
    S = [conjugate(times(rows, guide.g * rate**k), base.scales) for k, rows in enumerate((K, C, M))]
    right = _constants(([x * Fraction(2) ** base.scales[i] for x in row] for i, row in enumerate(B)), ring)
    free = without_neutral(S, neutral)
    return (_constants(free[0], ring), _constants(free[1], ring), _constants(free[2], ring)), right


def _values(rows: Sequence[Sequence[Several]], x: Sequence[Fraction]) -> Rows:
    return tuple(tuple(c.at(x) for c in row) for row in rows)


def _constants(rows: Any, ring: Ring) -> tuple[tuple[Several, ...], ...]:
    return tuple(tuple(ring.constant(x) for x in row) for row in rows)


def _moving(a: FreePolynomial, v: Several) -> FreePolynomial:
    """With s = σ − vP."""
    return moving(a, v)  # type: ignore[arg-type,return-value]


def _require_order(places: tuple[Several, ...], over: Mapping[str, Interval], units: tuple[Fraction, ...]) -> None:
    """Neighbours in the order of the middle keep it at every corner, and so everywhere: places are multilinear."""
    ends = [(a / u, b / u) for (a, b), u in zip(over.values(), units, strict=True)]
    for a, b in pairwise(places):
        if any(max(e, default=0) > 1 for place in (a, b) for e, _ in place):
            raise InputError("over", "moves contacts along curves: give other paths")
        if any((b - a).at(corner) < 0 for corner in product(*ends)):
            raise InputError(
                "over", "lets contacts overtake each other: give ranges within which they keep their order"
            )
