"""The strip up to the speed of waves: its receptances against explicit ones, and it never passes over a real root."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import Problem, certify, crossings, tracks, vehicles
from mpsolve.characteristic.boxes import Boxes
from mpsolve.numbers.quadratic import Quadratic, pairs
from mpsolve.problem.family import Family, family_of
from mpsolve.proof.effort import Effort
from mpsolve.proof.vanishing import nonzero, scalar
from mpsolve.ranges.crossed import speeds_within
from mpsolve.ranges.last_strip import LastMatrix, last_strip
from mpsolve.ranges.on_string import passive_beyond

PLACES = (0, 2, 5)


def wire(c: str = "0.1", count: int = 2, mass: object = 10) -> Problem:
    track = tracks.String(T=4, m=1, k=1, c=c)  # waves run at 2
    return Problem(track, [vehicles.Mass(mass).at(x) for x in PLACES[:count]], v=1)


def receptance(q: float, v: float, c: float, places: tuple[float, ...]) -> np.ndarray:
    """By the roots of the quadratic, in the problem's units."""
    s = 1j * q
    roots = np.roots([v * v - 4, -v * (2 * s + c), s * s + c * s + 1])
    slope = lambda P: 2 * (v * v - 4) * P - v * (2 * s + c)  # noqa: E731
    ahead, behind = sorted(roots, key=lambda P: P.real)
    of = lambda x: np.exp(ahead * x) / slope(ahead) if x >= 0 else -np.exp(behind * x) / slope(behind)  # noqa: E731
    return np.array([[of(a - b) for b in places] for a in places])


def family(problem: Problem, low: Fraction) -> Family:
    return family_of(problem, {"v": (low, Fraction(200001, 100000))})


@pytest.mark.parametrize("count", [2, 3])
def test_receptances_hold_the_explicit_ones_at_points_below_the_speed(count: int) -> None:
    """Over boxes that hold the speed, and next to it."""
    rng, boxes = np.random.default_rng(count), 60
    own = family(wire("0.5", count), Fraction(19, 10))
    unit, frequency = float(own.units[0]), float(own.frequency_unit)
    half = 10.0 ** rng.uniform(-5, -2, boxes)
    m = np.stack([rng.uniform(0.2, 2, boxes), (2 - rng.uniform(-0.5, 2, boxes) * half) / unit])
    r = np.stack([0.03 * rng.uniform(size=boxes), half / unit])
    found = LastMatrix(own).receptance(Boxes(m, r))
    assert found.good.sum() > 20
    scale = float(1 / own.base.guide.g)
    for _ in range(12):
        u = rng.uniform(-1, 1, (2, boxes))
        at = m + r * u
        weights = np.stack([np.ones(boxes), *u, *(u[i] * u[j] for i, j in pairs(2))])
        value = np.einsum("kb,kb...->b...", weights, found.G.k)
        for n in np.flatnonzero(found.good & (at[1] * unit < 2 - 1e-7)):
            G = scale * receptance(at[0, n] * frequency, at[1, n] * unit, 0.5, PLACES[:count])
            assert (np.abs(value[n] - G) <= found.G.e[n] + 1e-7 * abs(G[0, 0])).all()


def test_where_a_root_is_real_no_box_is_passed() -> None:
    """G less one of its eigenvalues at a point below the speed: no box round it may be proved to have no zero."""
    rng, own = np.random.default_rng(7), family(wire("0.5"), Fraction(19, 10))
    unit, frequency = float(own.units[0]), float(own.frequency_unit)
    matrix = LastMatrix(own)
    passed, scale = 0, float(1 / own.base.guide.g)
    for _ in range(200):
        half = 10.0 ** rng.uniform(-5, -2)
        m, r = np.array([[rng.uniform(0.2, 2)], [(2 - 0.7 * half) / unit]]), np.array([[0.02], [half / unit]])
        found = matrix.receptance(Boxes(m, r))
        q, v = m[0, 0] + r[0, 0] * rng.uniform(-1, 1), 2 - half * rng.uniform(1e-3, 1.6)
        values = np.linalg.eigvals(scale * receptance(q * frequency, v, 0.5, PLACES[:2]))
        for value in values:
            k = found.G.k.copy()
            k[0] -= value * np.eye(2)
            s = scalar(Quadratic(k, found.G.e, 2), found.good)
            assert not (s.good & nonzero(s.s).nonzero)[0]
        k = found.G.k.copy()
        k[0] -= 3 * abs(values).max() * np.eye(2)
        s = scalar(Quadratic(k, found.G.e, 2), found.good)
        passed += int((s.good & nonzero(s.s).nonzero)[0])
    assert passed > 100  # others are


@pytest.mark.parametrize(("c", "count"), [("0.1", 2), ("0.5", 3), ("5", 2), ("5", 3)])
def test_contacts_on_a_wire_are_passive_beyond_a_frequency(c: str, count: int) -> None:
    for low, high, up in ((Fraction(1, 10), Fraction(1), False), (Fraction(1), Fraction(200001, 100000), True)):
        own = family_of(wire(c, count), {"v": (low, high)})
        X = passive_beyond(own, up_to_waves=up)
        assert X is not None
        if up:
            assert passive_beyond(own) is None  # faster ones are in the range
        for v in np.linspace(float(low), min(float(high), 2 - 1e-6), 15):
            for q in X * float(own.frequency_unit) * np.geomspace(1.0001, 100, 25):
                G = receptance(q, v, float(c), PLACES[:count])
                assert np.linalg.eigvalsh((G - G.conj().T) * 0.5j).min() > 0


def test_on_a_wire_only_the_speed_of_its_waves_is_left_out() -> None:
    found = crossings(wire(), over={"v": (0, 3)}, check=False)
    assert found.proved, found.reason
    (left,) = found.left_out
    assert left.is_point
    assert found.counts == (0, 0)
    assert found.parts[0].over["v"][1] < 2 < found.parts[1].over["v"][0]
    for v in ("1.95", "1.999"):
        assert certify(wire().changed("v", v), region="unstable", check=False).unstable == 0


@pytest.mark.slow
def test_under_three_masses_a_strip_below_the_speed_takes_too_many_boxes() -> None:
    found = crossings(wire(count=3), over={"v": (0, 3)}, check=False)
    assert (found.proved, found.reason and found.reason.code) == (False, "left-out")
    assert [part.counts for part in found.parts] == [(0,), (0,)]
    (left,) = found.left_out
    assert 1.8 < left.start < 2
    assert left.end.overlaps(left.value)


def test_a_strip_without_a_theorem_of_high_frequencies_stays_open() -> None:
    beam = tracks.Timoshenko(EI="0.25", m=1, S=4, J="0.01", k=1, c="0.1")
    problem = Problem(beam, [vehicles.Mass(10).at(x) for x in (0, 2)], v=1)
    (speed, *_) = speeds_within(problem, {"v": (Fraction(0), Fraction(3))})
    assert last_strip(problem, (Fraction(19, 10), speed.beside(1)), speed.ball, Effort(evaluations=500)) is None
    (speed,) = speeds_within(wire(), {"v": (Fraction(0), Fraction(3))})
    assert last_strip(wire(), (Fraction(19, 10), speed.beside(1)), speed.ball, Effort(evaluations=2)) is None
