"""Counts against the argument of Δ̂ in floats round the whole region, and regions that say what was proved."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.characteristic.disc_matrix import Arrays
from mpsolve.characteristic.path import discs, on_arc
from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Reduced, reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum import count as module
from mpsolve.spectrum.count import Count, count_roots
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region
from mpsolve.tracks.at_rest import lowest_cut
from mpsolve.tracks.waveguide import Polynomial, Waveguide
from mpsolve.vibration.image import Image
from mpsolve.vibration.poles import searched

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
WIRE = tracks.String(T=27000, m="1.07", k=500, c=2)


def pair(v: object, gap: object = 2) -> Reduced:
    return reduce_problem(Problem(BEAM, [vehicles.Mass(40), vehicles.Mass(40).at(gap)], v=v))


def count(reduced: Reduced, region: Region) -> Count:
    return count_roots(reduced, region, Effort(evaluations=100_000), lambda *_: None)


def winding(reduced: Reduced, corners: list[complex], up: int = 2, steps: int = 20000) -> float:
    """Turns of Δ̂ round a polygon in the problem's units, in floats."""
    unit = float(reduced.frequency_unit)
    parts = [np.linspace(a, b, steps)[:-1] for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]
    q = np.concatenate([*parts, parts[0][:1]]) / unit
    arrays = Arrays(reduced)
    _, G, good = arrays.evaluate(1j * q, np.zeros(len(q)), up)
    values = np.linalg.det(arrays.matrix(G, 1j * q).a)
    assert good.all()
    steps_taken = np.angle(values[1:] / values[:-1])
    assert np.abs(steps_taken).max() < 2.5
    return float(steps_taken.sum() / 2 / np.pi)


@pytest.mark.parametrize(("v", "number"), [("0.5", 0), ("1.3", 2)])
def test_half_planes_below_heights_and_rectangles(v: str, number: int) -> None:
    reduced = pair(v)
    whole = count(reduced, HalfPlane())
    assert whole.region == HalfPlane()
    assert whole.total == number == pytest.approx(winding(reduced, [-3 + 0j, -3 - 3j, 3 - 3j, 3 + 0j]))
    height = Fraction(3, 64)
    above = count(reduced, Below(height))
    assert isinstance(above.region, Below)
    reach = float(above.region.reach or 0)
    corners = [complex(x, y) for x, y in ((-reach, 3 / 64), (-reach, -3), (reach, -3), (reach, 3 / 64))]
    assert above.region.height == height
    assert above.total == pytest.approx(winding(reduced, corners))
    assert above.total > number
    box = Rectangle("1/8", 1, "-1/2", "1/32")
    right = count(reduced, box)
    assert right.region == box
    assert right.total == pytest.approx(winding(reduced, [0.125 - 0.5j, 1 - 0.5j, 1 + 1j / 32, 0.125 + 1j / 32]))
    assert right.total > 0


def test_a_half_disc_is_one_also_between_chord_and_arc() -> None:
    """Two masses on a wire that outruns its waves: the arc's pieces are on the circle, halved ones too."""
    reduced = reduce_problem(Problem(WIRE, [vehicles.Mass("8.5"), vehicles.Mass("8.5").at(1)], v=200))
    found = count(reduced, HalfPlane())
    assert isinstance(found.region, HalfPlane)
    assert found.region.radius == 8 * reduced.frequency_unit
    turn = found.paths[1]
    assert turn.arc == 8.0
    assert on_arc(turn).all()
    below = turn.points[turn.points.imag < 0]
    assert len(below) > 31
    assert np.abs(np.abs(below) - 8).max() < 1e-14 * 8
    assert found.total == 0


def test_without_the_theorem_a_half_disc_counts_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    reduced = pair("1.3")
    whole, above = count(reduced, HalfPlane()), count(reduced, Below(Fraction(1, 64)))
    monkeypatch.setattr(module, "plan_beyond", lambda *_: "none")
    part = count(reduced, HalfPlane(Fraction(3)))
    assert part.region == HalfPlane(Fraction(3))
    assert part.total == whole.total == 2
    other = count(reduced, Below(Fraction(1, 64), radius=Fraction(3)))
    assert other.region == Below(Fraction(1, 64), reach=Fraction(3), radius=Fraction(3))
    assert other.total == above.total


@pytest.mark.parametrize("region", [Rectangle(-9, 9, "-1/2", 1), Below(Fraction(1))])
def test_a_region_that_reaches_a_cut_is_refused(region: Region) -> None:
    assert lowest_cut(BEAM)[1] < 0.06
    with pytest.raises(InputError, match="cut"):
        count(pair("0.5"), region)


