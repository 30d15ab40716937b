"""Warnings, a sentence each, about what people get wrong in a problem that can be computed all the same.

They are guesses about what was meant and decide nothing. Each is a `Reason`: a code for programs, the sentence, its
numbers, what to do.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import islice, pairwise
from math import pi, sqrt
from typing import Any

from mpsolve.numbers.model import Model, quantities, shown
from mpsolve.numbers.spoken import beside, rounded, spoken
from mpsolve.outcome import Reason
from mpsolve.problem.case import Case
from mpsolve.problem.cases import Given, as_problem
from mpsolve.problem.plausible import implausible, on_rails
from mpsolve.problem.problem import Problem
from mpsolve.tracks.floating_ice import FloatingIce
from mpsolve.tracks.waveguide import Track
from mpsolve.vehicles.bogie import Bogie
from mpsolve.vehicles.coach import Coach
from mpsolve.vehicles.oscillator import Oscillator

_SOUND = 5100  # m/s in steel: √(EI/m) over it is the radius of gyration of a solid section
_THINNEST, _THICKEST = 5e-4, 3.0  # radii of gyration in m
FASTEST, _ON_ICE = 150, 40  # m/s
_IN_TITLE = re.compile(r"([0-9]+(?:\.[0-9]+)?) ?(?:km/h|kmh|kph)")
_ORDINARY = 85  # m/s, 306 km/h: what runs faster has a unit beside it, or is meant in km/h
_SHEARLESS = 0.2  # p times the radius of gyration up to which a beam without shear is right to some per cent
_SPACING = 0.6  # m, of sleepers
_CLOSE, _NEAR = Fraction(1, 200), Fraction(1, 10**6)  # contacts in m, in units of one's own: nothing runs so close
_Row = tuple[Fraction, list[Fraction], str]
_SMEARED = ("two-layer", "three-layer", "slab")


def warned(given: Given, frequencies: Sequence[float] = ()) -> tuple[Reason, ...]:
    """What is likely to be a mistake; empty where nothing is.

    frequencies: of the vibrations that were found, in Hz. A case in the paper's ratios has no units that could be
    wrong, and neither has a problem whose rail has the mass 1.
    """
    if isinstance(given, Case):
        return tuple(_of_ratios(given))
    problem = as_problem(given)
    found = list(_at_one_place(problem))
    track = problem.track
    if isinstance(track, Track):
        if getattr(track, "m", None) != 1:
            bending = [*_bending(track)]
            found += bending
            found += [one for one in implausible(problem) if not (bending and "track.EI" in one.numbers)]
            found += [*_velocity(problem), *_too_high(track, frequencies)]
        found += _overdamped(problem)
    return tuple(found)


def _of_ratios(case: Case) -> Iterator[Reason]:
    for j, (a, b) in enumerate(pairwise(case.positions), 1):
        if a == b:
            yield _one_place(f"positions[{j}] and positions[{j + 1}] are both {a.short()}, so the masses move as one")
        elif float(b) - float(a) < _NEAR:
            yield _nearly(f"positions[{j}] and positions[{j + 1}]", rounded(float(b) - float(a)))
    if case.eta_b > 1:
        stated = f"eta_b is {case.eta_b.short()}, above 1, the critical damping of the foundation"
        yield Reason("overdamped", stated, {"ratio": case.eta_b.short()}, "check it, if that is not meant")


def _at_one_place(problem: Problem) -> Iterator[Reason]:
    """The first two vehicles at one place, nearly so, or in each other, and the first with two such contacts."""
    in_metres = isinstance(problem.track, Track) and getattr(problem.track, "m", None) != 1
    near, unit = (_CLOSE, "m") if in_metres else (_NEAR, "")
    own = [(placed, sorted(placed.vehicle.pencil.places)) for placed in problem.vehicles]
    rows = sorted(((placed.position, places, placed.vehicle.name) for placed, places in own if places))
    yield from islice((said for behind, ahead in pairwise(rows) for said in _clash(behind, ahead, near, unit)), 1)
    least = ((min((b - a for a, b in pairwise(places)), default=near), name) for _, places, name in rows)
    twice = ((f"two contacts of one {name}", gap) for gap, name in least if gap < near)
    said = (_nearly(who, spoken(gap, unit)) if gap else _one_place(f"{who} stand at one place") for who, gap in twice)
    yield from islice(said, 1)


def _clash(behind: _Row, ahead: _Row, near: Fraction, unit: str) -> Iterator[Reason]:
    """Place of the middle, places of the contacts from there, and name of two vehicles."""
    (x, wheels, name), (y, others, other) = behind, ahead
    gap = y + others[0] - (x + wheels[-1])
    if x == y:
        yield _one_place(f"two vehicles, {name} and {other}, stand at one place, x = {shown(x)} m")
    elif 0 < gap < near:
        yield _nearly(f"the {name} at x = {shown(x)} {unit}".rstrip() + f" and the next {other}", spoken(gap, unit))
    elif gap <= 0:
        stated = f"the {name} at x = {shown(x)} m and the {other} at x = {shown(y)} m stand in each other"
        front, rear = shown(x + wheels[-1]), shown(y + others[0])
        stated = f"{stated}, as wheels of the one reach to {front} m and those of the other from {rear} m on"
        yield Reason("vehicles-overlap", stated, {}, "give them positions or a spacing further apart")


def _nearly(who: str, gap: str) -> Reason:
    return Reason(
        "contacts-nearly-at-one-place", f"{who} stand only {gap} apart", {"gap": gap}, "check their positions"
    )


def _one_place(stated: str) -> Reason:
    remedy = "give one of them another position, if that is not meant"
    return Reason("contacts-at-one-place", stated, {}, remedy)


def _bending(track: Any) -> Iterator[Reason]:
    radius = _radius(track)
    if radius is None or _THINNEST <= radius <= _THICKEST:
        return
    factor = 10**6 if radius < _THINNEST else Fraction(1, 10**6)
    thickness = spoken(radius * sqrt(12), "m", 2)
    stated = f"track.EI is {beside(track.EI, 'N m²')}, that of a solid steel section {thickness} high"
    meant = f'write EI = "{rounded(track.EI * factor / 10**6)} MN m²", if that is meant'
    yield Reason("bending-stiffness-unlikely", stated, {"EI": str(track.EI)}, meant)


def _velocity(problem: Problem) -> Iterator[Reason]:
    limit = _ON_ICE if isinstance(problem.track, FloatingIce) else FASTEST
    if problem.v > limit:
        stated = f"v is {rounded(problem.v)} m/s, which is {spoken(problem.v, 'm/s')}"
        written = 1000 % problem.v.denominator == 0  # else it is likely to have been given in km/h
        meant = (
            f'write v = "{rounded(problem.v)} km/h", if km/h is meant'
            if written
            else "check it, if that is not meant"
        )
        yield Reason("velocity-unlikely", stated, {"v": str(problem.v)}, meant)


def _overdamped(problem: Problem) -> Iterator[Reason]:
    """Dampers above 2√(k m) of the spring beside them and of the mass that it carries."""
    track: Any = problem.track
    mass = getattr(track, "m", Fraction(0))
    sleepers = getattr(track, "m_sleeper", Fraction(0))
    below = mass + getattr(track, "m_slab", Fraction(0))
    for key, spring, carried in (
        ("c", "k", below),
        ("c_pad", "k_pad", mass),
        ("c_ballast", "k_ballast", mass + sleepers),
        ("c_ground", "k_ground", mass + sleepers + getattr(track, "m_ballast", Fraction(0))),
    ):
        yield from _damper(track, f"track.{key}", key, spring, carried)
    seen = []
    for placed in problem.vehicles:
        if placed.vehicle not in seen:
            seen.append(placed.vehicle)
            yield from _suspension(placed.vehicle)


def _suspension(vehicle: Any) -> Iterator[Reason]:
    if isinstance(vehicle, Oscillator):
        yield from _damper(vehicle, "the vehicle's c", "c", "k", vehicle.body)
    if isinstance(vehicle, Bogie):
        yield from _damper(vehicle, "the bogie's c", "c", "k", (vehicle.frame + (vehicle.body or 0)) / 2)
        yield from _damper(vehicle, "the bogie's c2", "c2", "k2", vehicle.body or Fraction(0))
    if isinstance(vehicle, Coach):
        yield from _damper(vehicle, "the coach's c2", "c2", "k2", vehicle.body / 2)
        bogie = vehicle.bogie
        yield from _damper(bogie, "the bogie's c", "c", "k", (bogie.frame + vehicle.body / 2) / 2)


def _damper(model: Model, name: str, key: str, spring: str, carried: Fraction) -> Iterator[Reason]:
    c, k = getattr(model, key, None), getattr(model, spring, None)
    if not (isinstance(c, Fraction) and isinstance(k, Fraction) and k and carried) or c * c <= 4 * k * carried:
        return
    unit = quantities(type(model))[key].unit
    times = rounded(float(c) / (2 * sqrt(float(k * carried))), 2)
    stated = f"{name} is {beside(c, unit)}, {times} times the critical damping 2√({spring} · mass)"
    meant = f"either {key} is too large or {spring} too small: check both and their units, if that is not meant"
    yield Reason("overdamped", stated, {key: str(c), "times": times}, meant)


def _too_high(track: Any, frequencies: Sequence[float]) -> Iterator[Reason]:
    radius, highest = _radius(track), max(frequencies, default=0.0)
    if radius is None or hasattr(track, "S"):
        return
    bound = _SHEARLESS**2 * _SOUND / radius / (2 * pi)
    if highest > bound and not hasattr(track, "J"):
        stated = (
            f"a vibration has {rounded(highest, 3)} Hz, "
            f"and a rail without shear means little above some {rounded(bound, 2)} Hz"
        )
        yield Reason(
            "beam-without-shear",
            stated,
            {"frequency": f"{highest:.6g}"},
            "take timoshenko to see how much it matters",
        )
    pinned = pi / (2 * _SPACING**2) * sqrt(float(track.EI / track.m))
    if track.name in _SMEARED and highest > pinned:
        stated = (
            f"a vibration has {rounded(highest, 3)} Hz, and a track of smeared sleepers means little above the "
            f"pinned-pinned frequency, {rounded(pinned, 2)} Hz for sleepers {_SPACING} m apart"
        )
        yield Reason(
            "sleepers-smeared", stated, {"frequency": f"{highest:.6g}"}, "read such vibrations as rough ones"
        )


def _radius(track: Any) -> float | None:
    """√(EI/m) over the speed of sound in steel, or None for a track that has no EI."""
    EI, m = getattr(track, "EI", None), getattr(track, "m", None)
    return sqrt(float(EI / m)) / _SOUND if EI and m else None


class Title(str):
    """The title of a file. bare: its velocity has no unit, and none in the comment beside it."""

    bare: bool

    def __new__(cls, text: str, bare: bool = False) -> Title:
        title = super().__new__(cls, text)
        title.bare = bare
        return title


def titled(given: Given, title: str) -> tuple[Reason, ...]:
    """That the velocity is likely to be one in km/h, by the title or by the missing unit; empty where it is not."""
    if isinstance(given, Case):
        return ()
    return tuple(_likely(as_problem(given), title))


def _likely(problem: Problem, title: str) -> Iterator[Reason]:
    v = problem.v
    stated = f"v is {rounded(v)} m/s, which is {spoken(v, 'm/s')}"
    meant = f'write v = "{rounded(v)} km/h", if that is meant'
    said = [Fraction(number) for number in _IN_TITLE.findall(title)]
    if v and v in said and v * Fraction(18, 5) not in said:
        stated = f"{stated}, but the title says {rounded(v)} km/h"
        yield Reason("velocity-unlike-title", stated, {"v": str(v)}, meant)
    elif getattr(title, "bare", False) and _ORDINARY < v <= FASTEST and on_rails(problem):
        stated = f"v stands without a unit: {stated.removeprefix('v is ')}"
        yield Reason("velocity-without-unit", stated, {"v": str(v)}, f'{meant}, or v = "{rounded(v)} m/s"')
