"""What a count presupposes is decided before it, and a track that gives energy closes no half-plane."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve.errors import InputError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.proof.effort import Effort
from mpsolve.spectrum.count import Count, count_roots
from mpsolve.spectrum.premises import open_at_rest, require_premises
from mpsolve.spectrum.regions import Below, HalfPlane, Rectangle, Region
from mpsolve.tracks import Rayleigh, String, Timoshenko
from mpsolve.tracks.waveguide import Polynomial, Waveguide
from mpsolve.vehicles import Mass, Vehicle

BEAM: Polynomial = {(4, 0): Fraction(1), (0, 2): Fraction(1), (0, 1): Fraction(1, 5), (0, 0): Fraction(4)}
HIDDEN: Polynomial = {(0, 2): Fraction(1), (0, 1): Fraction(1, 2), (0, 0): Fraction(2)}
GIVING = Waveguide(((BEAM, {(0, 0): Fraction(1, 2)}), ({(0, 0): Fraction(-1, 2)}, HIDDEN)))
"""Stable by itself, but at Ω² near 2 the hidden field feeds the beam."""
PLAIN = Waveguide(((BEAM,),))
WIRE = String(T=16, m=1, k=1, c="1/5")


def counted(problem: Problem, region: Region = HalfPlane()) -> Count:  # noqa: B008 — frozen
    return count_roots(reduce_problem(problem), region, Effort(evaluations=100_000), lambda *_: None)


def growing_at_rest(mass: float) -> complex:
    """The root with Im q < 0 of 1/G(q) = M q² for GIVING at v = 0, by the integral over p and Newton's method."""
    half = np.linspace(0, 1, 20001)[:-1]
    p = half / (1 - half)
    weight = 1 / (1 - half) ** 2 / len(half) / np.pi

    def f(q: complex) -> complex:
        s = 1j * q
        beam = p**4 + s * s + 0.2 * s + 4 + 0.25 / (s * s + 0.5 * s + 2)
        return 1 - mass * q * q * complex((weight / beam).sum())

    q = 1.33 - 0.01j
    for _ in range(60):
        q -= f(q) * 1e-6 / (f(q + 1e-6) - f(q))
    assert abs(f(q)) < 1e-9
    return q


def test_a_track_that_gives_energy_is_not_stable_because_nothing_moves() -> None:
    q = growing_at_rest(2.0)
    assert q.imag < -1e-3
    problem = Problem(GIVING, [Mass(2).at(0)], v=0)
    count = counted(problem)
    assert count.total == 2
    assert isinstance(count.region, HalfPlane)
    assert count.region.radius is not None
    assert "gives energy" in count.why


def test_a_track_that_gives_energy_closes_no_half_plane() -> None:
    count = counted(Problem(GIVING, [Mass(1).at(0)], v="0.3"))
    assert count.beyond is None
    assert "gives energy" in open_at_rest(reduce_problem(Problem(GIVING, [Mass(1).at(0)], v="0.3")))
    assert open_at_rest(reduce_problem(Problem(PLAIN, [Mass(1).at(0)], v="0.3"))) == ""


def test_a_rail_without_mass_closes_no_half_plane() -> None:
    rail = Waveguide((
        ({(4, 0): Fraction(1), (0, 0): Fraction(1)}, {(0, 0): Fraction(-1)}),
        ({(0, 0): Fraction(-1)}, {(0, 2): Fraction(1), (0, 1): Fraction(1), (0, 0): Fraction(2)}),
    ))  # fmt: skip
    assert "does not fall" in open_at_rest(reduce_problem(Problem(rail, [Mass(1).at(0)], v=0)))
    assert counted(Problem(rail, [Mass(1).at(0)], v=0)).why


@pytest.mark.parametrize(
    ("track", "v"),
    [
        (WIRE, 4),
        (Rayleigh(EI=4, m=1, J=1, k=1, c="1/5"), 2),
        (Timoshenko(EI=4, m=1, S=9, J=1, k=1, c="1/5"), 2),
        (Timoshenko(EI=4, m=1, S=9, J=1, k=1, c="1/5"), 3),
    ],
)
def test_a_wave_speed_is_refused(track: object, v: int) -> None:
    with pytest.raises(InputError, match="exactly a speed at which waves"):
        reduce_problem(Problem(track, [Mass(1).at(0)], v=v))
    near = reduce_problem(Problem(track, [Mass(1).at(0)], v=f"{v}.001"))
    require_premises(near, HalfPlane())


def test_a_region_ends_below_the_cuts() -> None:
    problem = Problem(PLAIN, [Mass(1).at(0)], v="0.3")
    with pytest.raises(InputError, match=r"below the lowest cut, at 0\.1"):
        counted(problem, Below(Fraction(1, 5)))
    with pytest.raises(InputError, match="cut"):
        counted(problem, Rectangle(-9, 9, "-0.5", "0.2"))
    touching = Problem(Timoshenko(EI=1, m=1, S=9, J=1, k=1, c="1/5"), [Mass(1).at(0)], v="0.3")
    with pytest.raises(InputError, match="come down to the real axis"):
        counted(touching, Rectangle(-1, 1, "-0.5", "0.01"))


def rigid(places: list[str], **more: object) -> Problem:
    forces = [["1"] * len(places)]
    return Problem(PLAIN, Vehicle(M=[["1"]], C=[["0"]], K=[["0"]], B=forces, places=places, **more).at(0), v="0.3")


def test_indeterminate_contacts_are_refused() -> None:
    with pytest.raises(InputError, match="share a force that nothing determines"):
        counted(rigid(["0", "0"]))
    for fine in (rigid(["0", "1"]), rigid(["0", "0"], k_contact="10")):
        require_premises(reduce_problem(fine), HalfPlane())
    require_premises(reduce_problem(Problem(PLAIN, [Mass(1).at(0), Mass(2).at(0)], v="0.3")), HalfPlane())