def test_a_rectangle_whose_sides_are_no_floats_is_counted_as_it_stands() -> None:
    """The discs of the pieces hold its exact sides, a rounding away."""
    box = Rectangle("1/8", 1, "-1/2", "1/33")
    found = count(pair("0.5"), box)
    assert found.region == box
    assert found.total == pytest.approx(winding(pair("0.5"), [0.125 - 0.5j, 1 - 0.5j, 1 + 1j / 33, 0.125 + 1j / 33]))
    m, r = discs(found.paths[1].points[:-1], found.paths[1].points[1:])
    at_top = found.paths[1].points[:-1].imag == found.paths[1].points.imag.max()
    unit = found_unit()
    for x in found.paths[1].points[:-1][at_top]:
        exact = (Fraction(x.real), Fraction(1, 33) / unit)
        inside = [(exact[0] - Fraction(c.imag)) ** 2 + (exact[1] + Fraction(c.real)) ** 2 <= Fraction(s) ** 2
                  for c, s in zip(m, r, strict=True)]  # fmt: skip
        assert any(inside)


def found_unit() -> Fraction:
    return pair("0.5").frequency_unit


def test_at_rest_nothing_is_counted_only_on_a_passive_track() -> None:
    assert count(pair(0), HalfPlane()).total == 0
    reduced = reduce_problem(Problem(active(), vehicles.Mass(1), v=0))
    found = count(reduced, HalfPlane())
    assert isinstance(found.region, HalfPlane)
    assert found.region.radius is not None
    assert "gives energy" in found.why


def active() -> Waveguide:
    """A stable track whose second field pumps energy: no theorem about passive vehicles holds on it."""
    one = Fraction(1)
    a: Polynomial = {(4, 0): one, (0, 0): one, (0, 1): one / 2, (0, 2): one}
    b: Polynomial = {(2, 0): -one, (0, 0): 2 * one, (0, 1): one / 20, (0, 2): one}
    return Waveguide(((a, {(0, 0): one}), ({(0, 0): -one / 15}, b)), 0)


def test_on_a_track_that_gives_energy_no_half_plane_is_claimed() -> None:
    reduced = reduce_problem(Problem(active(), vehicles.Mass(1), v="1/10"))
    found = count(reduced, HalfPlane())
    assert found.beyond is None
    assert isinstance(found.region, HalfPlane)
    assert found.region.radius is not None


def test_a_track_that_is_unstable_by_itself_is_refused() -> None:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1", N=5)
    reduced = reduce_problem(Problem(track, vehicles.Mass(1), v="0.5"))
    with pytest.raises(InputError, match="by itself"):
        count(reduced, HalfPlane())


def test_close_contacts_whose_exponents_are_all_small() -> None:
    """|Pξ| < 1/4 at all points: the exponential of a batch of small numbers."""
    close: Any = pair("0.5", "1/50")
    box = Rectangle("1/8", "1/4", "-1/8", "-1/64")
    found = count(close, box)
    assert found.total == pytest.approx(
        winding(close, [0.125 - 0.125j, 0.25 - 0.125j, 0.25 - 1j / 64, 0.125 - 1j / 64])
    )


@pytest.mark.parametrize("gap", ["0.01", "1e-4"])
def test_close_contacts_are_not_left_out(gap: str) -> None:
    """Two masses that all but touch are one of their sum: both far below and above where that grows."""
    for v, number in (("0.5", 0), ("1.3", 2)):
        close = count(pair(v, gap), HalfPlane())
        one = count(reduce_problem(Problem(BEAM, [vehicles.Mass(80)], v=v)), HalfPlane())
        assert close.region == one.region == HalfPlane()
        assert close.total == one.total == number


def test_the_height_is_counted_beyond_what_the_vehicle_does_by_itself() -> None:
    """Light pantographs on a light wire: their bodies swing faster than the wire, and decay more slowly.

    The truth is the motion after loads have come on, whose roots another search has (`vibration.search`).
    """
    wire = tracks.String(T="20e3", m="1.35", k=1, c=1)
    row = [vehicles.Oscillator(wheel=8, body=15, k=150, c=1).at(x) for x in (0, 20)]
    problem = Problem(wire, row, v=50)
    found = count(reduce_problem(problem), Below(Fraction("0.34")))
    slow = [-1j * pole.sigma * Image(problem, ()).rate for pole in searched(problem).poles]
    assert [q for q in slow if q.imag < 0.34 and q.real > 2.5]
    assert found.total == 2 * len(slow)
    assert isinstance(found.region, Below)
    assert found.region.reach is not None
    assert found.region.reach > max(q.real for q in slow)
